#include "engine/fractals/dla.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "raster/base/error.h"

namespace kinescope {

Aggregation::Aggregation(int side, std::uint64_t seed) : side_(side), random_(seed) {
  if (side < 16 || side > 4096) throw_bad_input("an aggregation's grid is 16 to 4096 wide");
  grid_.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  particles.emplace_back(side / 2, side / 2);
  grid_[index(side / 2, side / 2)] = 1;
}

glm::dvec2 Aggregation::on_circle(double radius) {
  const double angle = random_.uniform(0.0, 2.0 * std::numbers::pi);
  return glm::dvec2(side_ / 2) + radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

bool Aggregation::touches(const glm::ivec2& p) const {
  return occupied(p.x - 1, p.y) || occupied(p.x + 1, p.y) || occupied(p.x, p.y - 1) ||
         occupied(p.x, p.y + 1);
}

glm::ivec2 Aggregation::wander() {
  const double release = radius_ + 3.0;
  glm::dvec2 place = on_circle(release);
  while (true) {
    const glm::dvec2 out = place - glm::dvec2(side_ / 2);
    const double away = std::hypot(out.x, out.y);
    // Far out it is let go anew, as if it had wandered off and another had come.
    if (away > 3.0 * release + 20.0) {
      place = on_circle(release);
      continue;
    }
    // Nothing is nearer than this: a walk leaves the circle of that radius anywhere on it.
    const double clear = away - radius_ - 2.0;
    if (clear > 2.0) {
      const double angle = random_.uniform(0.0, 2.0 * std::numbers::pi);
      place += clear * glm::dvec2(std::cos(angle), std::sin(angle));
      continue;
    }
    const glm::ivec2 cell(static_cast<int>(std::lround(place.x)),
                          static_cast<int>(std::lround(place.y)));
    if (touches(cell)) return cell;
    const std::uint64_t direction = random_.bits() >> 62;
    constexpr int kStep[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    place = glm::dvec2(cell) + glm::dvec2(kStep[direction][0], kStep[direction][1]);
  }
}

bool Aggregation::next() {
  if (radius_ + 8.0 > side_ / 2) return false;
  const glm::ivec2 cell = wander();
  grid_[index(cell.x, cell.y)] = 1;
  particles.push_back(cell);
  radius_ = std::max(radius_, std::hypot(cell.x - side_ / 2, cell.y - side_ / 2));
  return true;
}

}  // namespace kinescope
