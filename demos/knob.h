// Knobs: what a demo lets its user turn, declared as data, so that the panel, the help, scripts and
// tests all read one list.
#pragma once

#include <string>
#include <vector>

#include "display/input.h"

namespace kinescope {

enum class KnobKind { kToggle, kChoice, kNumber };

/// One knob and its present value. Every turn of it is a key press, and so part of a demo's trace.
struct Knob {
  std::string name;  ///< "shading"
  std::string help;  ///< one line, without a full stop
  KnobKind kind = KnobKind::kToggle;
  double value = 0;                           ///< toggle: 0 or 1; choice: index; number: itself
  std::vector<std::string> keys;              ///< toggle: {flip}; choice: {next} or one a choice;
                                              ///< number: {down, up}
  std::vector<std::string> choices;           ///< names of a choice's values
  double minimum = 0, maximum = 1, step = 1;  ///< of a number; one with choices shows their names
  std::string unit;                           ///< of a number, empty if it has none

  Knob();
  // In knob.cpp: every demo would compile them again.
  Knob(const Knob&);
  Knob(Knob&&) noexcept;
  Knob& operator=(const Knob&);
  Knob& operator=(Knob&&) noexcept;
  ~Knob();

  bool on() const { return value != 0; }
  int index() const { return static_cast<int>(value); }
  /// The value in words: "on", "Phong", "3 px".
  std::string text() const;
  /// Turns if `key` is one of its own; while one is held, `repeated`, a number alone turns on.
  /// @return whether it was
  bool answer(const std::string& key, bool repeated = false);
  /// The key presses that lead from the present value to `target` (clamped to the range).
  std::vector<std::string> keys_to(double target) const;
};

Knob toggle_knob(std::string name, std::string key, bool on, std::string help);
Knob choice_knob(std::string name, std::vector<std::string> keys, std::vector<std::string> choices,
                 int index, std::string help);
Knob number_knob(std::string name, std::string down, std::string up, double minimum, double maximum,
                 double step, double value, std::string unit, std::string help);
/// A number that counts through named values, such as speeds.
Knob scale_knob(std::string name, std::string down, std::string up,
                std::vector<std::string> choices, int index, std::string help);

}  // namespace kinescope

extern template class std::vector<kinescope::Knob>;
