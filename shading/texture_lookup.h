// Texture lookup for a batch of fragments.
#pragma once

#include "raster/batch.h"
#include "shading/texture.h"

namespace kinescope {

/// Looks up all fragments of a batch in a texture that has levels. (u, v) are the attributes
/// `texcoord` and `texcoord` + 1; the level of detail comes from the batch's gradients, and is 0
/// where it has none. Differs from level_of_detail() and Texture::sample() by at most 1e-4.
/// @param out room for Batch::kMaxSize colours; those past the batch's size are undefined
void look_up(const Texture& texture, const Batch& batch, int texcoord, LinearRgba* out);

}  // namespace kinescope
