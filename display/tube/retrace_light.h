// The light of the blanked beam as it flies back. Blanking drives the guns below black; with the
// brightness raised they conduct all the same, and the retrace lines appear. The three guns' beams
// fly together: errors of convergence are left out.
#pragma once

#include <span>
#include <vector>

#include "display/phosphor.h"
#include "display/raster_scan.h"
#include "display/tube/settings.h"
#include "display/vector/beam_painter.h"
#include "raster/base/workers.h"

namespace kinescope {

/// Rows of a screen's width for each layer, or none.
using LightOverlay = std::vector<std::vector<float>>;

class RetraceLight {
 public:
  /// @param current of the blanked beam, white's being 1
  /// @param laws of the layers' phosphors
  RetraceLight(const TubeSettings& settings, double current, std::span<const Phosphor> laws,
               int width, int height);

  /// Light of [begin, end), as if the beam had been so for ever; white over one refresh is 1.
  /// @return empty if the beam is cut off; valid until the next call
  const LightOverlay& light(BeamTime begin, BeamTime end, Workers& workers);

 private:
  /// A piece of the blanked beam's way, straight and evenly run, and when; clocks of the frame.
  struct Flight {
    BeamStroke stroke;
    double begin = 0, length = 0;
  };
  void follow_frame(const TubeSettings& settings);
  void follow_line(const TubeSettings& settings, int line);
  void weigh(BeamTime begin, BeamTime end);

  RasterScan scan_;
  double current_;
  std::vector<Phosphor> laws_;
  int width_, height_;
  double cell_pixels_;  // of the output, that a cell of the raster covers
  std::vector<Flight> flights_;
  std::vector<BeamStroke> strokes_;
  std::vector<float> weights_;  // of each stroke, of each layer
  TiledLight tiles_;
  BeamPainter painter_;
  LightOverlay overlay_;
  BeamTime length_drawn_;  // of whole frames only: then the light is the same at every phase
};

/// Of excitation that comes back every period, each time with a light of 1: what a term gives from
/// `since` to `since + length` after it came, length at most a period.
double light_of_repeated(double since, double length, double period, double tau);

}  // namespace kinescope
