// Raster operations: what a window system lays on its screen, bit by bit with what is there.
// Source: D. H. H. Ingalls, "The Smalltalk graphics kernel", Byte, August 1981 (BitBlt).
#pragma once

#include <algorithm>

#include "raster/image/image.h"
#include "raster/pixel_rect.h"

namespace kinescope {

/// A function of a bit of the source and one of the destination: bit 2s + d of the number is what
/// becomes of them. These are the usual ones; all sixteen are valid.
enum class RasterOp : std::uint8_t {
  kClear = 0b0000,
  kNor = 0b0001,
  kErase = 0b0010,  ///< destination and not source
  kNotCopy = 0b0011,
  kInvert = 0b0101,  ///< of the destination, whatever the source
  kXor = 0b0110,     ///< twice leaves things as they were
  kAnd = 0b1000,
  kCopy = 0b1100,
  kOr = 0b1110,
  kSet = 0b1111,
};

constexpr std::uint8_t apply(RasterOp op, std::uint8_t source, std::uint8_t destination) {
  const auto bits = static_cast<unsigned>(op);
  const unsigned s = source, d = destination;
  unsigned result = 0;
  if (bits & 1u) result |= ~s & ~d;
  if (bits & 2u) result |= ~s & d;
  if (bits & 4u) result |= s & ~d;
  if (bits & 8u) result |= s & d;
  return static_cast<std::uint8_t>(result);
}

/// Each channel's bits; alpha is the destination's.
constexpr Srgb8 apply(RasterOp op, Srgb8 source, Srgb8 destination) {
  return {apply(op, source.r, destination.r), apply(op, source.g, destination.g),
          apply(op, source.b, destination.b), destination.a};
}

/// A rectangle of one colour; what lies outside the picture is left out.
inline void raster_fill(Image<Srgb8>& picture, const PixelRect& rect, Srgb8 colour, RasterOp op) {
  for (int y = std::max(rect.y0, 0); y < std::min(rect.y1, picture.height()); ++y) {
    for (int x = std::max(rect.x0, 0); x < std::min(rect.x1, picture.width()); ++x) {
      picture.at(x, y) = apply(op, colour, picture.at(x, y));
    }
  }
}

/// Lays a part of one picture over another, or over itself: rows and pixels go in the order in
/// which none is overwritten before it is read.
inline void bit_blt(Image<Srgb8>& to, int x, int y, const Image<Srgb8>& from, PixelRect part,
                    RasterOp op) {
  const int dx = x - part.x0, dy = y - part.y0;
  part.x0 = std::max({part.x0, 0, -dx});
  part.y0 = std::max({part.y0, 0, -dy});
  part.x1 = std::min({part.x1, from.width(), to.width() - dx});
  part.y1 = std::min({part.y1, from.height(), to.height() - dy});
  const bool down = dy <= 0, right = dx <= 0;
  for (int i = 0; i < part.y1 - part.y0; ++i) {
    const int row = down ? part.y0 + i : part.y1 - 1 - i;
    for (int j = 0; j < part.x1 - part.x0; ++j) {
      const int column = right ? part.x0 + j : part.x1 - 1 - j;
      Srgb8& below = to.at(column + dx, row + dy);
      below = apply(op, from.at(column, row), below);
    }
  }
}

}  // namespace kinescope
