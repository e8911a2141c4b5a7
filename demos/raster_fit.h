// Pictures of any size on a mode's raster.
#pragma once

#include <optional>

#include "demos/options.h"
#include "demos/picture.h"
#include "raster/image/resample.h"
#include "raster/image/video.h"

namespace kinescope {

/// Lays pictures of one size on black of the raster's. Pixels that fit a whole number of times
/// are repeated, others filtered in linear light.
class RasterFit {
 public:
  /// @param picture_aspect width over height that the whole picture should have on the face
  /// @param face_aspect that of the raster
  /// @throws Error (usage) if an interlaced picture's lines are not the raster's
  RasterFit(Size picture, double picture_aspect, Size raster, double face_aspect, Fit fit,
            FieldOrder fields, Workers& workers);
  /// @return valid until the next call
  const Image<Srgb8>& operator()(const Image<Srgb8>& picture);

 private:
  void repeat(const Image<Srgb8>& picture);
  void lay_down(const Image<Srgb8>& picture);

  Size picture_, raster_, box_;  // the box is what the picture covers, centred
  bool line_lower_;
  Workers& workers_;
  std::optional<Resampler> resample_;
  Image<Srgb8> out_;
};

/// The box within a raster that a picture covers.
Size fitted_box(Size picture, double picture_aspect, Size raster, double face_aspect, Fit fit);

}  // namespace kinescope
