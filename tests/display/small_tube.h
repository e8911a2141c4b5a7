// A tube of a few thousand cells, out of the straight by nothing to speak of, and where its light
// lies.
#pragma once

#include <algorithm>
#include <cmath>

#include "display/raster_tube.h"
#include "tests/display/tube_fixtures.h"

namespace kinescope {

inline double largest(const Image<LinearRgb>& picture) {
  double most = 0;
  for (const LinearRgb& p : picture.pixels()) {
    for (const float v : {p.r, p.g, p.b}) most = std::max(most, std::abs(static_cast<double>(v)));
  }
  return most;
}

inline double largest_difference(const Image<LinearRgb>& a, const Image<LinearRgb>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const LinearRgb p = a.pixels()[i], q = b.pixels()[i];
    for (const float d : {p.r - q.r, p.g - q.g, p.b - q.b}) {
      most = std::max(most, std::abs(static_cast<double>(d)));
    }
  }
  return most;
}

/// A bright line on black, and where in the picture its light lies, as a share of the glass.
inline void draw_line(FrameBuffer& buffer, int line) {
  fill(buffer, 0, 0);
  for (int x = 0; x < buffer.width(); ++x) buffer.set_pixel(0, x, line, kWhite);
}
inline void draw_column(FrameBuffer& buffer, int column) {
  fill(buffer, 0, 0);
  for (int y = 0; y < buffer.height(); ++y) buffer.set_pixel(0, column, y, kWhite);
}

/// Mean place of the light in rows [top, bottom).
struct Centre {
  double x = 0, y = 0, light = 0;
};
inline Centre centre_of(const Image<LinearRgb>& picture, int top, int bottom) {
  Centre c;
  for (int y = top; y < bottom; ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const double light = static_cast<double>(picture.at(x, y).g);
      c.x += light * (x + 0.5) / picture.width();
      c.y += light * (y + 0.5) / picture.height();
      c.light += light;
    }
  }
  c.x /= c.light;
  c.y /= c.light;
  return c;
}
inline Centre centre_of(const Image<LinearRgb>& picture) {
  return centre_of(picture, 0, picture.height());
}

/// 64x48 pixels in 80x60 clocks, 60 frames a second.
inline VideoMode small_mode(bool interlaced = false) {
  VideoMode mode;
  mode.name = "small";
  mode.horizontal = {64, 4, 6, 6};
  mode.vertical = {48, 3, 3, interlaced ? 7 : 6};
  mode.interlaced = interlaced;
  mode.pixel_clock_hz = 80 * mode.vertical.total() * 60;
  return mode;
}

/// A monochrome tube that fades at once, a little out of the straight.
inline TubeSettings fading(const VideoMode& mode) {
  TubeSettings settings{mode, "P15"};
  settings.spot.sigma_mm = 3;
  settings.deflection.rotation_deg = 1e-7;
  return settings;
}

}  // namespace kinescope
