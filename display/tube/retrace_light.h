// The light of the blanked beam as it flies back. Blanking drives the guns below black; with the
// brightness raised they conduct all the same, and the retrace lines appear.
#pragma once

#include <span>
#include <vector>

#include "display/phosphor.h"
#include "display/raster_scan.h"
#include "display/tube/screen.h"
#include "display/tube/settings.h"

namespace kinescope {

/// Rows of a screen's width for each layer, or none.
using LightOverlay = std::vector<std::vector<float>>;

class RetraceLight {
 public:
  /// @param current of the blanked beam, white's being 1
  /// @param laws of the layers' phosphors
  RetraceLight(const TubeSettings& settings, double current, std::span<const ScreenLayer> layers,
               std::span<const Phosphor> laws, int width, int height);

  /// Light of [begin, end), as if the beam had been so for ever; white over one refresh is 1.
  /// @return empty if the beam is cut off; valid until the next call
  const LightOverlay& light(BeamTime begin, BeamTime end, Workers& workers);

 private:
  void draw_layer(std::size_t layer, BeamTime begin, BeamTime end);
  void draw_spot(std::vector<float>& plane, double x, double y, float light) const;

  TubeSettings settings_;
  RasterScan scan_;
  double current_;
  std::vector<ScreenLayer> layers_;
  std::vector<Phosphor> laws_;
  int width_, height_;
  double across_pixels_ = 0, down_pixels_ = 0;  // the spot's deviations, with the pixel's own
  LightOverlay overlay_;
  BeamTime length_drawn_;  // of whole frames only: then the light is the same at every phase
};

/// Of excitation that comes back every period, each time with a light of 1: what a term gives from
/// `since` to `since + length` after it came, length at most a period.
double light_of_repeated(double since, double length, double period, double tau);

}  // namespace kinescope
