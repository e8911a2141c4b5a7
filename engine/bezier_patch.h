// Bicubic Bezier patches: points, derivatives, normals, and triangles.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/scene.h"

namespace kinescope {

/// Sixteen control points: point[row][column], u runs along a row, v from row to row.
struct BezierPatch {
  std::array<std::array<glm::dvec3, 4>, 4> point{};
};

/// A place on a patch. The normal is unit length, along du x dv; where a side of the patch shrinks
/// to a pole it is the limit from inside. Zero only for patches without any extent.
struct PatchSample {
  glm::dvec3 position, du, dv, normal;
};
/// @param u, v in [0, 1]. At 0 and 1 the control points of that side alone decide, to the last bit,
///             so patches that share a side meet without a gap.
PatchSample sample_patch(const BezierPatch& patch, double u, double v);

/// Where a patch lies in its texture: texcoord = at_00 + (u, v) * size.
struct PatchTexcoords {
  glm::vec2 at_00{0.0f};
  glm::vec2 size{1.0f};
};

/// Appends fineness x fineness quads to a mesh, each split in two, counter-clockwise about the
/// normal; triangles that a pole makes degenerate are left out.
void tessellate_patch(const BezierPatch& patch, int fineness, const PatchTexcoords& texcoords,
                      Mesh& mesh);

}  // namespace kinescope
