// What a dose of the beam is worth on each plane of a vector tube's light.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "display/phosphor.h"
#include "raster/base/units.h"

namespace kinescope {

/// A layer of the faceplate and its planes: the light of this exposure, then for each term of its
/// phosphor the light to come.
struct LightLayer {
  Phosphor phosphor;
  std::array<float, 3> colour;
  std::size_t gun;
  int first_plane = 0;
};

/// The law by which doses become light.
class DoseLight {
 public:
  /// @param by_guns each layer has its own, else all have the first
  DoseLight(const PhosphorType& type, bool by_guns);

  const std::vector<LightLayer>& layers() const { return layers_; }
  int planes() const { return planes_; }
  Seconds slowest() const { return Seconds(slowest_); }
  /// Adds a weight for each plane, of a dose spread evenly over [begin, end), in the exposure that
  /// ends at `until`, not before `end`.
  /// @param guns share of each; a layer takes that of its own
  void add_weights(double dose, const std::array<float, 3>& guns, Seconds begin, Seconds end,
                   Seconds until, std::vector<float>& weights) const;

 private:
  std::vector<LightLayer> layers_;
  int planes_ = 0;
  double slowest_ = 0;  // seconds
};

}  // namespace kinescope
