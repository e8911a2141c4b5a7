// From a tube's light to pictures for a screen or a file.
#pragma once

#include "display/exposure.h"
#include "raster/base/workers.h"
#include "raster/colour/colour.h"
#include "raster/image/image.h"

namespace kinescope {

/// How exposed light becomes a picture's brightness.
struct ExposureGain {
  float factor = 1;
  /// A camera's short shutter opened up: light as a time average, so that steady white is 1
  /// whatever the length. @param refresh_period the time in which steady white gives a light of 1
  static ExposureGain average(Exposure exposure, Seconds refresh_period);
  /// The light as it is, times `gain`: 1/4000 s of a 60 Hz tube is as dim as it was.
  static ExposureGain fixed(float gain) { return {gain}; }
};

/// Light times the gain, clamped to [0, 1] and encoded by the sRGB curve. `out` is given the
/// light's size.
void encode_light(const Image<LinearRgb>& light, ExposureGain gain, Workers& workers,
                  Image<Srgb8>& out);
void encode_light(const Image<LinearRgb>& light, ExposureGain gain, Workers& workers,
                  Image<Srgb16>& out);

}  // namespace kinescope
