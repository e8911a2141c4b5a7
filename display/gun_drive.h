// From gun drive to the doses of the phosphor layers, and from the layers' light to colour.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "display/frame_buffer.h"
#include "display/phosphor.h"

namespace kinescope {

/// The layers of a faceplate: three of P22, or one of a monochrome type.
/// @throws Error (usage) naming the phosphors there are
std::vector<const Phosphor*> faceplate_phosphors(const std::string& name);

/// Each layer's linear sRGB at full drive: three layers make white (1, 1, 1) together; one layer
/// has its hue with the largest channel at 1.
std::array<std::array<float, 3>, 3> layer_colours(std::span<const Phosphor* const> layers);

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
