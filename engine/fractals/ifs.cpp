#include "engine/fractals/ifs.h"

#include "raster/base/error.h"

namespace kinescope {

Ifs fern_ifs() {
  return {{{0, 0, 0, 0.16, 0, 0}, 0.01},
          {{0.85, -0.04, 0.04, 0.85, 0, 1.6}, 0.85},
          {{0.2, 0.23, -0.26, 0.22, 0, 1.6}, 0.07},
          {{-0.15, 0.26, 0.28, 0.24, 0, 0.44}, 0.07}};
}

Ifs triangle_ifs() {
  return {{{0.5, 0, 0, 0.5, 0, 0}, 1},
          {{0.5, 0, 0, 0.5, 0.5, 0}, 1},
          {{0.5, 0, 0, 0.5, 0.25, 0.25 * std::sqrt(3.0)}, 1}};
}

ChaosGame::ChaosGame(const Ifs& ifs, std::uint64_t seed) : ifs_(ifs), random_(seed) {
  for (const IfsMap& map : ifs_) {
    if (!(map.share > 0.0)) throw_bad_input("each map of a function system needs a share above 0");
    total_ += map.share;
  }
  if (!(total_ > 0.0 && std::isfinite(total_))) {
    throw_bad_input("a function system needs at least one map");
  }
  for (int i = 0; i < 20; ++i) move();
}

void ChaosGame::move() {
  double pick = random_.uniform() * total_;
  taken = 0;
  while (taken + 1 < ifs_.size() && pick >= ifs_[taken].share) pick -= ifs_[taken++].share;
  point = ifs_[taken].map * glm::dvec3(point, 1.0);
  if (!(std::abs(point.x) < 1e100 && std::abs(point.y) < 1e100)) point = glm::dvec2(0.0);
}

glm::dvec2 ChaosGame::next() {
  move();
  return point;
}

}  // namespace kinescope
