// Wireframes and points: edges and vertices of projected meshes as thick primitives.
#pragma once

#include <span>
#include <vector>

#include "engine/frame_mesh.h"
#include "engine/mesh_edges.h"
#include "raster/draw_call.h"
#include "raster/thick_primitives.h"

namespace kinescope {

/// What is subtracted from depth so that a line lies just before its surface: depth becomes
/// depth * gain - offset.
struct DepthPull {
  float gain = 1.0f;
  float offset = 0.0f;
};
/// A thousandth or so of the distance from the eye (of the depth range where parallel).
DepthPull depth_pull(const Camera& camera);

/// The quads of one mesh, each in a slot of its own, so that workers can share them out. Keeps its
/// buffers between frames.
class WireQuads {
 public:
  /// One thick line an edge, cut where the view ends.
  void draw_edges(Workers& workers, const Projector& projector, const FrameMesh& mesh,
                  std::span<const Edge> edges, float width_px, DepthPull pull);
  /// One square a vertex, `size_px` wide.
  void draw_points(Workers& workers, const FrameMesh& mesh, float size_px, DepthPull pull);

  /// All quads in one colour; valid until the next call of draw.
  DrawCall draw_call(const LinearRgba& colour) const;

 private:
  void resize(std::size_t quads);
  void put(std::size_t quad, const DeviceQuad& corners);

  std::vector<DeviceVertex> vertices_;
  std::vector<std::uint32_t> indices_;
};

/// A shader of one colour; the constants are a LinearRgba.
void shade_constant(const Batch& batch, LinearRgba* out);

}  // namespace kinescope
