#include "display/phosphor.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "display/data_lines.h"
#include "display/decay.h"
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

/// One type a "phosphor" line; the lines that follow add to it, as the file's head tells.
class PhosphorReader {
 public:
  std::vector<PhosphorType> read() {
    for_each_data_line(embedded::phosphors_txt(),
                       [&](const Words& words, const std::string& where) {
                         words_ = &words;
                         where_ = where;
                         read_line(words[0]);
                       });
    for (PhosphorType& type : types_) finish(type);
    return std::move(types_);
  }

 private:
  void read_line(const std::string& key) {
    if (key == "phosphor") {
      types_.push_back({});
      type().name = word(1);
    } else if (key == "about") {
      type().about = join(*words_, 1);
    } else if (key == "times") {
      for (std::size_t k = 0; k < 3; ++k) {
        if (word(k + 1) != "-") type().times[k] = microseconds(number(k + 1));
      }
    } else if (key == "excitation") {
      type().excitation = join(*words_, 1);
    } else if (key == "error") {
      type().fit_error = number(1) / 100;
    } else if (key == "luminance") {
      type().luminance = number(1);
    } else if (key == "source") {
      std::string& source = type().source;
      source += (source.empty() ? "" : " ") + join(*words_, 1);
    } else if (key == "layer") {
      const double share = words_->size() > 4 ? number(4) : 1;
      type().layers.push_back({word(1), linear_of_xy(number(2), number(3)), share, {}});
    } else if (key == "term") {
      if (type().layers.empty()) throw_bad_input("a term without a layer", kDataFile, where_);
      type().layers.back().terms.push_back({number(1), microseconds(number(2))});
    } else {
      throw_bad_input("\"" + key + "\" is not known", kDataFile, where_);
    }
  }

  PhosphorType& type() {
    if (types_.empty()) throw_bad_input("expected phosphor", kDataFile, where_);
    return types_.back();
  }
  const std::string& word(std::size_t i) const {
    if (i >= words_->size()) throw_bad_input("a word is missing", kDataFile, where_);
    return (*words_)[i];
  }
  double number(std::size_t i) const { return parse_number(word(i), kDataFile, where_); }

  static void finish(PhosphorType& type) {
    const auto fail = [&](const char* what) { throw_bad_input(type.name + what, kDataFile); };
    if (type.layers.empty() || type.layers.size() > 3) fail(" has not one to three layers");
    type.colour = type.layers.size() == 3;
    double luminance = 0;
    for (const Phosphor& layer : type.layers) {
      double sum = 0;
      for (const DecayTerm& term : layer.terms) {
        if (!(term.share > 0) || !(term.tau.count() > 0)) fail(" has a term that is not positive");
        sum += term.share;
      }
      if (std::abs(sum - 1) > 1e-6) fail("'s shares miss 1");
      luminance += layer.share;
    }
    if (!type.colour && std::abs(luminance - 1) > 1e-5) fail("'s layers miss 1");
  }

  std::vector<PhosphorType> types_;
  const Words* words_ = nullptr;
  std::string where_;
};

}  // namespace

double Phosphor::remaining(Seconds t) const {
  double left = 0;
  for (const DecayTerm& term : terms) left += term.share * std::exp(-(t / term.tau));
  return left;
}

double Phosphor::decay_after_pulse(Seconds length, Seconds t) const {
  double light = 0;
  for (const DecayTerm& term : terms) {
    light += term.share * one_minus_exp(length / term.tau) * std::exp(-(t / term.tau));
  }
  return light;
}

double PhosphorType::decay_after_steady(Seconds t) const {
  double light = 0, whole = 0;
  for (const Phosphor& layer : layers) {
    light += layer.share * layer.decay_after_steady(t);
    whole += layer.share;
  }
  return light / whole;
}

std::span<const PhosphorType> phosphors() {
  static const std::vector<PhosphorType> all = PhosphorReader().read();
  return all;
}

std::string phosphor_names() {
  std::string names;
  for (const PhosphorType& type : phosphors()) names += (names.empty() ? "" : ", ") + type.name;
  return names;
}

const PhosphorType& find_phosphor(std::string_view name) {
  for (const PhosphorType& type : phosphors()) {
    if (type.name == name) return type;
  }
  throw Error(ErrorKind::kUsage,
              fmt::format("no phosphor \"{}\"; there are {}", name, phosphor_names()));
}

}  // namespace kinescope
