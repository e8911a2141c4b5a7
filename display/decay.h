// One decaying exponential excited by a beam that dwells: its light in closed form.
// R is light still to come; a dose of 1 is spread evenly over the dwell. Times in any one unit.
#pragma once

namespace kinescope {

/// 1 - exp(-q), exact for small q.
double one_minus_exp(double q);

/// exp(-t / tau) and 1 - exp(-t / tau), both to full precision, at the price of one.
struct Decayed {
  double left = 1, lost = 0;
};
Decayed decayed(double t, double tau);

/// The share of a dose that is still to come when its dwell ends: (1 - exp(-q)) / q, q = dwell/tau.
double left_after_dwell(double dwell, double tau);

/// Light of a unit dose in [begin, end) after its dwell began, 0 <= begin <= end.
double light_of_dose(double begin, double end, double dwell, double tau);

/// Light still to come of a unit dose `t` after its dwell began, of what was dosed by then.
double left_of_dose(double t, double dwell, double tau);

}  // namespace kinescope
