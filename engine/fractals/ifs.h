// Iterated function systems, drawn by the chaos game.
// Source: Barnsley, "Fractals Everywhere", 1988, ch. 3.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/fractals/random.h"

namespace kinescope {

/// One map, p' = m (x, y, 1), and how often the game takes it, in shares of any total.
struct IfsMap {
  glm::dmat3x2 map{1.0};
  double share = 1.0;
};
using Ifs = std::vector<IfsMap>;

/// Barnsley's fern, about 0 <= y <= 10.
Ifs fern_ifs();
/// Sierpinski's triangle with corners (0,0), (1,0), (1/2, sqrt(3)/2).
Ifs triangle_ifs();

/// Plays the game one move at a time.
class ChaosGame {
 public:
  /// @throws Error (bad input) without maps, or with shares that are not positive and finite
  ChaosGame(const Ifs& ifs, std::uint64_t seed);

  /// The next point of the attractor; the first twenty moves, on the way there, are made at once.
  /// A system that does not contract may lead to infinity: it then begins again at the origin.
  glm::dvec2 next();

  glm::dvec2 point{0.0};
  std::size_t taken = 0;  ///< the map of the last move

 private:
  void move();

  Ifs ifs_;
  double total_ = 0.0;
  SeededRandom random_;
};

/// Calls sink(point) so often.
template <typename Sink>
void chaos_game(const Ifs& ifs, std::uint64_t seed, int points, Sink&& sink) {
  ChaosGame game(ifs, seed);
  for (int i = 0; i < points; ++i) sink(game.next());
}

}  // namespace kinescope
