#include "display/vector/input/hpgl_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace kinescope {
namespace {

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
char capital(char c) { return c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_number_start(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; }
bool is_separator(char c) {
  return c == ' ' || c == ',' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

}  // namespace

bool HpglScanner::next(HpglInstruction& instruction) {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '\x1b') {
      skip_escape();
      continue;
    }
    if (!is_letter(c)) {
      if (c != ';' && !is_separator(c)) ++passed_over_;
      ++at_;
      continue;
    }
    if (at_ + 1 == text_.size()) break;
    if (!is_letter(text_[at_ + 1])) {
      ++at_;
      ++passed_over_;
      continue;
    }
    instruction.place = at_;
    instruction.name = {capital(c), capital(text_[at_ + 1])};
    instruction.numbers.clear();
    instruction.text.clear();
    at_ += 2;
    read_text(instruction);
    return true;
  }
  at_ = text_.size();
  return false;
}

/// ESC . X with numbers to a colon (device control), or ESC and parameters to a capital (a
/// printer's).
void HpglScanner::skip_escape() {
  ++at_;
  if (at_ < text_.size() && text_[at_] == '.') {
    at_ += 2;
    const std::size_t begin = at_;
    while (at_ < text_.size() && ((text_[at_] >= '0' && text_[at_] <= '9') || text_[at_] == ';')) {
      ++at_;
    }
    if (at_ < text_.size() && text_[at_] == ':') {
      ++at_;
    } else {
      at_ = std::min(begin, text_.size());
    }
    return;
  }
  while (at_ < text_.size() && !(text_[at_] >= 'A' && text_[at_] <= 'Z')) ++at_;
  if (at_ < text_.size()) ++at_;
}

void HpglScanner::read_numbers(std::vector<double>& numbers) {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (is_separator(c)) {
      ++at_;
      continue;
    }
    if (!is_number_start(c)) return;
    const char* begin = text_.data() + at_ + (c == '+');
    double value = 0;
    const auto result =
        std::from_chars(begin, text_.data() + text_.size(), value, std::chars_format::fixed);
    if (result.ec != std::errc()) {
      ++at_;
      continue;
    }
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    numbers.push_back(value);
  }
}

std::string HpglScanner::up_to(char terminator) {
  const std::size_t end = std::min(text_.find(terminator, at_), text_.size());
  std::string text(text_.substr(at_, end - at_));
  at_ = std::min(end + 1, text_.size());
  return text;
}

void HpglScanner::read_text(HpglInstruction& instruction) {
  const std::string& name = instruction.name;
  if (name == "LB" || name == "BL") {
    instruction.text = up_to(terminator_);
  } else if (name == "CO") {
    const std::size_t quote = text_.find_first_not_of(' ', at_);
    const bool quoted = quote < text_.size() && text_[quote] == '"';
    if (quoted) at_ = quote + 1;
    instruction.text = up_to(quoted ? '"' : ';');
  } else if (name == "DT" || name == "SM") {
    // One character, whatever it is, unless the instruction ends here.
    if (at_ < text_.size() && text_[at_] != ';') instruction.text = text_[at_++];
    if (name == "DT") read_numbers(instruction.numbers);
  } else {
    read_numbers(instruction.numbers);
  }
}

}  // namespace kinescope
