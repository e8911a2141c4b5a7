#include "raster/scan/arc.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace kinescope {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace

Sector::Sector(double start, double sweep) {
  empty_ = !std::isfinite(start) || !std::isfinite(sweep);
  if (empty_) return;
  if (sweep < 0) {
    start += sweep;
    sweep = -sweep;
  }
  whole_ = sweep >= 2 * std::numbers::pi;
  narrow_ = sweep < std::numbers::pi / 2;
  over_half_ = sweep > std::numbers::pi;
  from_ = {std::cos(start), std::sin(start)};
  to_ = {std::cos(start + sweep), std::sin(start + sweep)};
}

// A rounding's tolerance: the pixels on an axis belong to a sector that begins there.
bool Sector::contains(glm::dvec2 direction) const {
  if (empty_ || whole_) return whole_;
  const double slack = -1e-9 * (std::abs(direction.x) + std::abs(direction.y));
  const bool behind_start = cross(from_, direction) >= slack;
  const bool before_end = cross(direction, to_) >= slack;
  if (over_half_) return behind_start || before_end;
  // Of a narrow sector the opposite direction must be told apart.
  const glm::dvec2 middle = from_ + to_;
  const bool ahead = !narrow_ || direction.x * middle.x + direction.y * middle.y >= 0;
  return behind_start && before_end && ahead;
}

CircleWalk::CircleWalk(int radius) : circle_(radius) {
  if (radius < 0) return;
  // The octant's columns x <= y; the last is at or beside r / sqrt 2.
  auto x = static_cast<std::int64_t>(radius / std::numbers::sqrt2);
  while (x + 1 <= circle_.height(x + 1)) ++x;
  while (x > circle_.height(x)) --x;
  columns_ = x + 1;
  diagonal_ = x == circle_.height(x);
}

glm::ivec2 CircleWalk::placed(std::int64_t i) const {
  const auto along = static_cast<int>(octant_ & 1 ? columns_ - 1 - i : i);
  const auto up = static_cast<int>(circle_.height(along));
  switch (octant_) {
    case 0:
      return {up, along};
    case 1:
      return {along, up};
    case 2:
      return {-along, up};
    case 3:
      return {-up, along};
    case 4:
      return {-up, -along};
    case 5:
      return {-along, -up};
    case 6:
      return {along, -up};
    default:
      return {up, -along};
  }
}

bool CircleWalk::next() {
  if (columns_ == 0) return false;
  ++i_;
  // An odd octant ends on an axis, which the next one begins with; and begins on the diagonal,
  // which the one before may have given.
  while (octant_ < 8 && i_ >= columns_ - (octant_ & 1)) {
    ++octant_;
    i_ = octant_ & 1 && diagonal_ ? 1 : 0;
  }
  if (octant_ == 8 || (at_ == glm::ivec2(0) && columns_ == 1 && octant_ > 0)) return false;
  at_ = placed(i_);
  return true;
}

}  // namespace kinescope
