// How a fragment meets what its samples show already: the depth test and the blending of colours.
#pragma once

#include <algorithm>
#include <cstdint>

#include "raster/colour/colour.h"

namespace kinescope {

/// Which fragments pass, by their depth against the one stored at the sample. A sample where no
/// depth was written lies behind every depth. The value is a set of bits: nearer, equal, farther.
enum class DepthTest : std::uint8_t {
  kNever = 0,
  kLess = 1,
  kEqual = 2,
  kLessEqual = 3,
  kGreater = 4,
  kNotEqual = 5,
  kGreaterEqual = 6,
  kAlways = 7,
};

constexpr bool passes(DepthTest test, float depth, float stored) {
  const int relation = depth < stored ? 1 : depth == stored ? 2 : 4;
  return (static_cast<int>(test) & relation) != 0;
}

/// What becomes of the colour below. All in linear light, a channel at a time. A shader's colour is
/// not premultiplied: its alpha tells how much of the fragment takes part, 0 nothing and 1 all.
/// Alpha is cut to [0, 1]; NaN counts as 0 in every channel.
enum class BlendMode : std::uint8_t {
  kOpaque,    ///< replaced, whatever alpha is, by the shader's colour as it is
  kAlpha,     ///< source-over: source * a + below * (1 - a); alpha: a + below * (1 - a)
  kAdditive,  ///< below + source * a; alpha stays
  kMultiply,  ///< below * (1 - a * (1 - source)); alpha stays
};

/// In which order fragments of one pixel are blended.
enum class BlendOrder : std::uint8_t {
  kSubmitted,  ///< as their triangles were submitted
  kByDepth,    ///< far to near at each sample, equal depths as submitted; after all other calls,
               ///< whatever the order of calls. Depth is tested against theirs and never written.
};

/// Beyond this much light either way a blended colour is cut, so that no sum of layers overflows.
inline constexpr float kMostLight = 0x1p64f;

/// The scalar law of blending, which every fast path equals bit by bit.
inline LinearRgba blended(BlendMode mode, const LinearRgba& source, const LinearRgba& below) {
  if (mode == BlendMode::kOpaque) return source;
  const auto cut = [](float v, float least, float most) {
    return v == v ? std::min(std::max(v, least), most) : 0.0f;
  };
  const float a = cut(source.a, 0.0f, 1.0f);
  const auto channel = [&](float s, float b) {
    s = cut(s, -kMostLight, kMostLight);
    if (mode == BlendMode::kAlpha) return s * a + b * (1.0f - a);
    if (mode == BlendMode::kAdditive) return b + s * a;
    return b * (1.0f - a * (1.0f - s));
  };
  return {channel(source.r, below.r), channel(source.g, below.g), channel(source.b, below.b),
          mode == BlendMode::kAlpha ? a + below.a * (1.0f - a) : below.a};
}

}  // namespace kinescope
