#include "display/data_lines.h"

#include <fmt/format.h>

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

double bounded_number(const Words& words, std::size_t i, double least, double most,
                      const std::string& file, const std::string& where) {
  if (i >= words.size()) throw_bad_input(words[0] + " lacks a number", file, where);
  const double v = parse_number(words[i], file, where);
  if (!(v >= least && v <= most)) {
    throw_bad_input(fmt::format("{} must lie from {:g} to {:g}", words[0], least, most), file,
                    where);
  }
  return v;
}

std::string words_after_key(const Words& words) {
  return fmt::format("{}", fmt::join(words.begin() + 1, words.end(), " "));
}

}  // namespace kinescope
