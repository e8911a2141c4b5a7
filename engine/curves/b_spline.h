// B-spline curves of any order over any knots.
// Source: de Boor, "On Calculating with B-Splines", 1972; Boehm, "Inserting New Knots into B-Spline
// Curves", 1980.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace kinescope {

/// Knots 0, 1, 2, ...: order + control points of them. The order is the degree and one.
std::vector<double> uniform_knots(int order, int controls);
/// The first and the last repeated `order` times, so that the curve reaches its end points; 0 to 1.
std::vector<double> open_knots(int order, int controls);

/// @throws Error (bad input) unless there are order >= 1, at least `order` control points, as many
///         knots as both together, finite and never falling, and a stretch of some length to draw
void check_knots(int order, int controls, std::span<const double> knots);

/// The interval [knots[i], knots[i + 1]) of some length that holds t, i from order - 1 to
/// controls - 1; t outside the curve's range takes the first or last.
std::size_t knot_interval(int order, int controls, std::span<const double> knots, double t);

/// Basis function i of the given order at t, by Cox and de Boor's recursion: the blending function
/// of control point i, zero outside knots[i] .. knots[i + order]. The last knot belongs to the last
/// interval of some length.
double b_spline_basis(int i, int order, std::span<const double> knots, double t);

/// Order, control points and knots. Plain data: check_knots says whether they fit together.
template <typename Vec>
struct BSpline {
  int order = 4;
  std::vector<Vec> control;
  std::vector<double> knots;

  int controls() const { return static_cast<int>(control.size()); }
  double first() const { return knots[static_cast<std::size_t>(order) - 1]; }
  double last() const { return knots[control.size()]; }
};

/// Every rung of de Boor's scheme at one parameter, as DeCasteljau is for Bezier curves: rung 0 are
/// the `order` control points that matter there.
template <typename Vec>
class DeBoor {
 public:
  /// @throws Error (bad input) as check_knots
  DeBoor(const BSpline<Vec>& spline, double t) : order_(static_cast<std::size_t>(spline.order)) {
    check_knots(spline.order, spline.controls(), spline.knots);
    t_ = std::clamp(t, spline.first(), spline.last());
    interval_ = knot_interval(spline.order, spline.controls(), spline.knots, t_);
    first_control_ = interval_ + 1 - order_;
    knots_ = spline.knots;
    const auto begin = spline.control.begin() + static_cast<std::ptrdiff_t>(first_control_);
    rungs_.emplace_back(begin, begin + spline.order);
  }

  /// Adds one rung; false once there is a single point.
  bool next() {
    const std::vector<Vec>& last = rungs_.back();
    if (last.size() == 1) return false;
    const std::size_t level = rungs_.size();
    std::vector<Vec> rung(last.size() - 1);
    for (std::size_t j = 0; j < rung.size(); ++j) {
      const std::size_t i = first_control_ + level + j;
      const double from = knots_[i], to = knots_[i + order_ - level];
      const double share = (t_ - from) / (to - from);
      rung[j] = (1.0 - share) * last[j] + share * last[j + 1];
    }
    rungs_.push_back(std::move(rung));
    return true;
  }

  const std::vector<std::vector<Vec>>& rungs() const { return rungs_; }
  std::size_t first_control() const { return first_control_; }
  std::size_t interval() const { return interval_; }

 private:
  std::size_t order_, interval_ = 0, first_control_ = 0;
  double t_ = 0.0;
  std::vector<double> knots_;
  std::vector<std::vector<Vec>> rungs_;
};

/// The point at t, which is held to the curve's range.
template <typename Vec>
Vec b_spline_point(const BSpline<Vec>& spline, double t) {
  DeBoor<Vec> ladder(spline, t);
  while (ladder.next()) {
  }
  return ladder.rungs().back()[0];
}

/// The same curve with one knot more, at t within its range. Boehm's algorithm.
template <typename Vec>
BSpline<Vec> with_knot(const BSpline<Vec>& spline, double t) {
  check_knots(spline.order, spline.controls(), spline.knots);
  const std::size_t k = knot_interval(spline.order, spline.controls(), spline.knots, t);
  const auto degree = static_cast<std::size_t>(spline.order) - 1;
  BSpline<Vec> more{spline.order, {}, spline.knots};
  more.knots.insert(more.knots.begin() + static_cast<std::ptrdiff_t>(k) + 1, t);
  for (std::size_t i = 0; i <= spline.control.size(); ++i) {
    if (i + degree <= k) {
      more.control.push_back(spline.control[i]);
    } else if (i > k) {
      more.control.push_back(spline.control[i - 1]);
    } else {
      const double from = spline.knots[i], to = spline.knots[i + degree];
      const double share = to > from ? (t - from) / (to - from) : 0.0;
      more.control.push_back((1.0 - share) * spline.control[i - 1] + share * spline.control[i]);
    }
  }
  return more;
}

/// One polynomial piece of a B-spline, as a Bezier curve over [from, to].
template <typename Vec>
struct BezierPiece {
  double from, to;
  std::vector<Vec> control;
};

/// The curve cut into its Bezier pieces: every knot within the range repeated until the control
/// points of each piece stand by themselves.
template <typename Vec>
std::vector<BezierPiece<Vec>> bezier_pieces(BSpline<Vec> spline) {
  check_knots(spline.order, spline.controls(), spline.knots);
  const double first = spline.first(), last = spline.last();
  std::vector<double> breaks(spline.knots);
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  std::erase_if(breaks, [&](double k) { return k < first || k > last; });
  const auto degree = static_cast<std::ptrdiff_t>(spline.order) - 1;
  for (const double at : breaks) {
    while (std::count(spline.knots.begin(), spline.knots.end(), at) < degree) {
      spline = with_knot(spline, at);
    }
  }
  std::vector<BezierPiece<Vec>> pieces;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    // Of the last knot equal to where the piece begins.
    const auto after = std::upper_bound(spline.knots.begin(), spline.knots.end(), breaks[i]);
    const auto begin = spline.control.begin() + (after - spline.knots.begin() - spline.order);
    pieces.push_back({breaks[i], breaks[i + 1], {begin, begin + spline.order}});
  }
  return pieces;
}

}  // namespace kinescope
