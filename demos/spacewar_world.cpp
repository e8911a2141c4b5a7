#include "demos/spacewar_world.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

namespace kinescope {
namespace {

constexpr double kStep_s = 1.0 / 240;
constexpr double kStar = 1.2e8;  // gravity times mass, units^3 / s^2
constexpr double kThrust = 160, kTurnRate = 2.5, kTorpedoSpeed = 900, kOrbit = 1200, kNear = 75;
constexpr Seconds kTorpedoLife(2), kDeath(2);
const glm::dvec2 kMiddle{SpacewarWorld::kSize / 2, SpacewarWorld::kSize / 2};

glm::dvec2 pull(glm::dvec2 place) {
  const glm::dvec2 to = kMiddle - place;
  const double r = std::max(glm::length(to), SpacewarWorld::kStarRadius);
  return to * (kStar / (r * r * r));
}
glm::dvec2 wrapped(glm::dvec2 p) {
  const double s = SpacewarWorld::kSize;
  return {p.x - s * std::floor(p.x / s), p.y - s * std::floor(p.y / s)};
}
glm::dvec2 direction(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

/// Velocity Verlet: an orbit keeps its energy.
void fall(glm::dvec2& place, glm::dvec2& speed, bool gravity) {
  if (gravity) speed += pull(place) * (0.5 * kStep_s);
  place = wrapped(place + speed * kStep_s);
  if (gravity) speed += pull(place) * (0.5 * kStep_s);
}

}  // namespace

SpacewarWorld::SpacewarWorld(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  angle_rad_ = static_cast<double>(random() % 3600) * std::numbers::pi / 1800;
  for (const int i : {0, 1}) place(i);
}

/// On a circle about the star.
void SpacewarWorld::place(int ship) {
  SpacewarShip& s = ships[static_cast<std::size_t>(ship)];
  const double angle = angle_rad_ + ship * std::numbers::pi;
  s.place = kMiddle + kOrbit * direction(angle);
  s.heading_rad = angle + std::numbers::pi / 2;
  s.speed = std::sqrt(kStar / kOrbit) * direction(s.heading_rad);
  s.dead_for = Seconds(0);
}

double SpacewarWorld::energy(int ship) const {
  const SpacewarShip& s = ships[static_cast<std::size_t>(ship)];
  return 0.5 * glm::dot(s.speed, s.speed) - kStar / glm::length(s.place - kMiddle);
}

void SpacewarWorld::run_to(Seconds end, bool gravity) {
  const auto until = static_cast<std::int64_t>(end.count() / kStep_s + 1e-6);
  while (steps_ < until) step(gravity), ++steps_;
}

void SpacewarWorld::step(bool gravity) {
  for (const int i : {0, 1}) {
    SpacewarShip& s = ships[static_cast<std::size_t>(i)];
    if (s.dead_for > Seconds(0)) {
      s.dead_for -= Seconds(kStep_s);
      if (s.dead_for <= Seconds(0)) place(i);
      continue;
    }
    s.heading_rad += kTurnRate * kStep_s * ((s.turns_left ? 1 : 0) - (s.turns_right ? 1 : 0));
    if (s.thrusts) s.speed += direction(s.heading_rad) * (kThrust * kStep_s);
    fall(s.place, s.speed, gravity);
    if (s.fires) {
      const glm::dvec2 ahead = direction(s.heading_rad);
      torpedoes.push_back(
          {s.place + 1.5 * kNear * ahead, s.speed + kTorpedoSpeed * ahead, kTorpedoLife, i});
      s.fires = false;
    }
    if (glm::length(s.place - kMiddle) < kStarRadius) s.dead_for = kDeath;
  }
  for (Torpedo& t : torpedoes) {
    fall(t.place, t.speed, gravity);
    t.left -= Seconds(kStep_s);
    for (SpacewarShip& s : ships) {
      if (s.dead_for > Seconds(0) || glm::length(s.place - t.place) > kNear) continue;
      s.dead_for = kDeath;
      t.left = Seconds(0);
      SpacewarShip& owner = ships[static_cast<std::size_t>(t.owner)];
      if (&owner != &s) ++owner.hits;
    }
  }
  std::erase_if(torpedoes, [](const Torpedo& t) { return t.left <= Seconds(0); });
}

}  // namespace kinescope
