#include "display/photodiode.h"

#include <cmath>

namespace kinescope {
namespace {

/// A low-pass of time constant `slow` makes exp(-t / tau) this many times itself, and a rest.
double response(double slow, double tau) { return 1 / (1 - slow / tau); }

/// Equal time constants would make t exp(-t): they are kept apart by what no one can measure.
double apart(double tau, std::span<const double> others) {
  constexpr double kClose = 1e-4;
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (std::abs(tau / others[i] - 1) > kClose) continue;
    tau *= 1 + 3 * kClose;
    i = static_cast<std::size_t>(-1);  // from the first again
  }
  return tau;
}

}  // namespace

Photodiode::Photodiode(std::span<const Phosphor> layers, double clock_hz, Seconds rise,
                       Seconds coupling) {
  double all = 0;
  for (const Phosphor& layer : layers) all += layer.share;
  std::vector<double> taus;
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    for (const DecayTerm& term : layers[layer].terms) {
      taus.push_back(term.tau.count() * clock_hz);
      terms_.push_back({layer, term.share * layers[layer].share / all, taus.back()});
    }
  }
  rise_ = apart(rise.count() * clock_hz, taus);
  taus.push_back(rise_);
  coupling_ = apart(coupling.count() * clock_hz, taus);
  for (Term& term : terms_) {
    term.after_rise = response(rise_, term.tau);
    term.after_coupling = term.after_rise * response(coupling_, term.tau);
  }
  rise_after_coupling_ = response(coupling_, rise_);
}

Photodiode::Span Photodiode::span(double clocks) const {
  Span span{clocks, {}, std::exp(-clocks / rise_), std::exp(-clocks / coupling_)};
  for (const Term& term : terms_) span.term_left.push_back(std::exp(-clocks / term.tau));
  return span;
}

void Photodiode::pass(const Span& span, std::span<const double> doses_a_clock) {
  double steady = 0;                        // what all tends to
  double lagged_start = 0, held_start = 0;  // of the terms' parts, then at the end
  double lagged_end = 0, held_end = 0;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    Term& term = terms_[i];
    const double to = doses_a_clock[term.layer] * term.share;
    const double start = term.light - to, end = start * span.term_left[i];
    steady += to;
    lagged_start += start * term.after_rise;
    lagged_end += end * term.after_rise;
    held_start += start * term.after_coupling;
    held_end += end * term.after_coupling;
    term.light = to + end;
  }
  const double rising = lagged_ - steady - lagged_start;
  const double rising_held = rising * rise_after_coupling_;
  const double holding = held_ - steady - held_start - rising_held;
  lagged_ = steady + lagged_end + rising * span.rise_left;
  held_ = steady + held_end + rising_held * span.rise_left + holding * span.coupling_left;
}

void Photodiode::darken() {
  for (Term& term : terms_) term.light = 0;
  lagged_ = held_ = 0;
}

}  // namespace kinescope
