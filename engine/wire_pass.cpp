#include "engine/wire_pass.h"

#include <cmath>

namespace kinescope {
namespace {

LinearRgba wire_colour(const Material& material, const LinearRgba& clear) {
  const glm::vec3 c = material.base_colour;
  const float contrast =
      std::abs(c.r - clear.r) + std::abs(c.g - clear.g) + std::abs(c.b - clear.b);
  return contrast > 0.1f ? LinearRgba{c.r, c.g, c.b, 1.0f} : LinearRgba{1.0f, 1.0f, 1.0f, 1.0f};
}

}  // namespace

void WirePass::add_calls(Workers& workers, const Projector& projector, const Camera& camera,
                         const RenderSettings& settings, const LinearRgba& clear,
                         std::span<const FrameMesh> meshes, std::vector<DrawCall>& calls) {
  const DepthPull pull = depth_pull(camera);
  items_.resize(meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const FrameMesh& mesh = meshes[i];
    if (!mesh.seen) continue;
    Item& item = items_[i];
    item.colour = wire_colour(mesh.surface.material, clear);
    if (settings.wireframe) {
      if (item.edges_of != mesh.world->fingerprint) {
        item.edges = unique_edges(mesh.world->mesh->indices);
        item.edges_of = mesh.world->fingerprint;
      }
      item.lines.draw_edges(workers, projector, mesh, item.edges, settings.wire_width_px, pull);
      calls.push_back(item.lines.draw_call(item.colour));
    }
    if (settings.points) {
      item.points.draw_points(workers, mesh, settings.point_size_px, pull);
      calls.push_back(item.points.draw_call(item.colour));
    }
  }
}

}  // namespace kinescope
