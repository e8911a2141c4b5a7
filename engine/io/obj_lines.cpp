#include "engine/io/obj_lines.h"

#include "engine/io/text.h"

namespace kinescope {

std::string plain_text(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) return std::string(bytes.substr(3));
  const bool big = bytes.starts_with("\xfe\xff");
  if (!big && !bytes.starts_with("\xff\xfe")) return std::string(bytes);
  std::string text;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const char high = bytes[big ? i : i + 1];
    const char low = bytes[big ? i + 1 : i];
    text += high == 0 && low >= 0 ? low : '?';
  }
  return text;
}

std::string_view ObjLines::next_piece() {
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  std::string_view piece = text_.substr(at_, end - at_);
  at_ = std::min(end + 1, text_.size());
  ++pieces_;
  while (!piece.empty() && is_space(piece.back())) piece.remove_suffix(1);
  return piece;
}

ObjLines::int_type ObjLines::underflow() {
  for (;;) {
    if (at_ >= text_.size()) return traits_type::eof();
    number_ = pieces_ + 1;
    line_ = next_piece();
    while (line_.ends_with('\\') && at_ < text_.size()) {
      line_.back() = ' ';
      line_ += next_piece();
    }
    line_.erase(0, std::min(line_.find_first_not_of(" \t"), line_.size()));
    if (line_.empty() || line_[0] == '#') continue;
    // One space after the first word: parsers would take further ones for a part of a name.
    const std::string rest(arguments());
    line_.resize(std::min(line_.find_first_of(" \t"), line_.size()));
    if (!rest.empty()) line_ += ' ' + rest;
    if (take_(line_)) continue;
    line_ += '\n';
    setg(line_.data(), line_.data(), line_.data() + line_.size());
    return traits_type::to_int_type(line_[0]);
  }
}

std::string_view ObjLines::arguments() const {
  std::string_view rest(line_);
  rest.remove_prefix(std::min(rest.find_first_of(" \t"), rest.size()));
  while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  return rest;
}

}  // namespace kinescope
