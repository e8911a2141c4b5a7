#include "demos/numbered_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>

#include "raster/base/error.h"

namespace kinescope {
namespace {

namespace fs = std::filesystem;

/// A pattern's text before its last run of #, the run's length, and the text behind.
struct Parts {
  std::string before;
  std::size_t digits = 0;
  std::string behind;
};

Parts split(const std::string& pattern) {
  const std::size_t end = pattern.find_last_of('#');
  if (end == std::string::npos) return {pattern, 0, {}};
  std::size_t begin = end;
  while (begin > 0 && pattern[begin - 1] == '#') --begin;
  return {pattern.substr(0, begin), end - begin + 1, pattern.substr(end + 1)};
}

std::string name_of(const Parts& parts, int number) {
  if (parts.digits == 0) return parts.before;
  return parts.before + fmt::format("{:0{}}", number, parts.digits) + parts.behind;
}

/// The number in a file's name, if the name is exactly what the pattern makes of that number.
std::optional<int> number_in(const std::string& name, const Parts& parts) {
  if (name.size() < parts.before.size() + parts.behind.size()) return std::nullopt;
  const char* const begin = name.data() + parts.before.size();
  const char* const end = name.data() + name.size() - parts.behind.size();
  int number = 0;
  const auto [stop, fault] = std::from_chars(begin, end, number);
  if (fault != std::errc() || stop != end || number < 0) return std::nullopt;
  if (name_of(parts, number) != name) return std::nullopt;
  return number;
}

}  // namespace

std::string numbered_name(const std::string& pattern, int number) {
  return name_of(split(pattern), number);
}

std::vector<std::string> numbered_files(const std::string& pattern) {
  const fs::path folder = fs::path(pattern).parent_path();
  const Parts parts = split(fs::path(pattern).filename().string());
  std::vector<int> numbers;
  std::error_code fault;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, fault), end; !fault && at != end;
       at.increment(fault)) {
    if (const auto number = number_in(at->path().filename().string(), parts)) {
      numbers.push_back(*number);
    }
  }
  if (fault) throw_bad_input("cannot be read: " + fault.message(), pattern);
  if (numbers.empty()) throw_bad_input("there are no pictures with such names", pattern);
  std::sort(numbers.begin(), numbers.end());
  std::vector<std::string> files;
  for (const int number : numbers) {
    const int expected = numbers.front() + static_cast<int>(files.size());
    if (number != expected) {
      throw_bad_input(
          "missing, though the sequence goes on to " + numbered_name(pattern, numbers.back()),
          numbered_name(pattern, expected));
    }
    files.push_back(numbered_name(pattern, number));
  }
  return files;
}

}  // namespace kinescope
