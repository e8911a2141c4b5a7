#include "engine/wireframe.h"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

#include "engine/clip_line_homogeneous.h"

namespace kinescope {
namespace {

constexpr std::size_t kTaskQuads = 2048;
constexpr double kPull = 0.003;  // at 40 degrees and 640 pixels: half a pixel on a steep slope

glm::dvec4 clip_position(const Projector& p, const Positions& world, std::uint32_t i) {
  return glm::dmat4(p.clip_from_world) * glm::dvec4(world.x[i], world.y[i], world.z[i], 1.0);
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

/// One end of a line on the device.
struct WireQuads::End {
  float x_px, y_px, z, inv_w;

  static End of_vertex(const DevicePositions& d, std::uint32_t i) {
    return {d.x_px[i], d.y_px[i], d.z[i], d.inv_w[i]};
  }
  static End of_clip(const Projector& p, const glm::dvec4& clip) {
    const double inv_w = 1.0 / std::max<double>(clip.w, kLeastW);
    const auto& to_px = p.device_from_ndc;
    return {static_cast<float>(clip.x * inv_w * to_px.scale.x + to_px.offset.x),
            static_cast<float>(clip.y * inv_w * to_px.scale.y + to_px.offset.y),
            static_cast<float>(std::clamp(clip.z * inv_w, 0.0, 1.0)), static_cast<float>(inv_w)};
  }
};

DepthPull depth_pull(const Camera& camera) {
  if (camera.projection == Projection::kOrthographic) return {1.0f, static_cast<float>(kPull)};
  // depth = a - b / w: to bring w nearer by a fraction adds that fraction to a - depth.
  const double a = -camera.clip_from_view()[2][2];
  return {static_cast<float>(1.0 + kPull), static_cast<float>(kPull * a)};
}

void WireQuads::resize(std::size_t quads) {
  for (std::vector<float>* array : {&x_px_, &y_px_, &z_, &inv_w_}) array->resize(quads * 4);
  const std::size_t known = indices_.size() / 6;
  indices_.resize(quads * 6);
  for (std::size_t quad = known; quad < quads; ++quad) {
    const auto v = static_cast<std::uint32_t>(quad * 4);
    const std::array<std::uint32_t, 6> corners{v, v + 1, v + 2, v, v + 2, v + 3};
    std::copy(corners.begin(), corners.end(), &indices_[quad * 6]);
  }
}

void WireQuads::put(std::size_t quad, const End& a, const End& b, float half, DepthPull pull) {
  float dx = b.x_px - a.x_px, dy = b.y_px - a.y_px;
  const float length = std::hypot(dx, dy);
  // A point is a line along x.
  dx = length > 0.0f ? dx / length * half : half;
  dy = length > 0.0f ? dy / length * half : 0.0f;
  const auto set = [&](std::size_t corner, const End& end, float x, float y) {
    constexpr float kLimit = DeviceVertices::kGuardBand;
    const std::size_t at = quad * 4 + corner;
    x_px_[at] = std::clamp(end.x_px + x, -kLimit, kLimit);
    y_px_[at] = std::clamp(end.y_px + y, -kLimit, kLimit);
    z_[at] = std::clamp(end.z * pull.gain - pull.offset, 0.0f, 1.0f);
    inv_w_[at] = end.inv_w;
  };
  set(0, a, -dx - dy, -dy + dx);
  set(1, a, -dx + dy, -dy - dx);
  set(2, b, dx + dy, dy - dx);
  set(3, b, dx - dy, dy + dx);
}

void WireQuads::put_nothing(std::size_t quad) {
  for (std::size_t at = quad * 4; at < quad * 4 + 4; ++at) {
    x_px_[at] = y_px_[at] = z_[at] = 0.0f;
    inv_w_[at] = 1.0f;
  }
}

void WireQuads::draw_edges(Workers& workers, const Projector& projector, const FrameMesh& mesh,
                           std::span<const Edge> edges, float width_px, DepthPull pull) {
  resize(edges.size());
  const auto planes = view_volume_planes();
  const Positions& world = mesh.world->positions;
  for_each_quad(workers, edges.size(), [&](std::size_t quad) {
    const auto [a, b] = edges[quad];
    const int code_a = mesh.device.outcodes[a], code_b = mesh.device.outcodes[b];
    const int any = code_a | code_b;
    if ((code_a & code_b & outcode::kVolume) != 0 || (any & outcode::kNotFinite) != 0) {
      put_nothing(quad);
    } else if ((any & outcode::kMustCut) == 0) {
      put(quad, End::of_vertex(mesh.device, a), End::of_vertex(mesh.device, b), width_px * 0.5f,
          pull);
    } else {
      glm::dvec4 from = clip_position(projector, world, a), to = clip_position(projector, world, b);
      if (clip_line(planes, from, to)) {
        put(quad, End::of_clip(projector, from), End::of_clip(projector, to), width_px * 0.5f,
            pull);
      } else {
        put_nothing(quad);
      }
    }
  });
}

void WireQuads::draw_points(Workers& workers, const FrameMesh& mesh, float size_px,
                            DepthPull pull) {
  const std::size_t count = mesh.world->vertices();
  resize(count);
  for_each_quad(workers, count, [&](std::size_t quad) {
    if (mesh.device.outcodes[quad] != 0) {
      put_nothing(quad);
    } else {
      const End end = End::of_vertex(mesh.device, static_cast<std::uint32_t>(quad));
      put(quad, end, end, size_px * 0.5f, pull);
    }
  });
}

DrawCall WireQuads::draw_call(const LinearRgba& colour) const {
  DrawCall call;
  call.vertices = {x_px_, y_px_, z_, inv_w_};
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
