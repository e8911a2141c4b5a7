// The pass that draws a frame's meshes as lines and points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/renderer.h"
#include "engine/wireframe.h"

namespace kinescope {

/// Keeps edges and quads of each mesh between frames.
class WirePass {
 public:
  /// Appends the calls of all seen meshes, edges or points or both, as the settings say. Lines have
  /// their material's base colour, or white where that could not be told from `clear`.
  void add_calls(Workers& workers, const Projector& projector, const Camera& camera,
                 const RenderSettings& settings, const LinearRgba& clear,
                 std::span<const FrameMesh> meshes, std::vector<DrawCall>& calls);

 private:
  struct Item {
    std::uint64_t edges_of = 0;  ///< fingerprint of the mesh they belong to
    std::vector<Edge> edges;
    WireQuads lines, points;
    LinearRgba colour;
  };
  std::vector<Item> items_;
};

}  // namespace kinescope
