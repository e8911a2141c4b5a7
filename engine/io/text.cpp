#include "engine/io/text.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace kinescope {
namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// A word of the file as a message shows it.
std::string quoted(std::string_view word) {
  return "\"" + std::string(word.substr(0, 24)) + (word.size() > 24 ? "...\"" : "\"");
}

}  // namespace

std::optional<double> parse_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  // As old C libraries of Windows print them: 1.#QNAN, -1.#IND, 1.#INF.
  if (word.find('#') != std::string_view::npos) return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size()) return std::nullopt;
  if (fault == std::errc::result_out_of_range) {
    // Too large or too small for a double: the sign of the exponent tells.
    const bool tiny = lower_case(word).find("e-") != std::string::npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (fault != std::errc()) return std::nullopt;
  return value;
}

float to_float(double value) {
  constexpr double kMax = std::numeric_limits<float>::max();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (value > kMax) return kInfinity;
  if (value < -kMax) return -kInfinity;
  return static_cast<float>(value);
}

std::string_view as_text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || is_line_end(c); }

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return lower;
}

std::string printable(std::string_view text) {
  std::string shown(text);
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
  }
  return shown;
}

TextReader::TextReader(const ModelFile& file, std::size_t offset, char comment)
    : file_(file), text_(as_text(file.bytes)), at_(offset), line_(1), comment_(comment) {
  line_ += static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + offset, '\n'));
}

void TextReader::skip_blanks() {
  while (at_ < text_.size() && is_space(text_[at_]) && !is_line_end(text_[at_])) ++at_;
  if (comment_ == '\0' || at_ == text_.size() || text_[at_] != comment_) return;
  while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
}

std::string_view TextReader::word_on_line() {
  skip_blanks();
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view TextReader::rest_of_line() {
  skip_blanks();
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
  std::string_view rest = text_.substr(begin, at_ - begin);
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  return rest;
}

bool TextReader::next_line() {
  while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
  if (at_ == text_.size()) return false;
  const bool pair = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
  at_ += pair ? 2 : 1;
  ++line_;
  return at_ < text_.size();
}

std::string_view TextReader::word() {
  for (;;) {
    const std::string_view found = word_on_line();
    if (!found.empty() || !next_line()) return found;
  }
}

double TextReader::number() { return number(word()); }

std::uint64_t TextReader::count(const char* what) { return count(word(), what); }

double TextReader::number(std::string_view word) const {
  if (word.empty()) fail("the file ends where a number should stand");
  const std::optional<double> value = parse_number(word);
  if (!value) fail("a number should stand here, not " + quoted(word));
  return *value;
}

std::uint64_t TextReader::count(std::string_view word, const char* what) const {
  if (word.empty()) fail(std::string("the file ends where ") + what + " should stand");
  std::uint64_t value = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (fault != std::errc() || end != word.data() + word.size()) {
    fail(std::string(what) + " should stand here, not " + quoted(word));
  }
  return value;
}

}  // namespace kinescope
