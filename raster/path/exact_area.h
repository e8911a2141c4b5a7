// Anti-aliased polygons by exact area: each edge adds its signed area to the pixels it crosses, and
// a running sum along each row turns that into coverage. Source: R. Levien, font-rs; the same
// principle as FreeType's smooth rasterizer.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "raster/aligned_vector.h"

namespace kinescope {

/// How overlapping contours count. Areas of one pixel add up before the rule is applied, so where
/// contours cross inside a pixel its coverage is approximate, as in every rasterizer of this kind.
enum class FillRule { kNonZero, kEvenOdd };

/// Gathers the edges of closed polygons and yields the coverage of each pixel, clipped to a box.
/// Areas are whole numbers: their sums are exact, so a closed polygon leaves exactly nothing beside
/// it, and no order of adding shows.
class ExactArea {
 public:
  static constexpr std::uint32_t kWhole = 1 << 16;  ///< the area of a pixel
  static constexpr int kBlock = 8;                  ///< cells that are marked together

  /// The box [0, width) x [0, height), pixels, y downwards.
  ExactArea(int width = 0, int height = 0) { reset(width, height); }

  /// An empty box of another size; memory is kept.
  void reset(int width, int height);

  /// One edge, pixels. Contours must be closed by the caller. An edge that is not finite is left
  /// out.
  void add_edge(glm::dvec2 from, glm::dvec2 to);

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

  /// What a row holds, for kernels that take it themselves and leave zeros.
  struct Row {
    std::uint32_t* cells;  ///< differences of (signed) area from pixel to pixel, 65536 a pixel
    std::uint64_t* marks;  ///< a bit for each block of cells that may not be zero
    std::size_t mark_words;
  };
  Row row(int y);
  int width() const { return width_; }
  int height() const { return height_; }

  /// The area that a winding sum covers, out of kWhole.
  static std::uint32_t covered(std::uint32_t winding, FillRule rule) {
    const std::uint32_t area = winding >> 31 ? 0 - winding : winding;
    if (rule == FillRule::kNonZero) return std::min(area, kWhole);
    const std::uint32_t rest = area & (2 * kWhole - 1);
    return rest <= kWhole ? rest : 2 * kWhole - rest;
  }

 private:
  void add_in_row(double x0, double x1, std::int32_t height, const Row& row);
  void take_row(int y, FillRule rule, std::span<float> coverage);

  int width_ = 0;
  int height_ = 0;
  // A row has one cell more than pixels, where what lies right of the box ends, in whole blocks.
  std::size_t row_blocks_ = 0, row_words_ = 0;
  AlignedVector<std::uint32_t> cells_;
  std::vector<std::uint64_t> marks_;
};

}  // namespace kinescope
