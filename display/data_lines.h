// The words of a data file's lines: comments from '#', blank lines skipped.
#pragma once

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

}  // namespace kinescope
