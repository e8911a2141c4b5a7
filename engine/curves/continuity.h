// How smoothly two curves meet, measured.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>

#include "engine/curves/bezier.h"

namespace kinescope {

/// Each class holds the ones before it.
enum class Continuity {
  kNone,
  kC0,  ///< the points meet
  kG1,  ///< and the directions
  kC1,  ///< and the speeds
  kC2,  ///< and the second derivatives
};

/// The end of one curve or the start of another: point and derivatives.
template <typename Vec>
struct CurveEnd {
  Vec point, first, second;
};

template <typename Vec>
struct JointMeasure {
  double gap = 0.0;          ///< between the points
  double turn_rad = 0.0;     ///< between the directions; pi where one curve stands still
  double speed_step = 0.0;   ///< length of the difference of first derivatives
  double second_step = 0.0;  ///< and of the second ones
  Continuity continuity = Continuity::kNone;
};

/// Differences up to `tolerance` of the larger of both ends' lengths count as none.
template <typename Vec>
JointMeasure<Vec> measure_joint(const CurveEnd<Vec>& before, const CurveEnd<Vec>& after,
                                double tolerance = 1e-9) {
  const auto near = [&](double difference, const Vec& a, const Vec& b) {
    return difference <= tolerance * std::max({1.0, glm::length(a), glm::length(b)});
  };
  JointMeasure<Vec> m;
  m.gap = glm::length(after.point - before.point);
  m.speed_step = glm::length(after.first - before.first);
  m.second_step = glm::length(after.second - before.second);
  const double a = glm::length(before.first), b = glm::length(after.first);
  m.turn_rad = std::acos(-1.0);
  if (a > 0.0 && b > 0.0) {
    const Vec u = before.first / a, v = after.first / b;
    m.turn_rad = 2.0 * std::atan2(glm::length(u - v), glm::length(u + v));  // also near 0 and pi
  }
  if (!near(m.gap, before.point, after.point)) return m;
  m.continuity = Continuity::kC0;
  const bool c1 = near(m.speed_step, before.first, after.first);
  if (m.turn_rad <= tolerance) m.continuity = Continuity::kG1;
  if (c1) m.continuity = Continuity::kC1;
  if (c1 && near(m.second_step, before.second, after.second)) m.continuity = Continuity::kC2;
  return m;
}

/// Point and derivatives of a Bezier curve at t.
template <typename Vec>
CurveEnd<Vec> bezier_at(std::span<const Vec> control, double t) {
  const std::vector<Vec> first = bezier_derivative(control);
  const std::vector<Vec> second = bezier_derivative(std::span<const Vec>(first));
  return {bezier_point(control, t), bezier_point(std::span<const Vec>(first), t),
          bezier_point(std::span<const Vec>(second), t)};
}

/// Of a plane curve: 1 over the radius of the circle that touches it there, positive where it turns
/// from x towards y; 0 where it stands still.
inline double curvature(const CurveEnd<glm::dvec2>& at) {
  const double speed = glm::length(at.first);
  if (!(speed > 0.0)) return 0.0;
  return (at.first.x * at.second.y - at.first.y * at.second.x) / (speed * speed * speed);
}

/// A Bezier curve's start or end; `length` is the stretch of parameter that it takes, to which its
/// derivatives refer.
template <typename Vec>
CurveEnd<Vec> bezier_end(std::span<const Vec> control, bool at_end, double length = 1.0) {
  const std::vector<Vec> first = bezier_derivative(control);
  const std::vector<Vec> second = bezier_derivative(std::span<const Vec>(first));
  const auto pick = [&](const auto& curve) { return at_end ? curve.back() : curve.front(); };
  return {pick(control), pick(first) / length, pick(second) / (length * length)};
}

/// The least continuous joint of Bezier pieces that follow one another; C2 if there is none.
template <typename Piece>
Continuity weakest_joint(std::span<const Piece> pieces) {
  using Vec = typename Piece::value_type;
  Continuity weakest = Continuity::kC2;
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const auto joint = measure_joint(bezier_end(std::span<const Vec>(pieces[i]), true),
                                     bezier_end(std::span<const Vec>(pieces[i + 1]), false));
    weakest = std::min(weakest, joint.continuity);
  }
  return weakest;
}

}  // namespace kinescope
