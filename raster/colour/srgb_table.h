// An exact table of the sRGB curve to 8 bits, indexed by the bits of a float: what the scalar and
// the SIMD encoders share.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace kinescope {

/// Codes of all floats in [2^-13, 1]: below lies code 0. A bucket is 1/128 of an octave; the curve
/// is flat enough that no bucket holds more than one step from a code to the next. An entry is
/// (code << 16) + 65536 - place of the step among the bucket's 65536 floats, so that adding a
/// float's low 16 bits carries into the code exactly from the step on.
struct SrgbTable {
  static constexpr float kFirst = 0x1p-13f;
  static constexpr std::uint32_t kFirstBits = std::bit_cast<std::uint32_t>(kFirst);
  static constexpr int kSize = 13 * 128 + 1;
  std::array<std::uint32_t, kSize> entries;

  /// The rounded code of a float; clamps, NaN gives 0.
  std::uint8_t code(float linear) const {
    const float low = linear > kFirst ? linear : kFirst;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(low < 1.0f ? low : 1.0f);
    return static_cast<std::uint8_t>((entries[(bits - kFirstBits) >> 16] + (bits & 0xffffu)) >> 16);
  }
};

/// The table, made once.
const SrgbTable& srgb_table();

}  // namespace kinescope
