// A tube small enough to reason about cell by cell, and pictures for it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "display/raster_tube.h"

namespace kinescope {

inline constexpr std::uint32_t kWhite = 0xffffff;

inline Seconds at_clock(const VideoMode& mode, double clock) {
  return Seconds(clock / mode.pixel_clock_hz);
}

/// 12x8 pixels in 20x11 clocks, 60 frames a second. A clock lasts 76 us, so that phosphors fade
/// within pixels, lines and frames alike.
inline VideoMode tiny_mode(bool interlaced = false) {
  VideoMode mode;
  mode.name = "tiny";
  mode.horizontal = {12, 2, 3, 3};
  mode.vertical = {8, 1, 1, 1};
  mode.interlaced = interlaced;
  mode.pixel_clock_hz = 20 * 11 * 60;
  return mode;
}

/// A spot so small that a picture of the mode's size shows each cell alone.
inline TubeSettings sharp(const VideoMode& mode, const std::string& phosphor) {
  TubeSettings settings{mode, phosphor};
  settings.spot.sigma_mm = 0;
  return settings;
}

inline RasterTube cell_tube(const VideoMode& mode, const std::string& phosphor) {
  return {sharp(mode, phosphor), mode.horizontal.active, mode.vertical.active};
}

inline FrameBuffer buffer_for(const VideoMode& mode, int pages = 2) {
  return {mode.horizontal.active, mode.vertical.active, PixelFormat::kXrgb8888, pages};
}

inline void fill(FrameBuffer& buffer, int page, std::uint32_t colour) {
  for (int y = 0; y < buffer.height(); ++y) {
    for (int x = 0; x < buffer.width(); ++x) buffer.set_pixel(page, x, y, colour);
  }
}

inline void fill_random(FrameBuffer& buffer, int page, std::uint32_t seed) {
  std::mt19937 random(seed);
  for (int y = 0; y < buffer.height(); ++y) {
    for (int x = 0; x < buffer.width(); ++x) {
      buffer.set_pixel(page, x, y, static_cast<std::uint32_t>(random()) & 0xffffff);
    }
  }
}

/// Sums of pictures in double precision.
class LightSum {
 public:
  void add(const Image<LinearRgb>& picture) {
    if (sum_.empty()) sum_.resize(picture.pixels().size() * 3);
    std::size_t i = 0;
    for (const LinearRgb& p : picture.pixels()) {
      for (const float v : {p.r, p.g, p.b}) sum_[i++] += static_cast<double>(v);
    }
  }
  const std::vector<double>& values() const { return sum_; }
  double mean() const {
    double total = 0;
    for (const double v : sum_) total += v;
    return total / static_cast<double>(sum_.size());
  }

 private:
  std::vector<double> sum_;
};

/// Fails where a channel is further off than a share of its pixel's brightest: where layers' light
/// cancels out, a channel is a small difference of large sums.
inline void expect_equal_light(const LightSum& whole, const LightSum& slices, double tolerance,
                               const std::string& what) {
  for (std::size_t i = 0; i < whole.values().size(); i += 3) {
    const double* const want = whole.values().data() + i;
    const double light = std::max({std::abs(want[0]), std::abs(want[1]), std::abs(want[2])});
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(slices.values()[i + c], want[c], tolerance * light + 1e-9) << what << " " << i;
    }
  }
}

}  // namespace kinescope
