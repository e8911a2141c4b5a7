// Attributes of a batch's fragments, perspective-correct, from the vertices of their triangles.
#pragma once

#include <array>
#include <cstdint>

#include "raster/batch.h"
#include "raster/draw_call.h"

namespace kinescope {

/// The arrays that a Batch points to.
struct BatchStorage {
  /// A vector may begin at any fragment, and so end beyond the last.
  static constexpr int kMax = Batch::kMaxSize + 16;
  alignas(64) std::array<std::uint16_t, kMax> x{};
  alignas(64) std::array<std::uint16_t, kMax> y{};
  alignas(64) std::array<std::uint32_t, kMax> triangle{};   ///< in the draw call
  alignas(64) std::array<std::uint32_t, kMax> primitive{};  ///< in its source
  alignas(64) std::array<std::array<float, kMax>, Batch::kMaxAttributes> attribute{};
  alignas(64) std::array<std::array<float, kMax>, 4> gradient{};  ///< du_dx, dv_dx, du_dy, dv_dy
};

/// Fills attribute and gradient of the first `size` fragments from x, y and triangle.
///
/// A point's barycentric weights, each times 1/w of its vertex and divided by their sum, are the
/// weights of the vertex attributes. Source: P. Heckbert and H. Moreton, "Interpolation for polygon
/// texture mapping and shading", 1991. Weights are kept within the triangle, so that a pixel whose
/// centre lies outside (one of its samples is inside) gets no attribute beyond the vertices'.
void interpolate(const DrawCall& call, int size, BatchStorage& batch);

}  // namespace kinescope
