// Areas as a plotter fills them: with parallel lines.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "display/vector/input/hpgl_plotter.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// No screen tells more lines apart.
constexpr double kMostLines = 8192;
constexpr std::size_t kMostCrossings = 2'000'000;  ///< of one area
constexpr std::size_t kMostStrokes = 2'000'000;    ///< of all

/// Lines k * spacing across, at an angle.
struct Hatching {
  glm::dvec2 along, across;
  double spacing;
};

/// Calls sink(k, place along it) where an edge meets a line.
template <typename Sink>
void for_each_crossing(const HpglContour& contour, const Hatching& lines, const Sink& sink) {
  const std::size_t count = contour.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 a = contour.points[i], b = contour.points[(i + 1) % count];
    const double ya = glm::dot(a, lines.across), yb = glm::dot(b, lines.across);
    // Lines in [lower, upper): those that meet only one of two joined edges at their corner.
    const double first = std::ceil(std::min(ya, yb) / lines.spacing);
    const double end = std::max(ya, yb) / lines.spacing;
    for (double k = first; k < end; ++k) {
      const double t = (k * lines.spacing - ya) / (yb - ya);
      sink(k, glm::dot(a + t * (b - a), lines.along));
    }
  }
}

/// How far an area reaches across its lines.
struct Reach {
  double least = HUGE_VAL, most = -HUGE_VAL;
};
Reach reach_of(const std::vector<HpglContour>& polygon, const glm::dvec2& across) {
  Reach reach;
  for (const HpglContour& contour : polygon) {
    for (const glm::dvec2 p : contour.points) {
      reach.least = std::min(reach.least, glm::dot(p, across));
      reach.most = std::max(reach.most, glm::dot(p, across));
    }
  }
  return reach;
}

/// Where lines are crossed: each line's places lie together.
struct Crossings {
  double lowest = 0;               // line
  std::vector<std::size_t> first;  // of each line in places; the end of all behind
  std::vector<double> places;
};
/// Counts them first, then lays them down. @param name of the file
Crossings crossings_of(const std::vector<HpglContour>& polygon, const Hatching& lines,
                       const Reach& reach, const std::string& name) {
  Crossings c;
  c.lowest = std::ceil(reach.least / lines.spacing);
  const auto row = [&](double k) { return static_cast<std::size_t>(k - c.lowest); };
  c.first.assign(row(std::ceil(reach.most / lines.spacing)) + 3, 0);
  std::size_t count = 0;
  for (const HpglContour& contour : polygon) {
    for_each_crossing(contour, lines, [&](double k, double) { ++c.first[row(k) + 2], ++count; });
    if (count > kMostCrossings) throw_bad_input("an area is too intricate to be filled", name);
  }
  std::partial_sum(c.first.begin(), c.first.end(), c.first.begin());
  c.places.resize(count);
  for (const HpglContour& contour : polygon) {
    for_each_crossing(contour, lines,
                      [&](double k, double at) { c.places[c.first[row(k) + 1]++] = at; });
  }
  return c;
}

/// Lines at the given angle, even-odd, counted from the origin of plotter units so that neighbours'
/// lines meet.
void hatch(HpglPlotter& plotter, const std::vector<HpglContour>& polygon, double spacing,
           double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const glm::dvec2 along{std::cos(angle), std::sin(angle)}, across{-along.y, along.x};
  const Reach reach = reach_of(polygon, across);
  const double range = reach.most - reach.least;
  if (!std::isfinite(range)) return;
  const Hatching lines{along, across, std::max({spacing, range / kMostLines, 1e-3})};
  Crossings c = crossings_of(polygon, lines, reach, plotter.name);
  plotter.fill_strokes += c.places.size() / 2;
  if (plotter.fill_strokes > kMostStrokes) {
    throw_bad_input("areas are filled with more lines than any plotter would draw", plotter.name);
  }
  for (std::size_t r = 0; r + 1 < c.first.size(); ++r) {
    double* const begin = c.places.data() + c.first[r];
    double* const end = c.places.data() + c.first[r + 1];
    std::sort(begin, end);
    const glm::dvec2 level = (c.lowest + static_cast<double>(r)) * lines.spacing * across;
    for (const double* p = begin; end - p >= 2; p += 2) {
      plotter.stroke(p[0] * along + level, p[1] * along + level);
    }
  }
}

}  // namespace

void hpgl_fill(HpglPlotter& plotter, const std::vector<HpglContour>& polygon) {
  const bool solid = plotter.fill_type != 3 && plotter.fill_type != 4;
  double spacing = plotter.plotter_length(plotter.fill_spacing);
  if (spacing == 0) spacing = 0.01 * glm::length(plotter.p2 - plotter.p1);
  if (solid) {
    const double width = plotter.pens[static_cast<std::size_t>(plotter.pen_number)].width;
    spacing = width > 0 ? width : plotter.pen_thickness;
  }
  const double degrees = solid ? 0 : plotter.fill_degrees;
  hatch(plotter, polygon, std::abs(spacing), degrees);
  if (plotter.fill_type == 4) hatch(plotter, polygon, std::abs(spacing), degrees + 90);
}

void hpgl_outline(HpglPlotter& plotter, const std::vector<HpglContour>& polygon) {
  for (const HpglContour& contour : polygon) {
    for (std::size_t i = 1; i < contour.points.size(); ++i) {
      if (contour.edges[i]) plotter.stroke(contour.points[i - 1], contour.points[i]);
    }
  }
}

}  // namespace kinescope
