// Words and numbers of a text format, with the line they stand in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/io/reader.h"

namespace kinescope {

/// A decimal number, "nan" and "inf" among them; too large becomes infinite. All of `word` or none.
std::optional<double> parse_number(std::string_view word);

/// The nearest float; infinite beyond the largest.
float to_float(double value);

std::string_view as_text(std::span<const std::uint8_t> bytes);
bool is_space(char c);
std::string lower_case(std::string_view text);

/// What a file says as a message may repeat it: control characters become '?'.
std::string printable(std::string_view text);

/// Takes the words of a file one after another. Lines end with \n, \r or \r\n.
class TextReader {
 public:
  /// @param comment  what begins a comment that runs to the end of its line; 0: nothing does
  TextReader(const ModelFile& file, std::size_t offset, char comment = '\0');

  std::string_view word();          ///< the next word, on whatever line; empty at the end
  std::string_view word_on_line();  ///< the next word of this line; empty at its end
  std::string_view rest_of_line();  ///< what is left of this line, without space around
  bool next_line();                 ///< goes past the end of this line; false at the file's end

  /// The next word as a number. @throws Error naming the line
  double number();
  std::uint64_t count(const char* what);
  /// The same for a word taken already.
  double number(std::string_view word) const;
  std::uint64_t count(std::string_view word, const char* what) const;

  std::size_t offset() const { return at_; }
  std::size_t remaining() const { return text_.size() - at_; }
  std::string where() const { return "line " + std::to_string(line_); }
  [[noreturn]] void fail(const std::string& what) const { file_.fail(what, where()); }

 private:
  void skip_blanks();  ///< and a comment, but no line end

  const ModelFile& file_;
  std::string_view text_;
  std::size_t at_;
  std::size_t line_;
  char comment_;
};

}  // namespace kinescope
