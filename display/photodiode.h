// A photodiode with its amplifier, before phosphor that a beam excites: a signal in closed form.
#pragma once

#include <span>
#include <vector>

#include "display/phosphor.h"

namespace kinescope {

/// The light that falls on it is a sum of decaying exponentials; its amplifier is a low-pass of one
/// pole (`rise`) behind which a capacitor (`coupling`) holds back what is steady. Times are in
/// pixel clocks. While excitation is steady everything is a sum of exponentials, so no step is too
/// long.
class Photodiode {
 public:
  /// @param layers in view; each gives its share of the light
  Photodiode(std::span<const Phosphor> layers, double clock_hz, Seconds rise, Seconds coupling);

  /// What a span of time does, worked out once.
  struct Span {
    double clocks = 0;
    std::vector<double> term_left;  // of each term
    double rise_left = 0, coupling_left = 0;
  };
  Span span(double clocks) const;

  /// @param doses_a_clock what the beam brings each layer in view; 1 is the dose of a white cell
  void pass(const Span& span, std::span<const double> doses_a_clock);
  /// Of a steady light of one dose a clock, had nothing held it back, it would be 1.
  double signal() const { return lagged_ - held_; }
  void darken();

 private:
  struct Term {
    std::size_t layer = 0;
    double share = 0, tau = 0;
    double after_rise = 0, after_coupling = 0;  // what the filters make of its exponential
    double light = 0;                           // what it gives now
  };
  std::vector<Term> terms_;
  double rise_, coupling_;
  double rise_after_coupling_ = 0;
  double lagged_ = 0, held_ = 0;  // behind the low-pass; on the capacitor
};

}  // namespace kinescope
