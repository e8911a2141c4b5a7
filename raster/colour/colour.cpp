#include "raster/colour/colour.h"

#include <cmath>

#include "raster/colour/srgb_table.h"

namespace kinescope {
namespace {

double encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double decoded(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

// NaN gives 0, since every comparison with it is false.
template <typename T>
T unit(T value) {
  return value > 0 ? (value < 1 ? value : T{1}) : T{0};
}

/// The smallest float that rounds to `code` or more.
float first_of_code(int code) {
  const auto reached = [code](float x) { return 255 * encoded(x) + 0.5 >= code; };
  float x = static_cast<float>(decoded((code - 0.5) / 255));
  while (reached(x)) x = std::nextafter(x, 0.0f);
  while (!reached(x)) x = std::nextafter(x, 2.0f);
  return x;
}

SrgbTable make_table() {
  SrgbTable table;
  int code = 0;
  float step = first_of_code(1);
  for (std::uint32_t i = 0; i < SrgbTable::kSize; ++i) {
    const std::uint32_t begin = SrgbTable::kFirstBits + (i << 16);
    std::uint32_t& entry = table.entries[i];
    entry = static_cast<std::uint32_t>(code) << 16;
    const std::uint32_t place = std::bit_cast<std::uint32_t>(step) - begin;
    if (code == 255 || place >= 0x10000u) continue;
    entry += 0x10000u - place;
    ++code;
    if (code < 255) step = first_of_code(code + 1);
  }
  return table;
}

std::uint8_t linear_code(float value) {
  return static_cast<std::uint8_t>(unit(value) * 255 + 0.5f);
}

std::uint16_t code16(float linear) {
  return static_cast<std::uint16_t>(encoded(unit<double>(linear)) * 65535 + 0.5);
}

}  // namespace

const SrgbTable& srgb_table() {
  static const SrgbTable table = make_table();
  return table;
}

float srgb_encode(float linear) { return static_cast<float>(encoded(unit<double>(linear))); }

float srgb_decode(float code) { return static_cast<float>(decoded(unit<double>(code))); }

Srgb8 encode_srgb8(LinearRgba colour) {
  const SrgbTable& table = srgb_table();
  return {table.code(colour.r), table.code(colour.g), table.code(colour.b), linear_code(colour.a)};
}

Srgb8 encode_srgb8(LinearRgb colour) {
  return encode_srgb8(LinearRgba{colour.r, colour.g, colour.b, 1});
}

Srgb16 encode_srgb16(LinearRgb colour) {
  return {code16(colour.r), code16(colour.g), code16(colour.b), 65535};
}

LinearRgba decode(Srgb8 colour) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values;
    for (int i = 0; i < 256; ++i)
      values[static_cast<std::size_t>(i)] = static_cast<float>(decoded(i / 255.0));
    return values;
  }();
  return {table[colour.r], table[colour.g], table[colour.b], static_cast<float>(colour.a) / 255};
}

}  // namespace kinescope
