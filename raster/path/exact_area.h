// Anti-aliased polygons by exact area: each edge adds its signed area to the pixels it crosses, and
// a running sum along each row turns that into coverage. Source: R. Levien, font-rs; the same
// principle as FreeType's smooth rasterizer.
#pragma once

#include <cassert>
#include <cmath>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace kinescope {

/// How overlapping contours count. Areas of one pixel add up before the rule is applied, so where
/// contours cross inside a pixel its coverage is approximate, as in every rasterizer of this kind.
enum class FillRule { kNonZero, kEvenOdd };

/// Gathers the edges of closed polygons and yields the coverage of each pixel, clipped to a box.
class ExactArea {
 public:
  /// The box [0, width) x [0, height), pixels, y downwards.
  ExactArea(int width, int height);

  /// One edge, pixels. Contours must be closed by the caller. An edge that is not finite is left
  /// out.
  void add_edge(glm::vec2 from, glm::vec2 to);

  /// Calls sink(y, coverage) for each row from the top, coverage in [0, 1] a pixel; then empty
  /// again.
  template <typename Sink>
  void rows(FillRule rule, Sink&& sink) {
    std::vector<float> coverage(static_cast<std::size_t>(width_));
    for (int y = 0; y < height_; ++y) {
      take_row(y, rule, coverage);
      sink(y, std::span<const float>(coverage));
    }
  }

 private:
  void add_inside(double x0, double y0, double x1, double y1);
  void add_in_row(double x0, double x1, double dy, float* row);
  void take_row(int y, FillRule rule, std::span<float> coverage);

  int width_;
  int height_;
  // A row has one cell more than pixels: what lies right of the box ends there.
  std::vector<float> deltas_;
};

}  // namespace kinescope
