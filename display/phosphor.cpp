#include "display/phosphor.h"

#include <fmt/format.h>

#include <cmath>

#include "display/data_lines.h"
#include "phosphors_txt.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr const char* kDataFile = "display/data/phosphors.txt";

/// CIE 1931 chromaticity to linear sRGB at luminance 1. Source: IEC 61966-2-1, D65.
LinearRgb linear_of_xy(double x, double y) {
  const double X = x / y, Z = (1 - x - y) / y;
  return {static_cast<float>(3.2404542 * X - 1.5371385 - 0.4985314 * Z),
          static_cast<float>(-0.9692660 * X + 1.8760108 + 0.0415560 * Z),
          static_cast<float>(0.0556434 * X - 0.2040259 + 1.0572252 * Z)};
}

std::string join(const Words& words, std::size_t first) {
  return fmt::format(
      "{}", fmt::join(words.begin() + static_cast<std::ptrdiff_t>(first), words.end(), " "));
}

/// Lines "phosphor NAME x y", then its "term SHARE TAU_us" lines and "source TEXT" lines.
std::vector<Phosphor> parse_phosphors() {
  std::vector<Phosphor> all;
  for_each_data_line(embedded::phosphors_txt(), [&](const Words& words, const std::string& where) {
    const auto number = [&](std::size_t i) {
      if (i >= words.size()) throw_bad_input("a number is missing", kDataFile, where);
      return parse_number(words[i], kDataFile, where);
    };
    if (words[0] == "phosphor" && words.size() == 4) {
      all.push_back({words[1], linear_of_xy(number(2), number(3)), {}, {}});
    } else if (words[0] == "term" && !all.empty()) {
      all.back().terms.push_back({number(1), microseconds(number(2))});
    } else if (words[0] == "source" && !all.empty()) {
      std::string& source = all.back().source;
      source += (source.empty() ? "" : " ") + join(words, 1);
    } else {
      throw_bad_input("expected phosphor, term or source", kDataFile, where);
    }
  });
  for (const Phosphor& phosphor : all) {
    double sum = 0;
    for (const DecayTerm& term : phosphor.terms) {
      if (!(term.share > 0) || !(term.tau.count() > 0)) {
        throw_bad_input(phosphor.name + " has a term that is not positive", kDataFile);
      }
      sum += term.share;
    }
    if (std::abs(sum - 1) > 1e-6) throw_bad_input(phosphor.name + "'s shares miss 1", kDataFile);
  }
  return all;
}

}  // namespace

double Phosphor::remaining(Seconds t) const {
  double left = 0;
  for (const DecayTerm& term : terms) left += term.share * std::exp(-(t / term.tau));
  return left;
}

// Steady excitation deposits at the rate at which light leaves, so each term shines with its share.
double Phosphor::decay_after_steady(Seconds t) const { return remaining(t); }

std::span<const Phosphor> phosphors() {
  static const std::vector<Phosphor> all = parse_phosphors();
  return all;
}

const Phosphor& find_phosphor(std::string_view name) {
  std::string known;
  for (const Phosphor& phosphor : phosphors()) {
    if (phosphor.name == name) return phosphor;
    known += (known.empty() ? "" : ", ") + phosphor.name;
  }
  throw Error(ErrorKind::kUsage, fmt::format("no phosphor \"{}\"; there are {}", name, known));
}

}  // namespace kinescope
