#include "raster/path/stroke.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace kinescope {
namespace {

constexpr OutlineEdges kNoEdges{{}, {-1, -1, -1, -1}, {}, {}, {}};

/// Puts an edge into a lane, given its slope.
void put(OutlineEdges& edges, std::size_t lane, glm::dvec2 from, glm::dvec2 to, double slope) {
  const bool down = to.y > from.y;
  edges.top[lane] = std::min(from.y, to.y);
  edges.bottom[lane] = std::max(from.y, to.y);
  edges.x[lane] = down ? from.x : to.x;
  edges.slope[lane] = slope;
  edges.sign[lane] = down ? 1.0f : -1.0f;
}

/// Whole numbers next to y, within +-2^30; std::floor would be a call on older processors.
int row_below(double y) {
  const double within = std::clamp(y, -0x1p30, 0x1p30);
  const int whole = static_cast<int>(within);
  return whole - (within < whole);
}
int row_above(double y) { return -row_below(-y); }

/// A direction within 1e-9 of an axis becomes that axis, and with it b: so slopes stay within what
/// rounded corners can bear; 10^5 pixels further that is 10^-4 pixel aside.
void snap_to_axis(glm::dvec2 a, glm::dvec2& b, double length) {
  if (std::abs(b.y - a.y) < 1e-9 * length) b.y = a.y;
  if (std::abs(b.x - a.x) < 1e-9 * length) b.x = a.x;
}

/// Chords in half a circle, so that none is further than 1/300 pixel from it.
int chords(double radius) {
  const double count = std::ceil(std::numbers::pi / 2 * std::sqrt(150 * radius));
  return static_cast<int>(std::clamp(count, 4.0, 4096.0));
}

}  // namespace

void StrokeOutline::add_edge(glm::dvec2 from, glm::dvec2 to) {
  const std::size_t lane = count_++ % OutlineEdges::kCount;
  if (lane == 0) edges.push_back(kNoEdges);
  put(edges.back(), lane, from, to, from.y == to.y ? 0 : (to.x - from.x) / (to.y - from.y));
}

/// Chords from centre + start, turning against the clock as seen on the screen. Their corners lie
/// a little outside, so that the polygon's area is the disc's.
void StrokeOutline::add_half_disc(glm::dvec2 centre, glm::dvec2 start, double radius) {
  const int count = chords(radius);
  const double angle = std::numbers::pi / count;
  const double outside = std::sqrt(angle / std::sin(angle));
  glm::dvec2 from = centre + start;
  for (int i = 1; i <= count; ++i) {
    const double turn = angle * i, c = std::cos(turn), s = std::sin(turn);
    const glm::dvec2 corner{c * start.x + s * start.y, c * start.y - s * start.x};
    const glm::dvec2 to = centre + (i == count ? -start : corner * outside);
    add_edge(from, to);
    from = to;
  }
}

void StrokeOutline::set(const Segment& segment, const Stroke& stroke) {
  y_begin = y_end = body_begin = body_end = 0;
  glm::dvec2 a = segment.from, b = segment.to;
  const double half = 0.5 * stroke.width_px;
  if (!std::isfinite(a.x + a.y + b.x + b.y + half) || !(half > 0)) return;
  if (a.y > b.y) std::swap(a, b);
  const double length = glm::length(b - a);
  if (length == 0 && stroke.cap == Cap::kButt) return;
  snap_to_axis(a, b, length);
  const glm::dvec2 way = b - a;
  const double inv_length = 1 / length, inv_down = 1 / way.y;
  const glm::dvec2 along = length > 0 ? way * inv_length : glm::dvec2(1, 0);
  slope = way.y > 0 ? way.x * inv_down : 0;
  if (stroke.cap == Cap::kSquare) {
    a -= along * half;
    b += along * half;
  }
  // Since it points down (or sideways), its left is the screen's left.
  const glm::dvec2 to_left = glm::dvec2(-along.y, along.x) * half;
  set_edges(a, b, to_left, along.x != 0 ? -along.y / along.x : 0, stroke.cap);
  const double rise = std::abs(to_left.y), reach = stroke.cap == Cap::kRound ? 1.01 * half : rise;
  y_begin = row_below(a.y - reach);
  y_end = row_above(b.y + reach);
  body_begin = std::max(y_begin, row_above(a.y + rise));
  body_end = row_below(b.y - rise);
  if (body_end <= body_begin) {
    body_begin = body_end = y_end;
    return;
  }
  left_x = a.x + to_left.x;
  left_y = a.y + to_left.y;
  across = 2 * half * (length * inv_down);
  ramp = Ramp(static_cast<float>(std::abs(slope)));
}

/// The sides first, then the ends.
void StrokeOutline::set_edges(glm::dvec2 a, glm::dvec2 b, glm::dvec2 to_left, double end_slope,
                              Cap cap) {
  edges.resize(1);
  count_ = 0;
  put(edges[0], 0, a + to_left, b + to_left, slope);
  put(edges[0], 1, b - to_left, a - to_left, slope);
  if (cap == Cap::kRound) {
    edges[0].bottom[2] = edges[0].bottom[3] = -1;
    edges[0].top[2] = edges[0].top[3] = 0;
    const double radius = glm::length(to_left);
    add_half_disc(a, -to_left, radius);
    add_half_disc(b, to_left, radius);
  } else {
    put(edges[0], 2, a - to_left, a + to_left, end_slope);
    put(edges[0], 3, b + to_left, b - to_left, end_slope);
  }
}

}  // namespace kinescope
