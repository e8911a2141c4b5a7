#include "display/tube/preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "display/data_lines.h"
#include "display/phosphor.h"
#include "presets.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

struct Unit {
  std::string_view kind, name;
  double factor;
};
constexpr std::array kUnits{
    Unit{"mm", "mm", 1}, Unit{"mm", "cm", 10},   Unit{"mm", "m", 1000},  Unit{"mm", "in", 25.4},
    Unit{"Hz", "Hz", 1}, Unit{"Hz", "kHz", 1e3}, Unit{"Hz", "MHz", 1e6}, Unit{"deg", "deg", 1},
    Unit{"s", "s", 1},   Unit{"s", "ms", 1e-3},  Unit{"s", "us", 1e-6},  Unit{"", "%", 0.01},
    Unit{"", "", 1},
};

std::string units_of(std::string_view kind) {
  std::vector<std::string_view> names;
  for (const Unit& unit : kUnits) {
    if (unit.kind == kind) names.push_back(unit.name.empty() ? "no unit" : unit.name);
  }
  return fmt::format("{}", fmt::join(names, " or "));
}

/// A number with its unit, as one word or two: "0.2mm", "30 MHz", "85 %".
double parse_quantity(const std::string& text, const TubeNumber& number, const std::string& file,
                      const std::string& where) {
  const std::size_t digits = std::min(text.find_first_not_of("+-.0123456789eE"), text.size());
  const std::size_t unit_at = std::min(text.find_first_not_of(' ', digits), text.size());
  const double value =
      parse_number(text.substr(0, text.find_last_not_of(' ', digits - 1) + 1), file, where);
  const std::string_view unit = std::string_view(text).substr(unit_at);
  const auto found = std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) {
    return u.kind == number.unit && u.name == unit;
  });
  if (found == kUnits.end()) {
    throw_bad_input(
        fmt::format("{} is given in {}, not in \"{}\"", number.key, units_of(number.unit), unit),
        file, where);
  }
  const double in_units = value * found->factor;
  if (!(in_units >= number.least && in_units <= number.most)) {
    throw_bad_input(fmt::format("{} must lie from {:g} to {:g} {}", number.key, number.least,
                                number.most, number.unit),
                    file, where);
  }
  return in_units;
}

MaskKind parse_mask(const std::string& word, const std::string& file, const std::string& where) {
  if (word == "none") return MaskKind::kNone;
  if (word == "dots") return MaskKind::kDots;
  if (word == "grille") return MaskKind::kGrille;
  if (word == "slots") return MaskKind::kSlots;
  throw_bad_input("no mask \"" + word + "\"; there are none, dots, grille, slots", file, where);
}

void parse_tint(const std::string& value, TubeSettings& settings, const std::string& file,
                const std::string& where) {
  const Words parts = split_words(value);
  if (parts.size() != 3) throw_bad_input("glass.tint takes red, green and blue", file, where);
  for (std::size_t c = 0; c < 3; ++c) {
    const double share = parse_number(parts[c], file, where);
    if (!(share >= 0 && share <= 1)) {
      throw_bad_input("glass.tint takes shares from 0 to 1", file, where);
    }
    settings.glass.tint[c] = share;
  }
}

/// What the libraries below call misuse is bad data when a file says it.
template <typename Body>
void as_bad_input(const std::string& file, const std::string& where, const Body& body) {
  try {
    body();
  } catch (const Error& error) {
    throw_bad_input(error.what(), file, where);
  }
}

void set_key(TubeSettings& settings, const std::string& key, const std::string& value,
             const std::string& file, const std::string& where) {
  const auto numbers = tube_numbers();
  const auto number = std::find_if(numbers.begin(), numbers.end(),
                                   [&](const TubeNumber& n) { return n.key == key; });
  if (number != numbers.end()) {
    number->of(settings) = parse_quantity(value, *number, file, where);
  } else if (key == "mask.kind") {
    settings.mask.kind = parse_mask(value, file, where);
  } else if (key == "glass.tint") {
    parse_tint(value, settings, file, where);
  } else if (key == "mode") {
    as_bad_input(file, where, [&] { settings.mode = parse_mode(value); });
  } else if (key == "phosphor") {
    as_bad_input(file, where, [&] { settings.phosphor = find_phosphor(value).name; });
  } else {
    throw_bad_input("no setting is called \"" + key + "\"", file, where);
  }
}

std::string read_whole(const std::string& path) {
  constexpr std::streamsize kMost = 1 << 20;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw_bad_input("cannot be opened", path);
  std::string text(static_cast<std::size_t>(kMost), '\0');
  in.read(text.data(), kMost);
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad() || in.peek() != std::ifstream::traits_type::eof()) {
    throw_bad_input("is no preset: too long", path);
  }
  return text;
}

std::vector<TubePreset> built_in_presets() {
  std::vector<TubePreset> all;
  for (const auto& [name, text] : embedded_presets()) {
    all.push_back(parse_tube_preset(text, std::string(name), "preset " + std::string(name)));
  }
  return all;
}

}  // namespace

TubePreset parse_tube_preset(std::string_view text, const std::string& name,
                             const std::string& file) {
  TubePreset preset{name, {}, {}, {}};
  for_each_data_line(text, [&](const Words& words, const std::string& where) {
    if (words.size() < 2) throw_bad_input("expected a key and its value", file, where);
    const std::string value = fmt::format("{}", fmt::join(words.begin() + 1, words.end(), " "));
    if (words[0] == "note") {
      preset.note = value;
    } else {
      set_key(preset.settings, words[0], value, file, where);
      if (words[0] == "mode") preset.mode_name = value;
    }
  });
  if (preset.mode_name.empty()) throw_bad_input("has no \"mode\" line", file);
  return preset;
}

std::span<const TubePreset> tube_presets() {
  static const std::vector<TubePreset> all = built_in_presets();
  return all;
}

bool names_preset_file(std::string_view name) {
  return name.find('/') != std::string_view::npos || name.ends_with(".txt");
}

TubePreset find_tube_preset(const std::string& name) {
  std::string known;
  for (const TubePreset& preset : tube_presets()) {
    if (preset.name == name) return preset;
    known += ", " + preset.name;
  }
  if (names_preset_file(name)) {
    return parse_tube_preset(read_whole(name), name, name);
  }
  throw Error(
      ErrorKind::kUsage,
      fmt::format("no display is called \"{}\"; there are none{}, and files that end in .txt", name,
                  known),
      "--display");
}

void override_tube_setting(TubeSettings& settings, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    throw Error(ErrorKind::kUsage, fmt::format("\"{}\" is no KEY=VALUE", assignment), "--set");
  }
  try {
    set_key(settings, std::string(assignment.substr(0, equals)),
            std::string(assignment.substr(equals + 1)), "", "");
  } catch (const Error& error) {
    throw Error(ErrorKind::kUsage, error.what(), "--set");
  }
}

std::string tube_setting_help() {
  std::string help =
      "mode  a video mode\nphosphor  " + phosphor_names() +
      "\nmask.kind  none, dots, grille or slots\nglass.tint  RED GREEN BLUE, transmission\n";
  for (const TubeNumber& n : tube_numbers()) {
    help += fmt::format("{}{}{}  {}\n", n.key, n.unit.empty() ? "" : " ", n.unit, n.about);
  }
  return help;
}

}  // namespace kinescope
