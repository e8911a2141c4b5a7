// A line with width and ends, as the convex outline whose area it covers.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "raster/path/ramp.h"

namespace kinescope {

/// Straight, from one point to another, pixels. Pixel (x, y) is [x, x + 1) x [y, y + 1).
struct Segment {
  glm::vec2 from{0}, to{0};
};

enum class Cap {
  kButt,    ///< the line ends where the segment does: a segment of no length covers nothing
  kSquare,  ///< half a width further; a segment of no length is an upright square
  kRound,   ///< a half disc; its chords change a pixel by less than 1/255
};

struct Stroke {
  float width_px = 1;
  Cap cap = Cap::kButt;
};

/// Four edges of an outline, each from its top downwards, pixels; for SIMD, field by field.
struct OutlineEdges {
  static constexpr std::size_t kCount = 4;
  std::array<double, kCount> top, bottom;  ///< y of the ends; no edge if bottom <= top
  std::array<double, kCount> x;            ///< at the top
  std::array<double, kCount> slope;        ///< x a y
  std::array<float, kCount> sign;          ///< 1 if the inside lies right of it, else -1
};

/// The outline of a stroked segment. Rows in which only its two long sides lie have a simple form.
struct StrokeOutline {
  /// Covers nothing if the segment or the width is not finite, or the width not positive.
  void set(const Segment& segment, const Stroke& stroke);

  std::vector<OutlineEdges> edges;
  int y_begin = 0, y_end = 0;        ///< rows that are touched, within +-2^30
  int body_begin = 0, body_end = 0;  ///< rows crossed by both long sides and nothing else
  double left_x = 0, left_y = 0;     ///< a point of the left side
  double slope = 0;                  ///< of both sides, x a y
  double across = 0;                 ///< from the left to the right side along x
  Ramp ramp{0};                      ///< of both sides over a whole row

 private:
  void set_edges(glm::dvec2 a, glm::dvec2 b, glm::dvec2 to_left, double end_slope, Cap cap);
  void add_edge(glm::dvec2 from, glm::dvec2 to);
  void add_half_disc(glm::dvec2 centre, glm::dvec2 start, double radius);

  std::size_t count_ = 0;
};

}  // namespace kinescope
