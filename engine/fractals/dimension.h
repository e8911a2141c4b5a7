// Fractal dimensions: by similarity, by covering boxes, and the fit that both measurements share.
// Source: Falconer, "Fractal Geometry", 1990, ch. 3.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace kinescope {

/// Of a figure made of `copies` of itself, each `ratio` times as large: log copies / log (1 /
/// ratio).
inline double similarity_dimension(double copies, double ratio) {
  return std::log(copies) / -std::log(ratio);
}

/// Of a figure made of copies of itself of several ratios: the d with sum of ratio^d = 1.
/// @return infinity unless there are two or more ratios above 0, all below 1. Source: Moran, 1946
double moran_dimension(std::span<const double> ratios);

/// How many pieces of what size were needed.
struct Covering {
  double size = 0.0;
  double count = 0.0;
};

/// Least squares of log count over -log size: the slope is the dimension.
struct DimensionFit {
  double dimension = 0.0;
  double correlation = 0.0;  ///< of the logarithms: near 1 if the figure is a fractal there
};
/// Sizes and counts that are not positive are passed over; all 0 with fewer than two.
DimensionFit fit_dimension(std::span<const Covering> coverings);

/// The boxes of a grid that hold a point, for each size.
std::vector<Covering> count_boxes(std::span<const glm::dvec2> points,
                                  std::span<const double> sizes);

/// Of a cluster, by how its radius of gyration grows with its particles, in their order of arrival:
/// as N^(1 / dimension). 0 for fewer than 32.
double gyration_dimension(std::span<const glm::ivec2> particles);

/// Points no further apart than `spacing` along a segment, for counting the boxes of a line.
template <typename Sink>
void points_along(const glm::dvec2& from, const glm::dvec2& to, double spacing, Sink&& sink) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const auto steps = static_cast<int>(std::fmin(1e6, std::fmax(1.0, std::ceil(length / spacing))));
  for (int i = 0; i < steps; ++i) sink(from + (static_cast<double>(i) / steps) * (to - from));
}

/// The length of a coast, walked with a pair of dividers.
struct RulerWalk {
  double ruler = 0.0;
  double steps = 0.0;  ///< the last one a part
  double length = 0.0;
  std::vector<glm::dvec2> feet;  ///< where the dividers stood
};
/// Each foot is where the coast first leaves the ruler's circle about the last one.
/// @throws Error (bad input) for a ruler that is not positive, or needs more than 10^7 steps
/// Source: Mandelbrot, "How Long Is the Coast of Britain?", 1967.
RulerWalk walk_coast(std::span<const glm::dvec2> coast, double ruler);

}  // namespace kinescope
