// Cuts what a real beam does into pieces of light: even strokes where it is even, and else spots by
// Gauss's and Legendre's rule in time.
#pragma once

#include <array>
#include <vector>

#include "display/vector/beam_span.h"
#include "display/vector/machine.h"

namespace kinescope {

DeflectionLaw deflection_law(const VectorMachine& machine);
/// Of a current that comes to what is asked for, seconds; 0: at once.
double current_tau(const VectorMachine& machine);
/// The current a time after it was `current`.
float current_after(double t, float current, float aim, double tau);

class BeamCutter {
 public:
  explicit BeamCutter(const VectorMachine& machine);

  /// Adds the pieces of [from, to) of a span; their energy is the current's. Spans are independent
  /// of each other.
  void cut(const BeamSpan& span, double from, double to, std::vector<BeamPiece>& pieces) const;

 private:
  /// The beam at a time.
  struct State {
    double t;
    Transient x, y;
    float current;
  };
  /// How the next piece is to be cut.
  struct Plan {
    double length;  // seconds
    double way;     // deviations
    bool even;      // a stroke, else spots
    int least_spots;
  };
  /// What carries transients on within pieces of one length.
  struct Steps {
    double length = -1;
    int spots = 0;
    Settling::Step whole;
    std::array<Settling::Step, BeamSpots::kMost> node;
  };

  State at(const BeamSpan& span, double t) const;
  State carried_on(const BeamSpan& span, const State& state, double by,
                   const Settling::Step& step) const;
  Plan plan(const BeamSpan& span, const State& state, double left) const;
  double spots_length(const BeamSpan& span, const State& state, double sigma, double change) const;
  void make_steps(double length, int spots, Steps& steps) const;
  BeamPiece even_piece(const BeamSpan& span, const State& from, const State& to) const;
  BeamPiece spots_piece(const BeamSpan& span, const State& from, const State& to,
                        const Steps& steps) const;
  float mean_current(const BeamSpan& span, const State& from, const State& to) const;
  /// Times the spot's usual width: by the current, and by the place.
  double grown(float current) const;
  double spread_at(double x, double y) const;

  double width_, height_, sigma_;  // device units
  double growth_, edge_spread_, tau_;
  Settling settling_;
};

}  // namespace kinescope
