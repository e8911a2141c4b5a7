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
  /// While the current changes by more than this share of the full one, a piece lasts for so many
  /// time constants of it.
  static constexpr double kCoarseChange = 0.05, kCoarseTaus = 3;
  /// Fainter beams grow no sharper.
  static constexpr float kLeastGrown = 0.02f;

  /// The beam at a time.
  struct State {
    double t;
    Transient x, y;
    float current;
  };
  /// Of a span: the greatest current and its spot's deviation in the middle of the screen; how the
  /// spot has grown when the current has settled.
  struct Full {
    float current;
    double sigma, grown;
  };
  /// A rule for pieces of one length: where its spots are in time, and what carries transients on
  /// until then.
  struct Rule {
    double length = -1;
    int spots = 0;
    std::array<double, BeamSpots::kMost> time{};
    std::array<float, BeamSpots::kMost> share{};
    Settling::Step whole{};
    std::array<Settling::Step, Settling::kSteps> step{};
  };
  /// A rule for a current that rises from none, or fades to none, of 1.
  struct Pulse {
    Rule rule;
    float mean = 0;  // the current, of a rise's whole
    std::array<float, BeamSpots::kMost> grown{};
  };

  State at(const BeamSpan& span, double t) const;
  State carried_on(const BeamSpan& span, const State& state, double by,
                   const Settling::Step& step) const;
  Full full_of(const BeamSpan& span) const;
  double even_length(const BeamSpan& span, const State& state, const Full& full,
                     double turns) const;
  void add_even(const BeamSpan& span, double length, double to, State& state,
                std::vector<BeamPiece>& pieces) const;
  /// @param rule of the last piece, or of none; brought up to date
  void add_spots(const BeamSpan& span, const Full& full, double turns, double to, State& state,
                 Rule& rule, std::vector<BeamPiece>& pieces) const;
  void add_pulse(const BeamSpan& span, const Pulse& pulse, const Full& full, double to,
                 State& state, std::vector<BeamPiece>& pieces) const;
  /// How long a piece of spots is, and how far the beam goes in it, deviations.
  struct Reached {
    double length, way;
  };
  Reached spots_length(const BeamSpan& span, const State& state, const Full& full,
                       double longest) const;
  int spots_for(double way, double turns, double lacks, double length, const Full& full) const;
  double way(const BeamSpan& span, const State& state, double time) const;
  Rule rule_of(double length, int spots) const;
  Pulse rise_pulse() const;
  Pulse fade_pulse() const;
  /// @return the pulse that begins at a state, if it is one
  const Pulse* pulse_at(const BeamSpan& span, const State& state, const Full& full,
                        double left) const;
  BeamPiece even_piece(const BeamSpan& span, const State& from, const State& to) const;
  void place_spots(const BeamSpan& span, const State& from, const Rule& rule,
                   BeamPiece& piece) const;
  BeamPiece spots_piece(const BeamSpan& span, const State& from, const State& to, const Rule& rule,
                        const Full& full) const;
  BeamPiece pulse_piece(const BeamSpan& span, const State& from, const Pulse& pulse,
                        const Full& full) const;
  float mean_current(const BeamSpan& span, const State& from, const State& to) const;
  double change(const BeamSpan& span, const State& state, const Full& full) const;
  /// Times the spot's usual width: by the current, and by the place.
  double grown(float current) const;
  double spread_at(double x, double y) const;

  double width_, height_, sigma_;  // device units
  double growth_, edge_spread_, tau_;
  Settling settling_;
  float least_grown_;
  Pulse rise_, fade_;
};

}  // namespace kinescope
