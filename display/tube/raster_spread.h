// One gun's raster under the output's pixels: its lines are spread across columns, then down rows.
// A straight raster has its axes apart and its weights in tables; a curved one is followed pixel by
// pixel.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "display/tube/axis_weights.h"
#include "display/tube/beam_map.h"
#include "display/tube/cell_blur.h"
#include "display/tube/curve_kernels.h"
#include "display/tube/light_planes.h"
#include "display/tube/settings.h"
#include "display/tube/spot.h"
#include "display/tube/spread_kernels.h"
#include "display/tube/sweep_warp.h"

namespace kinescope {

/// A screen's measures.
struct RasterExtent {
  int cells = 0, lines = 0;   ///< of the raster
  int width = 0, height = 0;  ///< of the output, pixels
};

/// Lines spread across the columns of one tile of the output so far.
struct SpreadRing {
  AlignedVector<float> narrow, wide;
  int x = 0, groups = 0;  ///< the tile's first column, and its columns in groups
  int next_line = 0;
  int grid_row = 0;  // of a curved raster's map: the one that has its lines

  /// A line outside the raster, at a place in the ring.
  void darken(std::ptrdiff_t at) {
    std::fill_n(narrow.begin() + at, groups * kGroup, 0.0f);
    std::fill_n(wide.begin() + at, groups * kGroup, 0.0f);
  }
};

class StraightRaster {
 public:
  static constexpr int kTileColumns = 240;
  StraightRaster(const TubeSettings& settings, const SpotModel& spot, int gun,
                 const RasterExtent& extent);
  void begin_tile(SpreadRing& ring, int x, int groups) const;
  bool sees_lines(const SpreadRing&, int /*y*/, int begin, int end) const { return begin < end; }
  /// The light of one layer in the tile's row y; rows come from the top.
  void spread_row(const LayerLight& light, SpreadRing& ring, int y, float* out) const;

 private:
  void spread_line(const LayerLight& light, SpreadRing& ring, int line) const;
  std::ptrdiff_t ring_at(const SpreadRing& ring, int line) const;

  AxisWeights across_, down_;
  std::vector<float> down_narrow_, down_wide_;  // row after row
  int span_ = 0;
  int lines_;
  int ring_lines_ = 1;  // a power of two, at least down_.taps
};

class CurvedRaster {
 public:
  static constexpr int kTileColumns = 96;
  CurvedRaster(const TubeSettings& settings, const SpotModel& spot, int gun,
               const RasterExtent& extent);
  /// The same raster as one sweep has it; where the voltage sagged, spots are wider.
  CurvedRaster bent(const SweepWarp& warp) const;
  /// What cells must be blurred by before they are spread: a spot may be wider than taps reach.
  const CellBlur& blur() const { return blur_; }
  /// Whether lines of the two lie within a hundredth of a line of each other.
  bool shares_lines_with(const CurvedRaster& other) const;
  /// Makes rings as large as the other's, if those are larger.
  void widen_ring(const CurvedRaster& other);
  void begin_tile(SpreadRing& ring, int x, int groups) const;
  /// Whether light of lines [begin, end) may reach the tile's row y.
  bool sees_lines(const SpreadRing& ring, int y, int begin, int end) const;
  /// Spreads the lines that the tile's row y needs across its columns.
  void spread_lines(const LayerLight& light, SpreadRing& ring, int y) const;
  /// The row's light, of this raster's ring and of others that share its lines.
  void lines_down(const SpreadRing& ring, int y, std::span<const LineRows> rows) const;
  void spread_row(const LayerLight& light, SpreadRing& ring, int y, float* out) const;

 private:
  /// Of the two Gaussians, pixels.
  struct Deviations {
    double narrow = 0, wide = 0;
    /// With the spot so many times wider and variances added.
    Deviations widened(double times, const Deviations& variances) const;
  };
  void set_reach(double least_wider, double most_wider);
  double wider(float line) const;
  int grid_row(int y) const { return std::min(y / kGroup, map_.rows - 2); }
  /// The first and last line that rows about y need.
  std::pair<int, int> lines_near(const SpreadRing& ring, int y) const;
  void spread_line(const LayerLight& light, SpreadRing& ring, int line) const;
  std::ptrdiff_t ring_at(const SpreadRing& ring, int line) const;

  BeamMap map_;
  int cells_, lines_, taps_ = 6;
  float cells_a_pixel_;
  Deviations across_, down_;                      // of the spot alone
  Deviations variances_across_, variances_down_;  // of pixels, and against beats, less the blur's
  double beat_variance_ = 0;                      // down, square pixels
  SpotSettings spot_;
  CellBlur blur_;
  std::vector<float> wider_;  // of each line of a sweep: how much wider its spots are
  LineGrid grid_{};           // what all rows have in common
};

}  // namespace kinescope
