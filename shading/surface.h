// Where geometry meets light: the vertex row, a surface's constants, and the shading models.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "raster/batch.h"
#include "shading/light.h"
#include "shading/material.h"
#include "shading/texture.h"

namespace kinescope {

/// How light is spread over a triangle. kPhong and kBlinn light every fragment (reflection vector,
/// half vector); kGouraud lights vertices and kFlat triangles, both by the reflection vector.
enum class ShadingModel { kFlat, kGouraud, kPhong, kBlinn, kUnlit };

/// A row of vertex attributes in world space, floats in this order; the last three only in meshes
/// with vertex colours.
namespace vertex_row {
inline constexpr int kPosition = 0, kNormal = 3, kTexcoord = 6, kColour = 8;
inline constexpr int kCount = 8, kCountWithColour = 11;
inline constexpr int kStride = 8, kStrideWithColour = 12;
}  // namespace vertex_row

/// A row of a vertex that was lit already: light reflected by the body, highlight, texture place.
/// The texture multiplies the body's light only; without one the body's light holds the highlight,
/// and a row ends after its first four floats: lit_row_size().
namespace lit_row {
inline constexpr int kBody = 0, kHighlight = 3, kTexcoord = 6;
inline constexpr int kMaxSize = 8;
}  // namespace lit_row

/// The two parts of a lit triangle, for flat shading.
struct LitColour {
  glm::vec3 body{0.0f};
  glm::vec3 highlight{0.0f};
};

/// What a shader gets as Batch::constants. Everything is in world space and outlives the frame.
struct Surface {
  Material material;
  const Texture* texture = nullptr;  ///< null: none
  std::span<const Light> lights;
  glm::vec3 ambient{0.1f};
  glm::vec3 eye{0.0f};
  bool mirrored = false;        ///< the node mirrors: a triangle seen from its back shows its front
  bool vertex_colours = false;  ///< rows carry vertex_row::kColour
  std::span<const LitColour> triangle_light;  ///< kFlat: one a source triangle
};

/// Whether lit rows hold the highlight by itself.
inline bool keeps_highlight_apart(const Surface& surface) { return surface.texture != nullptr; }

/// Floats of a lit row, and from one to the next.
inline int lit_row_size(const Surface& surface) {
  return keeps_highlight_apart(surface) ? lit_row::kMaxSize : 4;
}

/// The shader of a model, for the instruction set in use. kGouraud reads lit rows, kFlat and kUnlit
/// any row whose texture place is at kTexcoord, the others vertex rows.
/// Where the material is double-sided, normals are turned to the side of the triangle that is seen;
/// kGouraud, which lights vertices before any triangle is known, turns them to the eye.
ShadeFunction shade_function(ShadingModel model);

/// The attributes of a row that this shader reads, a bit each.
std::uint32_t attributes_read(ShadingModel model, const Surface& surface);

/// Gouraud's first half: vertex rows (stride as the surface says) to lit rows.
void light_vertices(const Surface& surface, std::span<const float> rows, std::span<float> lit_rows);

/// The scalar law, for references, flat shading and tests: light of a point with unit normal `n`.
/// @param half_vector true for Blinn's highlight, false for the reflection vector's
LitColour light_point(const Surface& surface, glm::vec3 position, glm::vec3 n, glm::vec3 colour,
                      bool half_vector);

}  // namespace kinescope
