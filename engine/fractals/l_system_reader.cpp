#include <charconv>
#include <cmath>

#include "engine/fractals/l_system.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string without_blanks(std::string_view text) {
  std::string kept;
  for (const char c : text) {
    if (c != ' ' && c != '\t') kept += c;
  }
  return kept;
}

struct LineReader {
  LSystem system;
  std::string file, where;
  bool has_axiom = false;

  [[noreturn]] void refuse(const std::string& what) const { throw_bad_input(what, file, where); }

  double number(std::string_view text) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
      refuse("a number belongs here");
    }
    return value;
  }

  void rule(std::string_view line, std::size_t arrow) {
    const std::string symbol = without_blanks(line.substr(0, arrow));
    if (symbol.size() != 1) refuse("a rule begins with one symbol");
    if (!system.rules.emplace(symbol[0], without_blanks(line.substr(arrow + 2))).second) {
      refuse("a second rule for one symbol");
    }
  }

  void read(std::string_view line) {
    if (const auto arrow = line.find("->"); arrow != std::string_view::npos) {
      return rule(line, arrow);
    }
    const auto gap = line.find_first_of(" \t");
    const std::string_view word = line.substr(0, gap);
    const std::string_view rest =
        gap == std::string_view::npos ? std::string_view{} : trimmed(line.substr(gap));
    if (word == "name") {
      system.name = rest;
    } else if (word == "axiom") {
      system.axiom = without_blanks(rest);
      has_axiom = true;
    } else if (word == "angle") {
      system.angle_deg = number(rest);
    } else if (word == "start") {
      system.start_deg = number(rest);
    } else if (word == "ratio") {
      system.length_ratio = number(rest);
    } else {
      refuse("neither name, axiom, angle, start, ratio nor a rule");
    }
  }
};

}  // namespace

LSystem read_l_system(std::string_view text, const std::string& file) {
  LineReader reader;
  reader.file = file;
  int number = 0;
  while (!text.empty()) {
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    reader.where = "line " + std::to_string(++number);
    line = trimmed(line.substr(0, line.find('#')));
    if (!line.empty()) reader.read(line);
  }
  reader.where.clear();
  if (!reader.has_axiom) reader.refuse("an L-system needs an axiom");
  return reader.system;
}

}  // namespace kinescope
