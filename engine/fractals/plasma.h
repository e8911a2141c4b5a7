// Plasma, clouds and landscapes by displacing midpoints of squares.
// Source: Fournier, Fussell, Carpenter, "Computer Rendering of Stochastic Models", 1982.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/fractals/random.h"

namespace kinescope {

/// Heights on a square grid, row by row; as many on a side as a power of two and one.
struct HeightField {
  int side = 2;
  std::vector<double> height;

  double& at(int column, int row) { return height[index(column, row)]; }
  double at(int column, int row) const { return height[index(column, row)]; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
           static_cast<std::size_t>(column);
  }
};

/// The diamond-square algorithm: centres of squares, then centres of diamonds, then half the size.
class DiamondSquare {
 public:
  /// @param levels the side is 2^levels + 1, levels 0 to 12
  /// @param hurst  1 is smooth, 0 is rough; the surface's dimension is 3 - hurst
  /// @throws Error (bad input) for other levels, or a hurst that is not within [0, 1]
  DiamondSquare(int levels, double hurst, std::uint64_t seed);

  /// One half-generation; false once the grid is full.
  bool next();

  /// The place at or nearest to (column, row) whose height is made: corners, and centres of squares
  /// between the two halves of a generation.
  glm::ivec2 nearest_made(int column, int row) const;
  /// Between the corners made, evenly; x and y within the grid.
  double height_between(double x, double y) const;

  HeightField field;           ///< heights not yet made are 0
  int stride;                  ///< between the heights made
  bool diamonds_next = false;  ///< squares have their centres; the diamonds want theirs

 private:
  void squares();
  void diamonds();

  double deviation_, fall_;
  SeededRandom random_;
};

HeightField plasma(int levels, double hurst, std::uint64_t seed);

/// Calls sink(a, b, c) for two triangles a cell over the unit square, height along z times
/// `relief`, counter-clockwise seen from above; what lies below `sea` is drawn at it.
template <typename Sink>
void landscape_triangles(const HeightField& field, double relief, double sea, Sink&& sink) {
  const double cell = 1.0 / (field.side - 1);
  const auto corner = [&](int i, int j) {
    const double h = field.at(i, j);
    return glm::dvec3(i * cell, j * cell, relief * (h > sea ? h : sea));
  };
  for (int j = 0; j + 1 < field.side; ++j) {
    for (int i = 0; i + 1 < field.side; ++i) {
      const glm::dvec3 a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                       d = corner(i, j + 1);
      sink(a, b, c);
      sink(a, c, d);
    }
  }
}

}  // namespace kinescope
