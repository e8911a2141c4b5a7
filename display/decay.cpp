#include "display/decay.h"

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

constexpr double kGone = 40;  // exp(-40) = 4e-18; also keeps what is computed with from denormals

/// 1 - (1 - exp(-q)) / q, by series where the two nearly cancel.
double lost_during_dwell(double q) {
  if (q > 0.1) return 1 - one_minus_exp(q) / q;
  double term = q / 2, sum = term;
  for (int n = 3; n < 12; ++n) sum += term *= -q / n;
  return sum;
}

}  // namespace

double one_minus_exp(double q) { return -std::expm1(-q); }

Decayed decayed(double t, double tau) {
  const double q = t / tau;
  if (q > kGone) return {0, 1};
  if (q > 0.5) {
    const double left = std::exp(-q);
    return {left, 1 - left};
  }
  const double lost = one_minus_exp(q);
  return {1 - lost, lost};
}

double left_after_dwell(double dwell, double tau) {
  const double q = dwell / tau;
  return q > 0 ? one_minus_exp(q) / q : 1;
}

double left_of_dose(double t, double dwell, double tau) {
  if (t <= dwell) return tau / dwell * one_minus_exp(t / tau);
  return left_after_dwell(dwell, tau) * std::exp(-(t - dwell) / tau);
}

double light_of_dose(double begin, double end, double dwell, double tau) {
  double light = 0;
  if (begin < dwell) {
    const double cut = std::min(end, dwell);
    const double span = cut - begin;
    light = left_of_dose(begin, dwell, tau) * one_minus_exp(span / tau) +
            span / dwell * lost_during_dwell(span / tau);
    begin = cut;
  }
  if (end > begin) light += left_of_dose(begin, dwell, tau) * one_minus_exp((end - begin) / tau);
  return light;
}

}  // namespace kinescope
