// Anti-aliasing after the fact: edges are found in the finished picture by their contrast and
// blurred along their direction.
// Source: T. Lottes, "FXAA", 2009, in its short form.
#pragma once

#include "raster/image/image.h"

namespace kinescope {

struct EdgeBlur {
  float least_contrast = 1.0f / 16;    ///< below it nothing is an edge; of brightness 0 to 1
  float relative_contrast = 1.0f / 8;  ///< nor below this share of the brightest pixel around
  float reach_px = 8;                  ///< how far along an edge is looked
};

/// A new picture. What has no edges stays as it is, to the bit.
Image<LinearRgb> blur_edges(const Image<LinearRgb>& image, const EdgeBlur& settings = {});

}  // namespace kinescope
