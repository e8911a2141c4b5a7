// The lines of an OBJ file, one at a time, as an input stream takes them.
#pragma once

#include <cstddef>
#include <functional>
#include <streambuf>
#include <string>
#include <string_view>

namespace kinescope {

/// UTF-16 text with a byte order mark, as UTF-8 (what is not ASCII becomes '?'); other text as it
/// is, without a mark.
std::string plain_text(std::string_view bytes);

/// Hands a line on only when it is asked for the next one, so that a parser's callbacks can ask for
/// the line at work. Joins lines that end with a backslash and drops space at the end.
class ObjLines : public std::streambuf {
 public:
  /// @param take  sees each line first and returns true to keep it from the parser
  ObjLines(std::string_view text, std::function<bool(std::string_view line)> take)
      : text_(text), take_(std::move(take)) {}

  std::size_t number() const { return number_; }  ///< of the current line, from 1
  /// The current line behind its first word.
  std::string_view arguments() const;

 protected:
  int_type underflow() override;

 private:
  std::string_view next_piece();

  std::string_view text_;
  std::function<bool(std::string_view)> take_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  std::size_t pieces_ = 0;
  std::string line_;
};

}  // namespace kinescope
