// Polar coordinates of the plane, cylindrical and spherical ones of space, and both plane grids.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "engine/transform/exact_angle.h"

namespace kinescope {

/// Angle counter-clockwise from +x, in (-pi, pi].
struct Polar {
  double radius = 0.0;
  double angle_rad = 0.0;
};
inline Polar polar_from_cartesian(const glm::dvec2& p) {
  return {std::hypot(p.x, p.y), std::atan2(p.y, p.x)};
}
inline glm::dvec2 cartesian_from_polar(const Polar& p) {
  return {p.radius * std::cos(p.angle_rad), p.radius * std::sin(p.angle_rad)};
}

/// About the z axis.
struct Cylindrical {
  double radius = 0.0, angle_rad = 0.0, height = 0.0;
};
inline Cylindrical cylindrical_from_cartesian(const glm::dvec3& p) {
  return {std::hypot(p.x, p.y), std::atan2(p.y, p.x), p.z};
}
inline glm::dvec3 cartesian_from_cylindrical(const Cylindrical& p) {
  return {p.radius * std::cos(p.angle_rad), p.radius * std::sin(p.angle_rad), p.height};
}

/// Azimuth from +x about z, inclination from +z in [0, pi].
struct Spherical {
  double radius = 0.0, azimuth_rad = 0.0, inclination_rad = 0.0;
};
inline Spherical spherical_from_cartesian(const glm::dvec3& p) {
  const double across = std::hypot(p.x, p.y);
  return {std::hypot(across, p.z), std::atan2(p.y, p.x), std::atan2(across, p.z)};
}
inline glm::dvec3 cartesian_from_spherical(const Spherical& p) {
  const double across = p.radius * std::sin(p.inclination_rad);
  return {across * std::cos(p.azimuth_rad), across * std::sin(p.azimuth_rad),
          p.radius * std::cos(p.inclination_rad)};
}

/// Calls sink(from, to) for the lines x and y = multiples of `step` within [-extent, extent].
template <typename Sink>
void cartesian_grid(double extent, double step, Sink&& sink) {
  const auto lines = static_cast<int>(std::min(1e4, std::max(0.0, std::floor(extent / step))));
  for (int i = -lines; i <= lines; ++i) {
    const double at = i * step;
    sink(glm::dvec2(at, -extent), glm::dvec2(at, extent));
    sink(glm::dvec2(-extent, at), glm::dvec2(extent, at));
  }
}

/// Calls sink(from, to) for circles of radius step, 2 step, ... up to extent, each of `chords`
/// chords, and for `rays` rays from the pole.
template <typename Sink>
void polar_grid(double extent, double step, int rays, int chords, Sink&& sink) {
  const auto at = [](double radius, double part) {
    const auto [s, c] = sine_cosine_deg(360.0 * part);
    return glm::dvec2(radius * c, radius * s);
  };
  const auto circles = static_cast<int>(std::min(1e4, std::max(0.0, std::floor(extent / step))));
  for (int i = 1; i <= circles; ++i) {
    for (int k = 0; k < chords; ++k) {
      sink(at(i * step, 1.0 * k / chords), at(i * step, (k + 1.0) / chords));
    }
  }
  for (int k = 0; k < rays; ++k) sink(glm::dvec2(0.0), at(extent, 1.0 * k / rays));
}

}  // namespace kinescope
