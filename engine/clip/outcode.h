// Region codes: on which sides of a window a point lies.
#pragma once

#include <cstdint>

#include "engine/clip/clip_window.h"

namespace kinescope {

/// Written as the textbook writes them: above, below, right, left, from the highest bit.
using Outcode = std::uint8_t;
inline constexpr Outcode kOutAbove = 8, kOutBelow = 4, kOutRight = 2, kOutLeft = 1;

inline Outcode outcode(const ClipWindow& window, const glm::dvec2& p) {
  Outcode code = 0;
  if (p.y > window.max.y) code |= kOutAbove;
  if (p.y < window.min.y) code |= kOutBelow;
  if (p.x > window.max.x) code |= kOutRight;
  if (p.x < window.min.x) code |= kOutLeft;
  return code;
}

/// What a box about a figure tells of it, before the figure itself is looked at.
enum class BoxPlace { kInside, kBeyondSide, kAcross };
inline BoxPlace place_of_box(const ClipWindow& window, const ClipWindow& box) {
  if (window.contains(box.min) && window.contains(box.max)) return BoxPlace::kInside;
  // Two opposite corners tell of all four.
  const Outcode low = outcode(window, box.min), high = outcode(window, box.max);
  return (low & high) != 0 ? BoxPlace::kBeyondSide : BoxPlace::kAcross;
}

}  // namespace kinescope
