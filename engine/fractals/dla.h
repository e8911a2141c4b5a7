// Diffusion-limited aggregation on a square grid.
// Source: Witten and Sander, "Diffusion-Limited Aggregation, a Kinetic Critical Phenomenon", 1981.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "engine/fractals/random.h"

namespace kinescope {

/// A seed in the middle of a grid; particles wander in from a circle about the cluster and stay
/// where they first touch it.
class Aggregation {
 public:
  /// @param side of the grid, 16 to 4096. @throws Error (bad input) for other sizes
  Aggregation(int side, std::uint64_t seed);

  /// One more particle, from where it is let go to where it stays; false once the cluster has come
  /// near the grid's edge.
  bool next();

  bool occupied(int x, int y) const { return grid_[index(x, y)] != 0; }
  int side() const { return side_; }
  double radius() const { return radius_; }
  /// In the order of arrival, the seed first.
  std::vector<glm::ivec2> particles;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(x);
  }
  glm::dvec2 on_circle(double radius);
  bool touches(const glm::ivec2& p) const;
  glm::ivec2 wander();

  int side_;
  double radius_ = 0.0;
  std::vector<std::uint8_t> grid_;
  SeededRandom random_;
};

}  // namespace kinescope
