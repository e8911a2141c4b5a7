// The light of the blanked beam as it flies back, of a locked raster. Blanking drives the guns
// below black; with the brightness raised they conduct all the same, and the retrace lines appear,
// but for the sync tips if the signal carries them.
#pragma once

#include <span>
#include <vector>

#include "display/phosphor.h"
#include "display/raster_scan.h"
#include "display/tube/beam_flight.h"
#include "display/tube/gun.h"
#include "display/tube/settings.h"
#include "raster/base/workers.h"

namespace kinescope {

class RetraceLight {
 public:
  /// @param gun whose beam flies back, blanked
  /// @param laws of the layers' phosphors
  RetraceLight(const TubeSettings& settings, const Gun& gun, std::span<const Phosphor> laws,
               int width, int height);

  /// Light of [begin, end), as if the beam had been so for ever; white over one refresh is 1.
  /// @return empty if the beam is cut off; valid until the next call
  const LightOverlay& light(BeamTime begin, BeamTime end, Workers& workers);

 private:
  /// A piece of the blanked beam's way, and when it is run; clocks of the frame.
  struct Flight {
    BeamStroke stroke;
    double begin = 0, length = 0;
    double dose = 0;
  };
  void follow_line(const FlightPath& path, const Gun& gun, int line);
  void weigh(BeamTime begin, BeamTime end);

  RasterScan scan_;
  std::vector<Phosphor> laws_;
  int width_, height_;
  std::vector<Flight> flights_;
  std::vector<BeamStroke> strokes_;
  std::vector<float> weights_;  // of each stroke, of each layer
  FlightPainter painter_;
  LightOverlay overlay_;
  BeamTime length_drawn_;  // of whole frames only: then the light is the same at every phase
};

/// Of excitation that comes back every period, each time with a light of 1 spread over a dwell:
/// what a term gives from `since` to `since + length` after it began, length at most a period.
double light_of_repeated(double since, double length, double period, double dwell, double tau);

}  // namespace kinescope
