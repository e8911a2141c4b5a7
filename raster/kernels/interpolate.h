// Attributes of a batch's fragments, perspective-correct, from the vertices of their triangles.
#pragma once

#include <cstdint>

#include "raster/kernels/batch_storage.h"

namespace kinescope {

/// Fills x, y and triangle from fragments in screen order.
/// @param xy  pixels, x in the low half, y in the high; readable 16 entries beyond the last
void unpack_fragments(const std::uint32_t* id, const std::uint32_t* xy, std::uint32_t first_id,
                      int size, BatchStorage& batch);

/// Fills facing, attribute and gradient of the first `size` fragments from x, y and triangle.
///
/// A point's barycentric weights, each times 1/w of its vertex and divided by their sum, are the
/// weights of the vertex attributes. Source: P. Heckbert and H. Moreton, "Interpolation for polygon
/// texture mapping and shading", 1991. Weights are kept within the triangle, so that a pixel whose
/// centre lies outside (one of its samples is inside) gets no attribute beyond the vertices'.
void interpolate(const DrawCall& call, int size, BatchStorage& batch);

}  // namespace kinescope
