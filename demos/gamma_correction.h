// Gamma correction: the gun drive that makes a tube's light what a picture means.
#pragma once

#include <array>
#include <cstdint>

#include "raster/base/workers.h"
#include "raster/image/image.h"

namespace kinescope {

/// What a video card's output table does: drive = light ^ (1 / gamma), light decoded from sRGB.
/// Without it a tube of gamma 2.35 shows the dark parts of an sRGB picture too dark.
class GammaCorrection {
 public:
  explicit GammaCorrection(double tube_gamma);
  /// The picture as gun drive. @return valid until the next call
  const Image<Srgb8>& operator()(const Image<Srgb8>& picture, Workers& workers);

 private:
  std::array<std::uint8_t, 256> drive_{};
  Image<Srgb8> corrected_;
};

}  // namespace kinescope
