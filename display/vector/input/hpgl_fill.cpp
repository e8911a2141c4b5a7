// Areas as a plotter fills them: with parallel lines.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "display/vector/input/hpgl_plotter.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// No screen tells more lines apart.
constexpr double kMostLines = 20000;
constexpr std::size_t kMostCrossings = 4'000'000;  ///< of one area
constexpr std::size_t kMostStrokes = 5'000'000;    ///< of all

/// Where an edge meets a line.
struct Crossing {
  double line, at;
};

/// Lines at the given angle, even-odd, counted from the origin of plotter units so that neighbours'
/// lines meet.
void hatch(HpglPlotter& plotter, const std::vector<HpglContour>& polygon, double spacing,
           double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const glm::dvec2 along{std::cos(angle), std::sin(angle)}, across{-along.y, along.x};
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const HpglContour& contour : polygon) {
    for (const glm::dvec2 p : contour.points) {
      least = std::min(least, glm::dot(p, across));
      most = std::max(most, glm::dot(p, across));
    }
  }
  if (!std::isfinite(most - least)) return;
  spacing = std::max({spacing, (most - least) / kMostLines, 1e-3});
  std::vector<Crossing> crossings;
  for (const HpglContour& contour : polygon) {
    const std::size_t count = contour.points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec2 a = contour.points[i], b = contour.points[(i + 1) % count];
      const double ya = glm::dot(a, across), yb = glm::dot(b, across);
      // Lines in [lower, upper): those that meet only one of two joined edges at their corner.
      const double first = std::ceil(std::min(ya, yb) / spacing), end = std::max(ya, yb) / spacing;
      for (double k = first; k < end; ++k) {
        const double t = (k * spacing - ya) / (yb - ya);
        crossings.push_back({k, glm::dot(a + t * (b - a), along)});
      }
      if (crossings.size() > kMostCrossings) {
        throw_bad_input("an area is too intricate to be filled", plotter.name);
      }
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.line != b.line ? a.line < b.line : a.at < b.at;
  });
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const glm::dvec2 level = crossings[i].line * spacing * across;
    plotter.stroke(crossings[i].at * along + level, crossings[i + 1].at * along + level);
  }
  plotter.fill_strokes += crossings.size() / 2;
  if (plotter.fill_strokes > kMostStrokes) {
    throw_bad_input("areas are filled with more lines than any plotter would draw", plotter.name);
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
