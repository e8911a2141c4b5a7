#include "engine/wireframe.h"

#include <algorithm>
#include <glm/vec4.hpp>

#include "engine/clip_line_homogeneous.h"

namespace kinescope {
namespace {

constexpr std::size_t kTaskQuads = 2048;
constexpr float kLimitPx = DeviceVertex::kGuardBand;
constexpr double kPull = 0.003;  // at 40 degrees and 640 pixels: half a pixel on a steep slope

glm::dvec4 clip_position(const Projector& p, const Positions& world, std::uint32_t i) {
  return glm::dmat4(p.clip_from_world) * glm::dvec4(world.x[i], world.y[i], world.z[i], 1.0);
}

DeviceVertex pulled(DeviceVertex v, DepthPull pull) {
  v.z = std::clamp(v.z * pull.gain - pull.offset, 0.0f, 1.0f);
  return v;
}

/// Shares quads out; each has a slot of its own, so their order is that of the edges.
template <typename Body>
void for_each_quad(Workers& workers, std::size_t quads, const Body& body) {
  const std::size_t tasks = (quads + kTaskQuads - 1) / kTaskQuads;
  workers.run(static_cast<int>(tasks), [&](int task, int) {
    const std::size_t begin = static_cast<std::size_t>(task) * kTaskQuads;
    const std::size_t end = std::min(quads, begin + kTaskQuads);
    for (std::size_t quad = begin; quad < end; ++quad) body(quad);
  });
}

}  // namespace

DepthPull depth_pull(const Camera& camera) {
  if (camera.projection == Projection::kOrthographic) return {1.0f, static_cast<float>(kPull)};
  // depth = a - b / w: to bring w nearer by a fraction adds that fraction to a - depth.
  const double a = -camera.clip_from_view()[2][2];
  return {static_cast<float>(1.0 + kPull), static_cast<float>(kPull * a)};
}

void WireQuads::resize(std::size_t quads) {
  vertices_.resize(quads * 4);
  const std::size_t known = indices_.size() / 6;
  indices_.resize(quads * 6);
  for (std::size_t quad = known; quad < quads; ++quad) {
    const auto v = static_cast<std::uint32_t>(quad * 4);
    const std::array<std::uint32_t, 6> corners{v, v + 1, v + 2, v, v + 2, v + 3};
    std::copy(corners.begin(), corners.end(), &indices_[quad * 6]);
  }
}

void WireQuads::put(std::size_t quad, const DeviceQuad& corners) {
  std::copy(corners.begin(), corners.end(), &vertices_[quad * 4]);
}

void WireQuads::draw_edges(Workers& workers, const Projector& projector, const FrameMesh& mesh,
                           std::span<const Edge> edges, float width_px, DepthPull pull) {
  resize(edges.size());
  const auto planes = view_volume_planes();
  const Positions& world = mesh.world->positions;
  const auto line = [&](const Edge& edge) -> DeviceQuad {
    const auto [a, b] = edge;
    const int code_a = mesh.device.outcodes[a], code_b = mesh.device.outcodes[b];
    const int any = code_a | code_b;
    if ((code_a & code_b & outcode::kVolume) != 0 || (any & outcode::kNotFinite) != 0) return {};
    if ((any & outcode::kMustCut) == 0) {
      return thick_line(pulled(mesh.device.vertices[a], pull),
                        pulled(mesh.device.vertices[b], pull), width_px);
    }
    glm::dvec4 from = clip_position(projector, world, a), to = clip_position(projector, world, b);
    if (!clip_line(planes, from, to)) return {};
    return thick_line(pulled(device_vertex(projector, from, kLimitPx), pull),
                      pulled(device_vertex(projector, to, kLimitPx), pull), width_px);
  };
  for_each_quad(workers, edges.size(), [&](std::size_t quad) { put(quad, line(edges[quad])); });
}

void WireQuads::draw_points(Workers& workers, const FrameMesh& mesh, float size_px,
                            DepthPull pull) {
  resize(mesh.world->vertices());
  for_each_quad(workers, mesh.world->vertices(), [&](std::size_t quad) {
    const bool seen = mesh.device.outcodes[quad] == 0;
    put(quad, seen ? thick_point(pulled(mesh.device.vertices[quad], pull), size_px) : DeviceQuad{});
  });
}

DrawCall WireQuads::draw_call(const LinearRgba& colour) const {
  DrawCall call;
  call.vertices = vertices_;
  call.indices = indices_;
  call.cull = CullMode::kNone;
  call.shade = shade_constant;
  call.constants = &colour;
  return call;
}

void shade_constant(const Batch& batch, LinearRgba* out) {
  std::fill_n(out, batch.size, *static_cast<const LinearRgba*>(batch.constants));
}

}  // namespace kinescope
