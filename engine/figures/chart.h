// Charts of a row of values: where bars, a line's points and a pie's sectors lie.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "raster/base/error.h"
#include "raster/fill/polygon.h"

namespace kinescope {

/// A rectangle that a chart fills, y downwards.
struct ChartFrame {
  glm::dvec2 low{0}, high{1};
};

/// From the least value (at most 0) to the greatest (at least 0), so that bars stand on a zero
/// line.
struct ChartScale {
  double least = 0, greatest = 1;
  /// Height in the frame of a value.
  double place(double value, const ChartFrame& frame) const {
    return frame.high.y - (value - least) / (greatest - least) * (frame.high.y - frame.low.y);
  }
};

/// @throws Error (bad input) if there is none, or one that is not finite
inline ChartScale chart_scale(std::span<const double> values) {
  if (values.empty()) throw_bad_input("a chart needs a value");
  ChartScale scale{0, 0};
  for (const double value : values) {
    if (!(std::abs(value) <= 1e300)) throw_bad_input("a chart's values are finite");
    scale.least = std::min(scale.least, value);
    scale.greatest = std::max(scale.greatest, value);
  }
  if (scale.least == scale.greatest) scale.greatest = 1;
  return scale;
}

/// One rectangle a value, from the zero line up or down.
/// @param share of each value's room that its bar takes, 0 to 1
inline std::vector<ChartFrame> chart_bars(std::span<const double> values, const ChartFrame& frame,
                                          double share = 0.7) {
  const ChartScale scale = chart_scale(values);
  const double room = (frame.high.x - frame.low.x) / static_cast<double>(values.size());
  const double zero = scale.place(0, frame);
  std::vector<ChartFrame> bars;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double left = frame.low.x + room * (static_cast<double>(i) + 0.5 - share / 2);
    const double top = scale.place(values[i], frame);
    bars.push_back({{left, std::min(top, zero)}, {left + share * room, std::max(top, zero)}});
  }
  return bars;
}

/// A line's points, in the middle of each value's room.
inline std::vector<glm::dvec2> chart_line(std::span<const double> values, const ChartFrame& frame) {
  const ChartScale scale = chart_scale(values);
  const double room = (frame.high.x - frame.low.x) / static_cast<double>(values.size());
  std::vector<glm::dvec2> points;
  for (const double value : values) {
    const double x = frame.low.x + room * (static_cast<double>(points.size()) + 0.5);
    points.emplace_back(x, scale.place(value, frame));
  }
  return points;
}

/// A sector of a pie. Angles grow clockwise from the top.
struct PieSector {
  double begin_rad = 0, end_rad = 0;
  Contour contour;  ///< the centre, then chords of at most a degree
};

/// @throws Error (bad input) for values that are no shares of a whole
inline std::vector<PieSector> pie_sectors(std::span<const double> values, glm::dvec2 centre,
                                          double radius) {
  chart_scale(values);
  double sum = 0;
  for (const double value : values) {
    if (value < 0) throw_bad_input("a pie has no negative sectors");
    sum += value;
  }
  if (!(sum > 0)) throw_bad_input("a pie of nothing has no sectors");
  std::vector<PieSector> sectors;
  double before = 0;
  for (const double value : values) {
    constexpr double kTurn = 2 * std::numbers::pi;
    PieSector sector{kTurn * before / sum, kTurn * (before + value) / sum, {centre}};
    const double sweep = sector.end_rad - sector.begin_rad;
    const int chords = std::max(1, static_cast<int>(std::ceil(360 * sweep / kTurn)));
    for (int i = 0; i <= chords; ++i) {
      const double angle = sector.begin_rad + sweep * i / chords;
      sector.contour.push_back(centre + radius * glm::dvec2(std::sin(angle), -std::cos(angle)));
    }
    sectors.push_back(std::move(sector));
    before += value;
  }
  return sectors;
}

}  // namespace kinescope
