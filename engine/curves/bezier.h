// Bezier curves of any degree: de Casteljau's ladder, Bernstein's polynomials, subdivision.
// Source: Farin, "Curves and Surfaces for CAGD", 5th ed., 2002, ch. 4 and 5.
#pragma once

#include <cassert>
#include <cmath>
#include <span>
#include <vector>

namespace kinescope {

/// Every rung of de Casteljau's scheme at one parameter: rung 0 are the control points, the last is
/// the point of the curve. The left sides are the control points of the part before, the right
/// sides of the part after.
template <typename Vec>
class DeCasteljau {
 public:
  DeCasteljau(std::span<const Vec> control, double t) : t_(t) {
    assert(!control.empty());
    rungs_.emplace_back(control.begin(), control.end());
  }

  /// Adds one rung; false once there is a single point.
  bool next() {
    const std::vector<Vec>& last = rungs_.back();
    if (last.size() == 1) return false;
    std::vector<Vec> rung(last.size() - 1);
    for (std::size_t i = 0; i < rung.size(); ++i) {
      rung[i] = (1.0 - t_) * last[i] + t_ * last[i + 1];
    }
    rungs_.push_back(std::move(rung));
    return true;
  }

  const std::vector<std::vector<Vec>>& rungs() const { return rungs_; }
  double t() const { return t_; }

 private:
  double t_;
  std::vector<std::vector<Vec>> rungs_;
};

/// The point at t, by de Casteljau's scheme.
template <typename Vec>
Vec bezier_point(std::span<const Vec> control, double t) {
  assert(!control.empty());
  std::vector<Vec> p(control.begin(), control.end());
  for (std::size_t n = p.size() - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) p[i] = (1.0 - t) * p[i] + t * p[i + 1];
  }
  return p[0];
}

/// The Bernstein polynomials of a degree at t: the weights of degree + 1 control points.
inline std::vector<double> bernstein(int degree, double t) {
  assert(degree >= 0);
  std::vector<double> weight(static_cast<std::size_t>(degree) + 1, 0.0);
  weight[0] = 1.0;
  for (std::size_t n = 1; n < weight.size(); ++n) {
    for (std::size_t i = n; i > 0; --i) weight[i] = (1.0 - t) * weight[i] + t * weight[i - 1];
    weight[0] *= 1.0 - t;
  }
  return weight;
}

/// The point at t as the weighted sum of the control points.
template <typename Vec>
Vec bezier_point_by_weights(std::span<const Vec> control, double t) {
  const std::vector<double> weight = bernstein(static_cast<int>(control.size()) - 1, t);
  Vec sum = weight[0] * control[0];
  for (std::size_t i = 1; i < control.size(); ++i) sum += weight[i] * control[i];
  return sum;
}

template <typename Vec>
struct BezierHalves {
  std::vector<Vec> before, after;
};
/// Cut at t into two curves of the same degree.
template <typename Vec>
BezierHalves<Vec> bezier_split(std::span<const Vec> control, double t) {
  assert(!control.empty());
  BezierHalves<Vec> halves;
  std::vector<Vec>& p = halves.after;
  p.assign(control.begin(), control.end());
  halves.before.push_back(p[0]);
  for (std::size_t n = p.size() - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) p[i] = (1.0 - t) * p[i] + t * p[i + 1];
    halves.before.push_back(p[0]);
  }
  return halves;
}

/// The part from t0 to t1.
template <typename Vec>
std::vector<Vec> bezier_part(std::span<const Vec> control, double t0, double t1) {
  const std::vector<Vec> before = bezier_split(control, t1).before;
  return t1 > 0.0 ? bezier_split(std::span<const Vec>(before), t0 / t1).after : before;
}

/// The derivative, a curve of one degree less; a point's is zero.
template <typename Vec>
std::vector<Vec> bezier_derivative(std::span<const Vec> control) {
  if (control.size() < 2) return {Vec(0.0)};
  std::vector<Vec> slope(control.size() - 1);
  const auto degree = static_cast<double>(slope.size());
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = degree * (control[i + 1] - control[i]);
  return slope;
}

/// The same curve with one control point more.
template <typename Vec>
std::vector<Vec> bezier_elevated(std::span<const Vec> control) {
  assert(!control.empty());
  std::vector<Vec> more(control.size() + 1);
  const auto n = static_cast<double>(control.size());
  more.front() = control.front();
  more.back() = control.back();
  for (std::size_t i = 1; i < control.size(); ++i) {
    const double share = static_cast<double>(i) / n;
    more[i] = share * control[i - 1] + (1.0 - share) * control[i];
  }
  return more;
}

/// Calls sink(from, to) for chords, halving until the control points lie within `tolerance` of
/// where a straight line evenly passed would have them; at most 2^16 chords.
template <typename Vec, typename Sink>
void bezier_chords(std::span<const Vec> control, double tolerance, Sink&& sink, int depth = 16) {
  const auto straight = [&] {
    for (std::size_t i = 1; i + 1 < control.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(control.size() - 1);
      const Vec off = control[i] - ((1.0 - share) * control.front() + share * control.back());
      for (int k = 0; k < off.length(); ++k) {
        if (std::abs(off[k]) > tolerance) return false;
      }
    }
    return true;
  };
  if (depth == 0 || straight()) {
    sink(control.front(), control.back());
    return;
  }
  const BezierHalves<Vec> halves = bezier_split(control, 0.5);
  bezier_chords(std::span<const Vec>(halves.before), tolerance, sink, depth - 1);
  bezier_chords(std::span<const Vec>(halves.after), tolerance, sink, depth - 1);
}

}  // namespace kinescope
