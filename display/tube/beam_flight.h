// The blanked beam's way over the picture, in straight pieces, and the painting of them. The three
// guns' beams fly together: errors of convergence are left out.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "display/tube/deflection.h"
#include "display/tube/settings.h"
#include "display/tube/spot.h"
#include "display/vector/beam_painter.h"
#include "raster/base/workers.h"

namespace kinescope {

/// Rows of a screen's width for each layer, or none.
using LightOverlay = std::vector<std::vector<float>>;

/// Pieces into which a part of the way is cut that takes so many clocks. As a cell of the raster
/// does, each lights as a whole while the beam is on it, whatever window cuts through it: so
/// windows add up, and none shows where the beam has not been but for a clock.
int flight_pieces(double clocks);

/// From places of the sweep to strokes on the picture.
class FlightPath {
 public:
  FlightPath(const TubeSettings& settings, int width, int height);
  /// @param current of the blanked beam, white's being 1
  BeamStroke stroke(Place from, Place to, double current) const;
  /// Of the output, that a cell of the raster covers: what a stroke leaves of white in a clock.
  double cell_pixels() const { return cell_pixels_; }

 private:
  Place picture(Place sweep) const;

  int width_, height_;
  Deflection deflection_;
  GlassCamera camera_;
  SpotModel spot_;
  double pixels_a_mm_, cell_pixels_;
};

/// Light that strokes leave, and the one or two planes of the screen's size to which it is added.
struct FlightLight {
  struct Share {
    std::vector<float>* plane = nullptr;
    float scale = 1;
  };
  std::array<Share, 2> to{};
};

/// Adds strokes to planes; keeps its memory from call to call.
class FlightPainter {
 public:
  FlightPainter(int width, int height) : width_(width), height_(height) {}
  /// @param weights for each stroke one for each light
  void add(std::span<const BeamStroke> strokes, std::span<const float> weights,
           std::span<const FlightLight> lights, Workers& workers);

 private:
  int width_, height_;
  std::vector<TiledLight> tiles_;  // of each number of lights
  BeamPainter painter_;
};

}  // namespace kinescope
