// One line of text as a user types it, with a caret; and numbers read from it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "display/input.h"

namespace kinescope {

struct TextField {
  static constexpr std::size_t kLongest = 64;

  std::string text;
  std::size_t caret = 0;  ///< bytes before it; always between characters

  void set(std::string_view words);
  /// Text typed, the arrows, Home, End, Backspace and Delete. @return whether it took the event
  bool answer(const InputEvent& event);
};

/// Numbers apart by commas or spaces. @throws Error (bad input) saying what is wrong: not a number,
/// not finite, or not `count` of them
std::vector<double> typed_numbers(std::string_view text, std::size_t count);

}  // namespace kinescope
