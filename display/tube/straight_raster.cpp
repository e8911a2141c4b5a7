#include <algorithm>
#include <bit>
#include <functional>

#include "display/tube/deflection.h"
#include "display/tube/raster_spread.h"

namespace kinescope {
namespace {

/// Where a picture's pixels begin and end along one axis of the sweep, in cells.
std::vector<double> pixel_edges(int pixels, int cells, const std::function<double(double)>& sweep) {
  std::vector<double> edges;
  for (int i = 0; i <= pixels; ++i) {
    edges.push_back(0.5 * (sweep(2.0 * i / pixels - 1) + 1) * cells);
  }
  return edges;
}

/// The most cells from where a group's first column starts to where its last does.
int start_span(const AxisWeights& across) {
  int most = 0;
  for (std::size_t x = 0; x + kGroup <= across.start.size(); x += kGroup) {
    most = std::max(most, across.start[x + kGroup - 1] - across.start[x]);
  }
  return most;
}

}  // namespace

StraightRaster::StraightRaster(const TubeSettings& settings, const SpotModel& spot, int gun,
                               const RasterExtent& e)
    : lines_(e.lines) {
  const Deflection deflection(settings.deflection, settings.glass, gun);
  const PixelsAMm pixels = pixels_a_mm(settings.glass, e.width, e.height);
  const double x = pixels.across * spot.astigmatism(), y = pixels.down;
  across_ = axis_weights(pixel_edges(e.width, e.cells,
                                     [&](double p) {
                                       return deflection.sweep_of_glass({p, 0}).x;
                                     }),
                         {spot.narrow_mm() * x, spot.wide_mm() * x},
                         e.cells / (e.width * settings.deflection.width), true);
  down_ = axis_weights(pixel_edges(e.height, e.lines,
                                   [&](double p) {
                                     return deflection.sweep_of_glass({0, p}).y;
                                   }),
                       {spot.narrow_mm() * y, spot.wide_mm() * y},
                       e.lines / (e.height * settings.deflection.height), false);
  // Columns beside the raster look at the dark cells there.
  for (int& start : across_.start) {
    start = std::clamp(start, -kCellPad, e.cells + kCellPad - kGroup - across_.taps);
  }
  span_ = start_span(across_);
  ring_lines_ = static_cast<int>(std::bit_ceil(static_cast<unsigned>(down_.taps)));
  for (int row = 0; row < e.height; ++row) {
    for (int t = 0; t < down_.taps; ++t) {
      down_narrow_.push_back(down_.at(0, row, t));
      down_wide_.push_back(down_.at(1, row, t));
    }
  }
}

std::ptrdiff_t StraightRaster::ring_at(const SpreadRing& ring, int line) const {
  return static_cast<std::ptrdiff_t>(line & (ring_lines_ - 1)) * ring.groups * kGroup;
}

void StraightRaster::begin_tile(SpreadRing& ring, int x, int groups) const {
  const std::size_t floats = static_cast<std::size_t>(ring_lines_ * groups * kGroup);
  ring.narrow.resize(std::max(ring.narrow.size(), floats));
  ring.wide.resize(std::max(ring.wide.size(), floats));
  ring.x = x;
  ring.groups = groups;
  ring.next_line = down_.start.front() - 1;
}

void StraightRaster::spread_line(const LayerLight& light, SpreadRing& ring, int line) const {
  const std::ptrdiff_t at = ring_at(ring, line);
  if (line < 0 || line >= lines_) return ring.darken(at);
  spread_across(
      {across_.start.data() + ring.x, across_.weight[0].data() + ring.x,
       across_.weight[1].data() + ring.x, across_.taps, across_.pitch, ring.groups, span_},
      light.rows(line), {ring.narrow.data() + at, ring.wide.data() + at});
}

/// Each line that the row needs is spread across once.
void StraightRaster::spread_row(const LayerLight& light, SpreadRing& ring, int y,
                                float* out) const {
  constexpr int kMostTaps = 64;
  const int taps = down_.taps, first = down_.start[static_cast<std::size_t>(y)];
  ring.next_line = std::max(ring.next_line, first);
  for (; ring.next_line < first + taps; ++ring.next_line) spread_line(light, ring, ring.next_line);
  const float* narrow[kMostTaps];
  const float* wide[kMostTaps];
  for (int done = 0; done < taps; done += kMostTaps) {
    const int some = std::min(kMostTaps, taps - done);
    for (int t = 0; t < some; ++t) {
      const std::ptrdiff_t at = ring_at(ring, first + done + t);
      narrow[t] = ring.narrow.data() + at;
      wide[t] = ring.wide.data() + at;
    }
    const std::ptrdiff_t weights = static_cast<std::ptrdiff_t>(y) * taps + done;
    spread_down(ring.groups, some, narrow, wide, down_narrow_.data() + weights,
                down_wide_.data() + weights, done > 0, out);
  }
}

}  // namespace kinescope
