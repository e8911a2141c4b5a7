// The rasterizer's input: triangles in device space, and what to call for their colour.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "raster/batch.h"
#include "raster/blending.h"
#include "raster/device_vertex.h"
#include "raster/pixel_rect.h"

namespace kinescope {

/// Which triangles are thrown away. Front faces are counter-clockwise as seen on the screen.
enum class CullMode { kNone, kBack, kFront };

/// Triangles of one surface. The spans must live until the frame is drawn.
///
/// A call with the default depth test, depth write and blending is plain. Submit plain calls first:
/// they are drawn by visibility, each pixel shaded once. From the first call on that is neither
/// plain nor kByDepth, all calls are drawn one after another, as a GPU draws them; the picture is
/// the same, only dearer.
struct DrawCall {
  std::span<const DeviceVertex> vertices;  ///< coordinates within the guard band
  std::span<const std::uint32_t> indices;  ///< three a triangle; each below the vertex count
  /// For triangles made by clipping: the triangle in the mesh that each came from. Empty: identity.
  std::span<const std::uint32_t> source_triangle;

  /// A row of attribute_count floats a vertex (not divided by w), attribute_stride floats apart.
  std::span<const float> attributes;
  int attribute_count = 0;
  int attribute_stride = 0;
  std::uint32_t attributes_read =
      ~0u;                      ///< bits of those that the shader reads; others are left out
  int texcoord_attribute = -1;  ///< attribute index of u (v follows) that needs gradients, or -1

  CullMode cull = CullMode::kBack;
  ShadeFunction shade = nullptr;  ///< null: shows the clear colour, and so hides what lies behind
  const void* constants = nullptr;

  DepthTest depth_test = DepthTest::kLess;
  bool depth_write = true;  ///< kByDepth never writes depth
  BlendMode blend = BlendMode::kOpaque;
  BlendOrder order = BlendOrder::kSubmitted;
  std::optional<PixelRect> scissor;  ///< no pixel outside is touched; none: the whole target

  bool is_plain() const {
    return depth_test == DepthTest::kLess && depth_write && blend == BlendMode::kOpaque &&
           order == BlendOrder::kSubmitted;
  }
};

}  // namespace kinescope
