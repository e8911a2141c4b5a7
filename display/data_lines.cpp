#include "display/data_lines.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "raster/base/error.h"

namespace kinescope {

Words split_words(std::string_view line) {
  std::istringstream stream{std::string(line)};
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

void for_each_data_line(std::string_view text,
                        const std::function<void(const Words&, const std::string& where)>& body) {
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const Words words = split_words(line.substr(0, line.find('#')));
    if (!words.empty()) body(words, "line " + std::to_string(number));
  }
}

double parse_number(const std::string& word, const std::string& file, const std::string& where) {
  double value = 0;
  const char* end = word.data() + word.size();
  const auto [rest, fault] = std::from_chars(word.data(), end, value);
  if (fault != std::errc() || rest != end || !std::isfinite(value)) {
    throw_bad_input("\"" + word + "\" is not a number", file, where);
  }
  return value;
}

}  // namespace kinescope
