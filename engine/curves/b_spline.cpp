#include "engine/curves/b_spline.h"

#include <cmath>

#include "raster/base/error.h"

namespace kinescope {

std::vector<double> uniform_knots(int order, int controls) {
  std::vector<double> knots;
  for (int i = 0; i < order + controls; ++i) knots.push_back(i);
  return knots;
}

std::vector<double> open_knots(int order, int controls) {
  std::vector<double> knots;
  const int pieces = controls - order + 1;
  for (int i = 0; i < order + controls; ++i) {
    knots.push_back(static_cast<double>(std::clamp(i - order + 1, 0, pieces)) / pieces);
  }
  return knots;
}

void check_knots(int order, int controls, std::span<const double> knots) {
  if (order < 1) throw_bad_input("a B-spline's order is at least 1");
  if (controls < order) throw_bad_input("a B-spline needs as many control points as its order");
  if (knots.size() != static_cast<std::size_t>(order) + static_cast<std::size_t>(controls)) {
    throw_bad_input("a B-spline needs as many knots as its order and control points together");
  }
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i]) || (i > 0 && knots[i] < knots[i - 1])) {
      throw_bad_input("knots are numbers that never fall");
    }
  }
  if (!(knots[static_cast<std::size_t>(order) - 1] < knots[static_cast<std::size_t>(controls)])) {
    throw_bad_input("the knots leave the curve no length");
  }
}

std::size_t knot_interval(int order, int controls, std::span<const double> knots, double t) {
  auto i = static_cast<std::size_t>(order) - 1;
  const auto last = static_cast<std::size_t>(controls) - 1;
  const auto above = std::upper_bound(knots.begin(), knots.end(), t) - knots.begin();
  i = std::clamp(static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - 1, 0)), i, last);
  while (knots[i] == knots[i + 1] && i > static_cast<std::size_t>(order) - 1) --i;
  while (knots[i] == knots[i + 1] && i < last) ++i;
  return i;
}

double b_spline_basis(int i, int order, std::span<const double> knots, double t) {
  const auto at = [&](int k) { return knots[static_cast<std::size_t>(k)]; };
  if (order == 1) {
    const bool at_end = t == knots.back() && at(i + 1) == t && at(i) < t;
    return (at(i) <= t && t < at(i + 1)) || at_end ? 1.0 : 0.0;
  }
  double sum = 0.0;
  const double left = at(i + order - 1) - at(i), right = at(i + order) - at(i + 1);
  if (left > 0.0) sum += (t - at(i)) / left * b_spline_basis(i, order - 1, knots, t);
  if (right > 0.0) sum += (at(i + order) - t) / right * b_spline_basis(i + 1, order - 1, knots, t);
  return sum;
}

}  // namespace kinescope
