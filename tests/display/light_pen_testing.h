// What the tests of light pens share.
#pragma once

#include "display/light_pen.h"
#include "tests/display/small_tube.h"

namespace kinescope {

/// A picture of one colour.
inline FrameBuffer plain(const VideoMode& mode, std::uint32_t colour) {
  FrameBuffer buffer = buffer_for(mode, 1);
  fill(buffer, 0, colour);
  return buffer;
}

/// The middle of a pixel of a raster that fills a flat glass.
inline Place middle_of(const VideoMode& mode, int pixel, int line) {
  return {2 * (pixel + 0.5) / mode.horizontal.active - 1,
          2 * (line + 0.5) / mode.vertical.active - 1};
}

inline Exposure frame_of(const VideoMode& mode, int number) {
  return {number * mode.frame_period(), (number + 1) * mode.frame_period()};
}

/// A pen whose view is about one line high.
inline LightPenSettings narrow_pen(const TubeSettings& tube) {
  const PixelsAMm lines = pixels_a_mm(tube.glass, 1, tube.mode.vertical.active);
  LightPenSettings pen;
  pen.view_mm = 0.9 / lines.down;
  return pen;
}

}  // namespace kinescope
