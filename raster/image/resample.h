// Pictures of another size: separable filtering of linear light.
#pragma once

#include <vector>

#include "raster/base/workers.h"
#include "raster/colour/colour.h"
#include "raster/image/image.h"

namespace kinescope {

/// The cubic of Mitchell and Netravali 1988 with B = C = 1/3; it spans four pixels.
double mitchell(double x);

/// Scales pictures of one size to another by mitchell(), widened where they shrink. A side that
/// keeps its length is not filtered. Edges go on
/// beyond the picture by weighing only what lies within. What is transparent is black.
class Resampler {
 public:
  Resampler(int from_width, int from_height, int to_width, int to_height);
  /// @param picture of the size to scale from. @return valid until the next call
  const Image<Srgb8>& operator()(const Image<Srgb8>& picture, Workers& workers);

 private:
  struct Taps {
    int first = 0;
    std::vector<float> weights;  ///< their sum is 1
  };
  static std::vector<Taps> taps(int from, int to);
  void scale_across(const Image<Srgb8>& picture, int y);
  void scale_down(int y);

  int from_width_, from_height_;
  std::vector<Taps> across_, down_;
  Image<LinearRgb> narrowed_;  // scaled across, not yet down
  Image<Srgb8> out_;
};

/// Each block of side x side pixels as the one in it whose green is darkest, so that thin dark
/// lines stay; a part of a block at the right or below is left out.
Image<Srgb8> darkest_of_blocks(const Image<Srgb8>& picture, int side);

}  // namespace kinescope
