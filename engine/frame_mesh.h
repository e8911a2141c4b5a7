// One mesh on its way through one frame: projected, lit, cut, ready to draw.
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "engine/cut_triangles.h"
#include "engine/world_mesh.h"
#include "raster/draw_call.h"
#include "shading/surface.h"

namespace kinescope {

struct FrameMesh {
  WorldMesh* world = nullptr;
  bool seen = false;        ///< not wholly outside one plane of the view volume
  OutcodeSummary outcodes;  ///< of its vertices
  DevicePositions device;   ///< projected vertices, new ones behind
  CutTriangles cut;         ///< filled only if must_cut()
  Surface surface;
  std::vector<float> lit_rows;            ///< kGouraud
  std::vector<LitColour> triangle_light;  ///< kFlat

  bool must_cut() const { return (outcodes.any & outcode::kMustCut) != 0; }
};

/// Whether a box lies wholly outside one plane of the view volume.
bool outside_view(const glm::mat4& clip_from_world, const Bounds& bounds);

/// Projects all seen meshes in batches on all workers, and drops those that turn out unseen.
/// @return how many vertices were projected
std::uint64_t project_meshes(Workers& workers, const Projector& projector,
                             std::span<FrameMesh> meshes);

/// Gouraud's first half for all seen meshes: lights every vertex into lit_rows.
void light_mesh_vertices(Workers& workers, std::span<FrameMesh> meshes);

/// Flat shading: lights every triangle at its centroid, with the normal of its plane.
void light_mesh_triangles(Workers& workers, std::span<FrameMesh> meshes);

}  // namespace kinescope
