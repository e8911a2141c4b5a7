#include "display/tube/beam_flight.h"

#include <algorithm>
#include <cmath>

#include "display/tube_kernels.h"

namespace kinescope {
namespace {

constexpr int kMiddleGun = 1;
constexpr double kMostPieces = 256;  // finer than the spot is wide

}  // namespace

int flight_pieces(double clocks) {
  return static_cast<int>(std::clamp(std::round(clocks), 1.0, kMostPieces));
}

FlightPath::FlightPath(const TubeSettings& settings, int width, int height)
    : width_(width),
      height_(height),
      deflection_(settings.deflection, settings.glass, kMiddleGun),
      camera_(settings.glass),
      spot_(settings.spot),
      pixels_a_mm_(pixels_a_mm(settings.glass, width, height).down),
      cell_pixels_(static_cast<double>(width) * height * settings.deflection.width *
                   settings.deflection.height / settings.mode.horizontal.active /
                   settings.mode.vertical.active) {}

Place FlightPath::picture(Place sweep) const {
  const Place at = camera_.picture_of_glass(deflection_.glass_of_sweep(sweep));
  return {0.5 * (at.x + 1) * width_, 0.5 * (at.y + 1) * height_};
}

BeamStroke FlightPath::stroke(Place from, Place to, double current) const {
  const auto as_float = [](double v) { return static_cast<float>(v); };
  const Place a = picture(from), b = picture(to);
  return {as_float(a.x), as_float(a.y), as_float(b.x), as_float(b.y),
          as_float(spot_.sigma_mm(current) * pixels_a_mm_)};
}

void FlightPainter::add(std::span<const BeamStroke> strokes, std::span<const float> weights,
                        std::span<const FlightLight> lights, Workers& workers) {
  const std::size_t count = lights.size();
  if (tiles_.size() <= count) tiles_.resize(count + 1);
  TiledLight& tiles = tiles_[count];
  if (tiles.tiles() == 0) tiles = TiledLight(width_, height_, static_cast<int>(count));
  tiles.clear();
  painter_.draw(strokes, weights, tiles, workers);
  workers.run(tiles.tiles(), [&](int tile, int) {
    if (!tiles.lit(tile)) return;
    const BeamTile place = tiles.tile(tile);
    const int columns = std::min(kBeamTile, width_ - place.x);
    const int rows = std::min(kBeamTile, height_ - place.y);
    for (std::size_t p = 0; p < count; ++p) {
      for (const FlightLight::Share& share : lights[p].to) {
        if (!share.plane || share.scale == 0) continue;
        const float* from = tiles.plane(tile, static_cast<int>(p));
        float* to = share.plane->data() + static_cast<std::ptrdiff_t>(place.y) * width_ + place.x;
        for (int y = 0; y < rows; ++y, from += kBeamTile, to += width_) {
          add_scaled(columns, share.scale, from, to);
        }
      }
    }
  });
}

}  // namespace kinescope
