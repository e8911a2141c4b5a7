// Vertex normals that keep edges sharp.
#pragma once

#include <cstdint>
#include <span>

#include "engine/scene.h"

namespace kinescope {

/// Faces that meet at a steeper angle than this keep their edge: between the 30 of fine
/// tessellations and the 60 of coarse ones; boxes, bevels and the rims of cylinders stay sharp.
inline constexpr float kCreaseRad = 0.785398f;  // 45 degrees

/// Replaces mesh.normals by smooth ones (see compute_normals), except across creases, where
/// vertices are doubled. Vertices at one place count as one, whatever their texture coordinates.
/// @param smoothing_groups  empty, or one a triangle, as OBJ has them: faces of one group are
///     smooth together at any angle, those of group 0 are flat
void compute_crease_normals(Mesh& mesh, float crease_rad,
                            std::span<const std::uint32_t> smoothing_groups = {});

}  // namespace kinescope
