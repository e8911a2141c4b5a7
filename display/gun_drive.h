// From gun drive to the doses of the phosphor layers, and from the layers' light to colour.
#pragma once

#include <array>
#include <span>

#include "display/frame_buffer.h"
#include "display/phosphor.h"

namespace kinescope {

/// Each layer's linear sRGB at full drive: three layers make white (1, 1, 1) together; those of a
/// monochrome type have the hue of their mixture, its largest channel at 1. Layers that the type
/// lacks are black.
std::array<std::array<float, 3>, 3> layer_colours(const PhosphorType& type);

/// Light of a gun by its drive: (drive / 255) ^ gamma, 1 at full drive.
class GunCurve {
 public:
  explicit GunCurve(double gamma);
  /// One layer's doses for drives [begin, end) of a line. @param layer 0 red, 1 green, 2 blue
  void colour_doses(std::span<const GunDrive> drives, int layer, float* doses) const;
  /// Of a monochrome tube.
  void grey_doses(std::span<const GunDrive> drives, float* doses) const;

 private:
  std::array<float, 256> light_{};
};

}  // namespace kinescope
