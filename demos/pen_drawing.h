// What a light pen draws in a frame buffer, where it sees the beam.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "display/frame_buffer.h"
#include "display/light_pen.h"
#include "raster/line.h"

namespace kinescope {

/// A square about a pixel of the visible page, as far as it lies in the buffer.
inline void store_square(FrameBuffer& buffer, std::int64_t x, std::int64_t y, int reach,
                         std::uint32_t colour) {
  for (std::int64_t v = y - reach; v <= y + reach; ++v) {
    for (std::int64_t u = x - reach; u <= x + reach; ++u) {
      if (u < 0 || v < 0 || u >= buffer.width() || v >= buffer.height()) continue;
      buffer.set_pixel(buffer.visible_page(), static_cast<int>(u), static_cast<int>(v), colour);
    }
  }
}

/// A stroke so far to either side. Places far apart, as where a rolling picture ends, are not
/// joined.
inline void store_stroke(FrameBuffer& buffer, const PixelAddress& from, const PixelAddress& to,
                         int reach, std::uint32_t colour) {
  const bool near = std::abs(from.line - to.line) < buffer.height() / 4;
  const PixelAddress& begin = near ? from : to;
  BresenhamLine line(begin.pixel, begin.line, to.pixel, to.line);
  for (std::int64_t i = 0; i <= line.steps(); ++i, line.step()) {
    store_square(buffer, line.x(), line.y(), reach, colour);
  }
}

}  // namespace kinescope
