#include "raster/path/stroke.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace kinescope {
namespace {

constexpr OutlineEdges kNoEdges{{}, {-1, -1, -1, -1}, {}, {}, {}};

int row(double y) { return static_cast<int>(std::clamp(y, -0x1p30, 0x1p30)); }

/// Chords in half a circle, so that none is further than 1/300 pixel from it.
int chords(double radius) {
  const double count = std::ceil(std::numbers::pi / 2 * std::sqrt(150 * radius));
  return static_cast<int>(std::clamp(count, 4.0, 4096.0));
}

}  // namespace

void StrokeOutline::add_edge(glm::dvec2 from, glm::dvec2 to) {
  const bool down = to.y > from.y;
  if (!down) std::swap(from, to);
  const std::size_t lane = count_ % OutlineEdges::kCount;
  if (lane == 0) edges.push_back(kNoEdges);
  OutlineEdges& group = edges.back();
  const double height = to.y - from.y;
  group.top[lane] = from.y;
  group.bottom[lane] = to.y;
  group.x[lane] = from.x;
  group.slope[lane] = height > 0 ? (to.x - from.x) / height : 0;
  group.sign[lane] = down ? 1.0f : -1.0f;
  ++count_;
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
  edges.clear();
  count_ = 0;
  y_begin = y_end = body_begin = body_end = 0;
  glm::dvec2 a = segment.from, b = segment.to;
  const double half = 0.5 * stroke.width_px;
  if (!std::isfinite(a.x + a.y + b.x + b.y + half) || !(half > 0)) return;
  if (a.y > b.y) std::swap(a, b);
  const double length = glm::length(b - a);
  if (length == 0 && stroke.cap == Cap::kButt) return;
  const glm::dvec2 along = length > 0 ? (b - a) / length : glm::dvec2(1, 0);
  if (stroke.cap == Cap::kSquare) {
    a -= along * half;
    b += along * half;
  }
  // Since it points down (or sideways), its left is the screen's left.
  const glm::dvec2 to_left = glm::dvec2(-along.y, along.x) * half;
  add_edge(a + to_left, b + to_left);
  add_edge(b - to_left, a - to_left);
  if (stroke.cap == Cap::kRound) {
    add_half_disc(a, -to_left, half);
    add_half_disc(b, to_left, half);
  } else {
    add_edge(a - to_left, a + to_left);
    add_edge(b + to_left, b - to_left);
  }
  const double reach = stroke.cap == Cap::kRound ? 1.01 * half : std::abs(to_left.y);
  y_begin = row(std::floor(a.y - reach));
  y_end = row(std::ceil(b.y + reach));
  body_begin = std::max(y_begin, row(std::ceil(a.y + std::abs(to_left.y))));
  body_end = row(std::floor(b.y - std::abs(to_left.y)));
  if (body_end <= body_begin) {
    body_begin = body_end = y_end;
    return;
  }
  left_x = a.x + to_left.x;
  left_y = a.y + to_left.y;
  slope = edges[0].slope[0];
  across = 2 * half / along.y;
  ramp = Ramp(static_cast<float>(std::abs(slope)));
}

}  // namespace kinescope
