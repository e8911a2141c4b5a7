#include "display/vector/input/svg_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace kinescope {
namespace {

constexpr std::string_view kSpaces = " \t\r\n\f";

struct Unit {
  std::string_view name;
  float pixels;
};
/// CSS pixels: 96 an inch. em and ex with the usual 16 pixels.
constexpr std::array<Unit, 9> kUnits{{{"px", 1},
                                      {"pt", 96.0f / 72},
                                      {"pc", 16},
                                      {"mm", 96 / 25.4f},
                                      {"cm", 96 / 2.54f},
                                      {"in", 96},
                                      {"em", 16},
                                      {"ex", 8},
                                      {"", 1}}};

glm::mat3x2 matrix_of(std::string_view name, const std::vector<float>& n) {
  const auto at = [&](std::size_t i, float otherwise) { return i < n.size() ? n[i] : otherwise; };
  const auto radians = [&](std::size_t i) { return at(i, 0) * std::numbers::pi_v<float> / 180; };
  if (name == "matrix" && n.size() >= 6) return {n[0], n[1], n[2], n[3], n[4], n[5]};
  if (name == "translate") return {1, 0, 0, 1, at(0, 0), at(1, 0)};
  if (name == "scale") return {at(0, 1), 0, 0, at(1, at(0, 1)), 0, 0};
  if (name == "skewX") return {1, 0, std::tan(radians(0)), 1, 0, 0};
  if (name == "skewY") return {1, std::tan(radians(0)), 0, 1, 0, 0};
  if (name == "rotate") {
    const float c = std::cos(radians(0)), s = std::sin(radians(0)), x = at(1, 0), y = at(2, 0);
    return {c, s, -s, c, x - c * x + s * y, y - s * x - c * y};
  }
  return {1, 0, 0, 1, 0, 0};
}

std::optional<Srgb8> hexadecimal(std::string_view digits) {
  unsigned value = 0;
  const auto end = digits.data() + digits.size();
  if (std::from_chars(digits.data(), end, value, 16).ptr != end) return std::nullopt;
  const auto byte = [](unsigned v) { return static_cast<std::uint8_t>(v & 255); };
  if (digits.size() == 3) {
    return Srgb8{byte((value >> 8 & 15) * 17), byte((value >> 4 & 15) * 17),
                 byte((value & 15) * 17)};
  }
  if (digits.size() == 6) return Srgb8{byte(value >> 16), byte(value >> 8), byte(value)};
  return std::nullopt;
}

constexpr std::array<std::pair<std::string_view, Srgb8>, 18> kNames{{
    {"black", {0, 0, 0}},
    {"silver", {192, 192, 192}},
    {"gray", {128, 128, 128}},
    {"grey", {128, 128, 128}},
    {"white", {255, 255, 255}},
    {"maroon", {128, 0, 0}},
    {"red", {255, 0, 0}},
    {"purple", {128, 0, 128}},
    {"fuchsia", {255, 0, 255}},
    {"green", {0, 128, 0}},
    {"lime", {0, 255, 0}},
    {"olive", {128, 128, 0}},
    {"yellow", {255, 255, 0}},
    {"navy", {0, 0, 128}},
    {"blue", {0, 0, 255}},
    {"teal", {0, 128, 128}},
    {"aqua", {0, 255, 255}},
    {"orange", {255, 165, 0}},
}};

}  // namespace

std::string_view svg_trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kSpaces);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpaces) - begin + 1);
}

std::vector<float> svg_numbers(std::string_view text) {
  std::vector<float> numbers;
  for (;;) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n\f,");
    if (begin == std::string_view::npos) return numbers;
    text.remove_prefix(begin + (text[begin] == '+'));
    float value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || !std::isfinite(value)) return numbers;
    numbers.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()));
  }
}

std::optional<float> svg_length(std::string_view text, float whole) {
  text = svg_trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  float value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
  const std::string_view unit(result.ptr,
                              static_cast<std::size_t>(text.data() + text.size() - result.ptr));
  if (unit == "%") return value / 100 * whole;
  for (const Unit& known : kUnits) {
    if (unit == known.name) return value * known.pixels;
  }
  return std::nullopt;
}

glm::mat3x2 then(const glm::mat3x2& a, const glm::mat3x2& b) {
  const auto turned = [&](glm::vec2 v) { return v.x * a[0] + v.y * a[1]; };
  return {turned(b[0]), turned(b[1]), turned(b[2]) + a[2]};
}

glm::mat3x2 svg_transform(std::string_view text) {
  glm::mat3x2 all{1, 0, 0, 1, 0, 0};
  for (;;) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n\f,");
    if (begin == std::string_view::npos) return all;
    text.remove_prefix(begin);
    const std::size_t open = text.find('('), close = text.find(')');
    if (close == std::string_view::npos || open > close) return all;
    const std::vector<float> numbers = svg_numbers(text.substr(open + 1, close - open - 1));
    all = then(all, matrix_of(svg_trimmed(text.substr(0, open)), numbers));
    text.remove_prefix(close + 1);
  }
}

std::optional<Srgb8> svg_colour(std::string_view text) {
  text = svg_trimmed(text);
  if (text == "none" || text == "transparent") return std::nullopt;
  constexpr Srgb8 kUnknown{255, 255, 255};
  if (text.starts_with('#')) return hexadecimal(text.substr(1)).value_or(kUnknown);
  if (text.starts_with("rgb")) {
    const std::size_t open = text.find('(');
    if (open == std::string_view::npos) return kUnknown;
    const bool percent = text.find('%') != std::string_view::npos;
    std::vector<float> numbers;
    for (std::size_t at = open + 1; at < text.size() && numbers.size() < 3;) {
      const std::vector<float> one =
          svg_numbers(text.substr(at, text.find_first_of("%),", at) - at));
      numbers.push_back(one.empty() ? 0 : one[0] * (percent ? 2.55f : 1.0f));
      at = text.find(',', at);
      if (at != std::string_view::npos) ++at;
    }
    numbers.resize(3);
    const auto byte = [](float v) {
      return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0f, 255.0f)));
    };
    return Srgb8{byte(numbers[0]), byte(numbers[1]), byte(numbers[2])};
  }
  const auto* const found = std::find_if(kNames.begin(), kNames.end(),
                                         [&](const auto& entry) { return entry.first == text; });
  return found == kNames.end() ? kUnknown : found->second;
}

}  // namespace kinescope
