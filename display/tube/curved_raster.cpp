#include <algorithm>
#include <cmath>

#include "display/tube/deflection.h"
#include "display/tube/raster_spread.h"

namespace kinescope {
namespace {

constexpr double kPixelVariance = 1.0 / 12;  // of an output pixel's own width
constexpr float kLeastDeviation = 0.02f;     // down, lines
constexpr double kReach = 2.8;               // of a Gaussian, deviations
// The widest that taps reach, cells across and lines down; yet so wide that lines of a white
// picture run together as those of any wider spot do.
constexpr double kWidestAcross = 0.89, kWidestDown = 0.64;

int taps_for(double deviation_cells) {
  return std::clamp(static_cast<int>(std::ceil(1 + 2 * kReach * deviation_cells)), 4, kCellTaps);
}

}  // namespace

CurvedRaster::Deviations CurvedRaster::Deviations::widened(double times,
                                                           const Deviations& variances) const {
  const auto of = [&](double sigma, double variance) {
    return std::sqrt(std::max(times * times * sigma * sigma + variance, 1e-6));
  };
  return {of(narrow, variances.narrow), of(wide, variances.wide)};
}

CurvedRaster::CurvedRaster(const TubeSettings& settings, const SpotModel& spot, int gun,
                           const RasterExtent& e)
    : map_(beam_map(settings, gun, e.cells, e.lines, e.width, e.height, kTileColumns)),
      cells_(e.cells),
      lines_(e.lines),
      cells_a_pixel_(static_cast<float>(e.cells / (e.width * settings.deflection.width))),
      spot_(settings.spot) {
  const PixelsAMm pixels = pixels_a_mm(settings.glass, e.width, e.height);
  const double x = pixels.across * spot.astigmatism(), y = pixels.down;
  across_ = {spot.narrow_mm() * x, spot.wide_mm() * x};
  down_ = {spot.narrow_mm() * y, spot.wide_mm() * y};
  const double pitch = e.lines / (e.height * settings.deflection.height);
  beat_variance_ = line_blur_variance(pitch) / (pitch * pitch);
  grid_.lines_a_pixel = static_cast<float>(pitch);
  set_reach(1, 1);
}

/// Leaves to taps what they reach of the narrowest spots, to the blur what all are wider than that.
void CurvedRaster::set_reach(double least_wider, double most_wider) {
  const double cells = static_cast<double>(cells_a_pixel_);
  const double lines = static_cast<double>(grid_.lines_a_pixel);
  const auto beyond = [&](double sigma, double widest) {
    return std::max(0.0, std::pow(least_wider * sigma, 2) - widest * widest);
  };
  const auto of = [&](double across, double down) {
    return CellBlur::Variance{beyond(across * cells, kWidestAcross),
                              beyond(down * lines, kWidestDown)};
  };
  const CellBlur::Variance narrow = of(across_.narrow, down_.narrow);
  const CellBlur::Variance wide = of(across_.wide, down_.wide);
  blur_ = CellBlur(narrow, wide);
  const auto pixels = [](double all, double blurred, double a_pixel) {
    return all - blurred / (a_pixel * a_pixel);
  };
  variances_across_ = {pixels(kPixelVariance, narrow.across, cells),
                       pixels(kPixelVariance, wide.across, cells)};
  const double down = kPixelVariance + beat_variance_;
  variances_down_ = {pixels(down, narrow.down, lines), pixels(down, wide.down, lines)};
  taps_ = taps_for(across_.widened(most_wider, variances_across_).wide * cells);
}

CurvedRaster CurvedRaster::bent(const SweepWarp& warp) const {
  CurvedRaster raster = *this;
  raster.map_ = warped(map_, warp, cells_, kTileColumns);
  raster.wider_.clear();
  for (const float scale : warp.scale) {
    raster.wider_.push_back(
        static_cast<float>(spot_at_voltage(spot_, 1 / static_cast<double>(scale * scale))));
  }
  const auto [least, most] = std::minmax_element(raster.wider_.begin(), raster.wider_.end());
  raster.set_reach(*least, *most);
  return raster;
}

double CurvedRaster::wider(float line) const {
  if (wider_.empty()) return 1;
  const float last = static_cast<float>(wider_.size() - 1);
  return wider_[static_cast<std::size_t>(std::clamp(line, 0.0f, last))];
}

bool CurvedRaster::shares_lines_with(const CurvedRaster& other) const {
  return std::equal(map_.line.begin(), map_.line.end(), other.map_.line.begin(),
                    [](float a, float b) { return std::abs(a - b) < 0.01f; });
}

void CurvedRaster::widen_ring(const CurvedRaster& other) {
  map_.ring_lines = std::max(map_.ring_lines, other.map_.ring_lines);
}

std::ptrdiff_t CurvedRaster::ring_at(const SpreadRing& ring, int line) const {
  return static_cast<std::ptrdiff_t>(line & (map_.ring_lines - 1)) * ring.groups * kGroup;
}

void CurvedRaster::begin_tile(SpreadRing& ring, int x, int groups) const {
  const std::size_t floats = static_cast<std::size_t>(map_.ring_lines * groups * kGroup);
  ring.narrow.resize(std::max(ring.narrow.size(), floats));
  ring.wide.resize(std::max(ring.wide.size(), floats));
  ring.grid_row = -1;
  ring.x = x;
  ring.groups = groups;
  ring.next_line = -lines_;
}

void CurvedRaster::spread_line(const LayerLight& light, SpreadRing& ring, int line) const {
  const std::ptrdiff_t at = ring_at(ring, line);
  if (line < -light.beyond || line >= lines_ + light.beyond) return ring.darken(at);
  const Deviations across = across_.widened(wider(static_cast<float>(line)), variances_across_);
  spread_across_curve(
      {map_.cells_of(std::clamp(line, 0, lines_ - 1)) + ring.x / kGroup, ring.groups, cells_, taps_,
       cells_a_pixel_, static_cast<float>(across.narrow), static_cast<float>(across.wide)},
      light.rows(line), {ring.narrow.data() + at, ring.wide.data() + at});
}

std::pair<int, int> CurvedRaster::lines_near(const SpreadRing& ring, int y) const {
  const int j = grid_row(y), nodes = ring.groups + 1;
  const float* above = map_.lines_at(j, ring.x / kGroup);
  const float* below = map_.lines_at(j + 1, ring.x / kGroup);
  const float low = *std::min_element(above, above + nodes);
  const float high = *std::max_element(below, below + nodes);
  return {static_cast<int>(std::floor(low)) - kLineTaps / 2,
          static_cast<int>(std::floor(high)) + kLineTaps / 2 + 1};
}

bool CurvedRaster::sees_lines(const SpreadRing& ring, int y, int begin, int end) const {
  if (begin <= 0 && end >= lines_) return true;
  const auto [first, last] = lines_near(ring, y);
  return begin <= last && end > first;
}

/// Once for every row of the grid.
void CurvedRaster::spread_lines(const LayerLight& light, SpreadRing& ring, int y) const {
  if (ring.grid_row == grid_row(y)) return;
  ring.grid_row = grid_row(y);
  const auto [first, last] = lines_near(ring, y);
  ring.next_line = std::max(ring.next_line, first);
  for (; ring.next_line <= last; ++ring.next_line) spread_line(light, ring, ring.next_line);
}

void CurvedRaster::lines_down(const SpreadRing& ring, int y, std::span<const LineRows> rows) const {
  const int j = grid_row(y);
  LineGrid grid = grid_;
  grid.above = map_.lines_at(j, ring.x / kGroup);
  grid.below = map_.lines_at(j + 1, ring.x / kGroup);
  grid.share = static_cast<float>(y - j * kGroup) * (1.0f / kGroup);
  grid.groups = ring.groups;
  // The voltage hardly changes among the few lines that meet in a row.
  const Deviations down = down_.widened(wider(grid.above[ring.groups / 2]), variances_down_);
  grid.narrow_pixels = static_cast<float>(down.narrow);
  grid.wide_pixels = static_cast<float>(down.wide);
  grid.least_pitch = kLeastDeviation / grid.narrow_pixels;
  spread_down_curve(grid, {map_.ring_lines - 1, ring.groups * kGroup}, rows);
}

void CurvedRaster::spread_row(const LayerLight& light, SpreadRing& ring, int y, float* out) const {
  spread_lines(light, ring, y);
  const LineRows rows{ring.narrow.data(), ring.wide.data(), out};
  lines_down(ring, y, {&rows, 1});
}

}  // namespace kinescope
