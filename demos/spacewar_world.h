// A duel of two ships about a star.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "raster/base/units.h"

namespace kinescope {

struct SpacewarShip {
  glm::dvec2 place{0}, speed{0};  ///< device units, units a second
  double heading_rad = 0;         ///< from the right, counterclockwise
  bool turns_left = false, turns_right = false, thrusts = false, fires = false;
  Seconds dead_for{0};  ///< until it comes back
  int hits = 0;         ///< of the other one
};

struct Torpedo {
  glm::dvec2 place, speed;
  Seconds left;
  int owner;
};

/// The screen is a torus of 4096 units. Ships and torpedoes fall towards the star in its middle.
class SpacewarWorld {
 public:
  static constexpr double kSize = 4096, kStarRadius = 60;

  explicit SpacewarWorld(std::uint64_t seed);
  /// In steps of 1/240 s, whatever the length asked for.
  void run_to(Seconds end, bool gravity);

  std::array<SpacewarShip, 2> ships;
  std::vector<Torpedo> torpedoes;

  /// Of a ship, by unit mass: it stays the same while nobody thrusts.
  double energy(int ship) const;

 private:
  void step(bool gravity);
  void place(int ship);

  double angle_rad_;
  std::int64_t steps_ = 0;
};

}  // namespace kinescope
