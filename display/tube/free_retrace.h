// The light of the blanked beam of a raster whose sweeps land anew each time: it flies back where
// its own oscillators send it, whatever the video does. Excited once, it fades where it lies.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "display/phosphor.h"
#include "display/tube/afterglow.h"
#include "display/tube/beam_flight.h"
#include "display/tube/free_sweep.h"
#include "display/tube/gun.h"
#include "display/tube/sweep_warp.h"

namespace kinescope {

class FreeRetrace {
 public:
  /// @param gun whose beam flies back, blanked
  /// @param laws of the layers' phosphors
  FreeRetrace(const TubeSettings& settings, const Gun& gun, std::span<const Phosphor> laws,
              int width, int height);

  /// The light of a field's flights in [begin, end), sweep clocks, added to `sum`; what is left of
  /// it then passes to the afterglow.
  void pass(const FreeSweep& sweep, const SweptField& field, const SweepWarp& warp, BeamTime begin,
            BeamTime end, Afterglow& afterglow, LightOverlay& sum, Workers& workers);

 private:
  struct Window;
  Place sweep_at(const Window& w, double clock) const;
  void follow(const Window& w, double begin, double length, bool drawn);
  void follow_fields_lines(const Window& w);
  void add_light(Afterglow& afterglow, LightOverlay& sum, Workers& workers);
  struct TermPlace {
    std::size_t layer, term;
    DecayTerm law;
  };
  std::vector<TermPlace> terms_by_time() const;
  void weigh(const std::vector<TermPlace>& terms);
  void leave_terms(const std::vector<TermPlace>& terms, std::size_t first, Afterglow& afterglow,
                   LightOverlay& sum, Workers& workers);

  TubeSettings settings_;
  std::vector<Phosphor> laws_;
  FlightPath path_;
  FlightPainter painter_;
  std::array<double, 2> current_{};  // of the blanked beam; at sync tips
  /// What the beam laid on a piece in the window, and for how long until its end, seconds.
  struct Laid {
    double dose = 0, dwell_s = 0, since_s = 0;
  };
  std::vector<BeamStroke> strokes_;
  std::vector<Laid> laid_;    // of each stroke
  std::vector<float> left_;   // of each stroke, of each term
  std::vector<float> given_;  // of each stroke, of each layer
};

}  // namespace kinescope
