// How much of a pixel a polygon covers, by cutting the polygon to the pixel: slow, plain, and
// nothing in common with how the product does it.
#pragma once

#include <cmath>
#include <functional>
#include <glm/vec2.hpp>
#include <numbers>
#include <vector>

#include "raster/path/stroke.h"

namespace kinescope {

using Corners = std::vector<glm::dvec2>;

inline double signed_area(const Corners& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i] - polygon[0];
    const glm::dvec2 b = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

/// The part where inside(p) >= 0, a linear function. Source: Sutherland and Hodgman, 1974.
inline Corners cut(const Corners& polygon, const std::function<double(glm::dvec2)>& inside) {
  Corners kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double at_a = inside(a), at_b = inside(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return kept;
}

/// The polygon's area in pixel (x, y), signed.
inline double area_in_pixel(const Corners& polygon, int x, int y) {
  Corners rest = cut(polygon, [=](glm::dvec2 p) { return p.x - x; });
  if (!rest.empty()) rest = cut(rest, [=](glm::dvec2 p) { return x + 1 - p.x; });
  if (!rest.empty()) rest = cut(rest, [=](glm::dvec2 p) { return p.y - y; });
  if (!rest.empty()) rest = cut(rest, [=](glm::dvec2 p) { return y + 1 - p.y; });
  return rest.empty() ? 0 : signed_area(rest);
}

/// A stroked segment as a polygon; round ends as thousands of chords.
inline Corners stroke_polygon(const Segment& segment, const Stroke& stroke) {
  const glm::dvec2 a = segment.from, b = segment.to;
  const double length = std::hypot(b.x - a.x, b.y - a.y), half = stroke.width_px / 2.0;
  if (length == 0 && stroke.cap == Cap::kButt) return {};
  const glm::dvec2 u = length > 0 ? (b - a) / length : glm::dvec2(1, 0);
  const glm::dvec2 n(-u.y * half, u.x * half);
  Corners polygon;
  for (const double end : {1.0, -1.0}) {
    const glm::dvec2 centre = end > 0 ? b : a, along = u * (half * end), side = n * end;
    if (stroke.cap == Cap::kRound) {
      constexpr int kChords = 3000;
      for (int i = 0; i <= kChords; ++i) {
        const double t = std::numbers::pi * i / kChords;
        polygon.push_back(centre - side * std::cos(t) + along * std::sin(t));
      }
    } else {
      const glm::dvec2 further = stroke.cap == Cap::kSquare ? along : glm::dvec2(0);
      polygon.push_back(centre + further - side);
      polygon.push_back(centre + further + side);
    }
  }
  return polygon;
}

}  // namespace kinescope
