// The window that two-dimensional clipping keeps, and points clipped to it.
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <span>

namespace kinescope {

/// A rectangle with its sides: a point on a side is inside. Empty where min exceeds max.
struct ClipWindow {
  glm::dvec2 min{0.0}, max{1.0};

  /// Of two opposite corners, whichever.
  static ClipWindow between(const glm::dvec2& a, const glm::dvec2& b) {
    return {glm::min(a, b), glm::max(a, b)};
  }
  /// False for NaN.
  bool contains(const glm::dvec2& p) const {
    return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y;
  }
};

struct Segment2 {
  glm::dvec2 from{0.0}, to{0.0};
  bool operator==(const Segment2&) const = default;
};

inline bool is_finite(const glm::dvec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Calls sink(point) for each point inside.
template <typename Sink>
void clip_points(const ClipWindow& window, std::span<const glm::dvec2> points, Sink&& sink) {
  for (const glm::dvec2& p : points) {
    if (window.contains(p)) sink(p);
  }
}

}  // namespace kinescope
