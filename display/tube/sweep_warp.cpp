#include "display/tube/sweep_warp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace kinescope {
namespace {

/// The sweep's line, with a fraction, that lies on each whole line of the steady raster; beyond the
/// ends lines lie one apart.
class LineFinder {
 public:
  explicit LineFinder(const std::vector<float>& place) : place_(place) {
    const int lines = static_cast<int>(place.size());
    std::size_t at = 0;
    for (int line = 0; line < lines; ++line) {
      while (at + 2 < place.size() && place[at + 1] <= static_cast<float>(line)) ++at;
      found_.push_back(between(at, static_cast<float>(line)));
    }
  }
  float operator()(float line) const {
    const float last = static_cast<float>(found_.size() - 1);
    if (line <= 0) return found_.front() + line;
    if (line >= last) return found_.back() + line - last;
    const std::size_t above = static_cast<std::size_t>(line);
    const float share = line - std::floor(line);
    return found_[above] + share * (found_[above + 1] - found_[above]);
  }

 private:
  float between(std::size_t at, float line) const {
    const float first = static_cast<float>(at);
    if (place_.size() < 2 || line < place_[at]) return first + line - place_[at];
    if (line >= place_.back()) return static_cast<float>(place_.size() - 1) + line - place_.back();
    const float gap = place_[at + 1] - place_[at];
    return gap > 0 ? first + (line - place_[at]) / gap : first;
  }

  const std::vector<float>& place_;
  std::vector<float> found_;
};

constexpr double kLeastVoltage = 0.2;

}  // namespace

double voltage_at(const SweepSettings& settings, double load) {
  return std::max(kLeastVoltage, 1 - settings.sag * load);
}

SweepBend sweep_bend(const SweepSettings& settings, double seconds, double load) {
  const double ripple = std::sin(2 * std::numbers::pi * settings.hum_hz * seconds);
  return {1 / std::sqrt(voltage_at(settings, load)), settings.hum_x * ripple,
          settings.hum_y * ripple};
}

void bend_line(SweepWarp& warp, const SweptField& field, int line, const SweepBend& bend, int cells,
               int lines) {
  const std::size_t l = static_cast<std::size_t>(line);
  const double middle = 0.5 * (lines - 1), place = field.first_place + line - middle;
  warp.place[l] = static_cast<float>(middle + place * bend.scale + 0.5 * lines * bend.shift_y);
  warp.scale[l] = static_cast<float>(bend.scale);
  warp.shift[l] = static_cast<float>(0.5 * cells * bend.shift_x);
}

BeamMap warped(const BeamMap& steady, const SweepWarp& warp, int cells, int tile_columns) {
  BeamMap map = steady;
  const LineFinder find(warp.place);
  for (float& line : map.line) line = find(line);
  const int lines = static_cast<int>(warp.place.size());
  const float middle = 0.5f * static_cast<float>(cells);
  for (int line = 0; line < lines; ++line) {
    const std::size_t l = static_cast<std::size_t>(line);
    const float place = std::clamp(warp.place[l], 0.0f, static_cast<float>(lines - 1));
    const int above = std::min(static_cast<int>(place), std::max(0, lines - 2));
    const int below = std::min(above + 1, lines - 1);
    const float share = place - static_cast<float>(above);
    const float* const from = steady.cells_of(above);
    const float* const to = steady.cells_of(below);
    float* const out = map.cell_on_line.data() + l * static_cast<std::size_t>(map.columns);
    for (int i = 0; i < map.columns; ++i) {
      const float cell = from[i] + share * (to[i] - from[i]);
      out[i] = (cell - middle - warp.shift[l]) / warp.scale[l] + middle;
    }
  }
  set_ring(map, tile_columns);
  return map;
}

}  // namespace kinescope
