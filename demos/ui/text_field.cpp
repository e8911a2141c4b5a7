#include "demos/ui/text_field.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "raster/base/error.h"

namespace kinescope {
namespace {

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

}  // namespace

void TextField::set(std::string_view words) {
  text = words;
  caret = text.size();
}

bool TextField::answer(const InputEvent& event) {
  const auto before = [&] {
    std::size_t at = caret;
    while (at > 0 && continues(text[--at])) {
    }
    return at;
  };
  const auto behind = [&] {
    std::size_t at = caret;
    while (at < text.size() && continues(text[++at])) {
    }
    return at;
  };
  if (event.kind == InputKind::kText) {
    if (text.size() + event.key.size() > kLongest) return true;
    text.insert(caret, event.key);
    caret += event.key.size();
    return true;
  }
  if (event.kind != InputKind::kKeyDown) return false;
  if (event.key == "Left") {
    caret = before();
  } else if (event.key == "Right") {
    caret = behind();
  } else if (event.key == "Home") {
    caret = 0;
  } else if (event.key == "End") {
    caret = text.size();
  } else if (event.key == "Backspace") {
    const std::size_t from = before();
    text.erase(from, caret - from);
    caret = from;
  } else if (event.key == "Delete") {
    text.erase(caret, behind() - caret);
  } else {
    return false;
  }
  return true;
}

std::vector<double> typed_numbers(std::string_view text, std::size_t count) {
  std::vector<double> numbers;
  const auto next = [&] {
    text.remove_prefix(std::min(text.find_first_not_of(" ,;()"), text.size()));
  };
  for (next(); !text.empty(); next()) {
    const std::string_view word = text.substr(0, text.find_first_of(" ,;()"));
    text.remove_prefix(word.size());
    double value{};
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault == std::errc::invalid_argument || end != word.data() + word.size()) {
      throw_bad_input(fmt::format("\"{}\" is not a number", word));
    }
    if (fault != std::errc() || !std::isfinite(value)) {
      throw_bad_input(fmt::format("\"{}\" is no finite number", word));
    }
    numbers.push_back(value);
  }
  if (numbers.size() != count) {
    throw_bad_input(fmt::format("{} number{} belong{} here, not {}", count, count == 1 ? "" : "s",
                                count == 1 ? "s" : "", numbers.size()));
  }
  return numbers;
}

}  // namespace kinescope
