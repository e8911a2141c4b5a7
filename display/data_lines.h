// The words of a data file's lines: comments from '#', blank lines skipped.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace kinescope {

using Words = std::vector<std::string>;

/// Splits at blanks.
Words split_words(std::string_view line);

/// Calls `body` with each line's words and its place ("line 12").
void for_each_data_line(std::string_view text,
                        const std::function<void(const Words&, const std::string& where)>& body);

/// The whole word as a number. @throws Error (bad input) naming the file and place
double parse_number(const std::string& word, const std::string& file, const std::string& where);

/// Word `i` of a line as a number from `least` to `most`. @throws Error (bad input) naming file and
/// place
double bounded_number(const Words& words, std::size_t i, double least, double most,
                      const std::string& file, const std::string& where);

/// The words after the first, with a blank between.
std::string words_after_key(const Words& words);

/// A key of a data file that takes one number.
template <typename Target>
struct NumberKey {
  std::string_view key;
  double least, most;
  void (*set)(Target&, double);
};

/// Sets the number that a line's first word names. @return false if no key is so named
template <typename Target, std::size_t N>
bool set_number(const std::array<NumberKey<Target>, N>& keys, Target& target, const Words& words,
                const std::string& file, const std::string& where) {
  for (const NumberKey<Target>& key : keys) {
    if (key.key != words[0]) continue;
    key.set(target, bounded_number(words, 1, key.least, key.most, file, where));
    return true;
  }
  return false;
}

}  // namespace kinescope
