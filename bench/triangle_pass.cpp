#include "bench/triangle_pass.h"

#include <algorithm>
#include <cmath>

#include "engine/cut_triangles.h"
#include "raster/base/error.h"
#include "raster/rasterizer.h"
#include "raster/triangle_setup.h"

namespace kinescope::bench {
namespace {

template <TriangleColours kColours>
void shade(const Batch& batch, LinearRgba* out) {
  for (int i = 0; i < batch.size; ++i) {
    const Linear8 c = colour_of_triangle(batch.primitive[i], kColours);
    out[i] = {static_cast<float>(c.r) / 255.0f, static_cast<float>(c.g) / 255.0f,
              static_cast<float>(c.b) / 255.0f, 1.0f};
  }
}

TrianglePass::Meeting meet_part(const SnappedTriangle& t, int x, int y) {
  TrianglePass::Meeting meeting{true, 1, 1e9};
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    const auto from = static_cast<std::size_t>(i), to = static_cast<std::size_t>(j);
    const std::int64_t e = t.edge(i, x * 256 + 128, y * 256 + 128);
    meeting.covered &= e > 0 || (e == 0 && t.is_top_left(i));
    const double length = std::hypot(t.x[to] - t.x[from], t.y[to] - t.y[from]);
    if (length > 0) {
      meeting.edge_256ths =
          std::min(meeting.edge_256ths, std::abs(static_cast<double>(e)) / length);
    }
  }
  meeting.depth = t.depth.at(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  return meeting;
}

}  // namespace

Linear8 colour_of_triangle(std::uint32_t triangle, TriangleColours colours) {
  const std::uint32_t number = triangle + 1;
  const auto byte = [](std::uint32_t v, int shift) {
    return static_cast<std::uint8_t>(v >> shift & 255u);
  };
  if (colours == TriangleColours::kNumber) {
    return {byte(number, 0), byte(number, 8), byte(number, 16), 255};
  }
  // The peer's shader does the same. Not linear, so that neighbours' numbers do not average to one
  // between them. Source: the finaliser of A. Appleby's MurmurHash3, first half.
  std::uint32_t mixed = number * 2654435761u;
  mixed = (mixed ^ mixed >> 16) * 0x85ebca6bu;
  return {255, byte(mixed, 24), byte(mixed, 16), 255};
}

struct TrianglePass::State {
  Workers workers{2};
  int width = 0, height = 0;
  Positions world;
  DevicePositions device;
  CutTriangles cut;
  DrawCall call;
};

TrianglePass::TrianglePass(const Workload& workload, const Camera& camera, int width, int height)
    : state_(std::make_unique<State>()) {
  if (workload.scene.meshes.size() != 1) {
    throw Error(ErrorKind::kUsage, "triangles are numbered in one mesh only", workload.name);
  }
  State& s = *state_;
  const Mesh& mesh = workload.scene.meshes[0];
  s.width = width;
  s.height = height;
  s.world.resize(mesh.positions.size());
  for (std::size_t i = 0; i < s.world.count; ++i) {
    const glm::vec3 p = mesh.positions[i];
    s.world.x[i] = p.x, s.world.y[i] = p.y, s.world.z[i] = p.z;
  }
  s.device.resize(s.world.count + Positions::kPadding);
  const Viewport viewport{0, 0, static_cast<float>(width), static_cast<float>(height)};
  constexpr float kGuardBand = DeviceVertex::kGuardBand;
  const Projector projector = make_projector(camera.clip_from_world(), viewport, kGuardBand);
  project(projector, s.world, 0, s.world.count, s.device);
  std::vector<float> rows(s.world.count);
  s.cut.cut(s.workers, projector, kGuardBand, s.world, mesh.indices, s.device, rows, 1, 0);
  s.call.vertices = s.device.vertices;
  s.call.indices = s.cut.indices();
  s.call.source_triangle = s.cut.source_triangle();
}

TrianglePass::~TrianglePass() = default;

Image<Linear8> TrianglePass::picture(int samples, TriangleColours colours) const {
  State& s = *state_;
  DrawCall call = s.call;
  call.shade = colours == TriangleColours::kNumber ? shade<TriangleColours::kNumber>
                                                   : shade<TriangleColours::kMixed>;
  Rasterizer rasterizer(s.workers);
  RenderTarget target(s.width, s.height, samples, ColourFormat::kLinear8);
  rasterizer.draw(target, {&call, 1});
  return std::get<Image<Linear8>>(target.colour);
}

TrianglePass::Meeting TrianglePass::meet(std::uint32_t triangle, int x, int y) const {
  const DrawCall& call = state_->call;
  const auto parts =
      std::equal_range(call.source_triangle.begin(), call.source_triangle.end(), triangle);
  for (auto part = parts.first; part != parts.second; ++part) {
    SnappedTriangle t;
    if (!set_up_triangle(call, static_cast<std::size_t>(part - call.source_triangle.begin()), t)) {
      continue;
    }
    const Meeting meeting = meet_part(t, x, y);
    if (meeting.covered || part + 1 == parts.second) return meeting;
  }
  return {};
}

}  // namespace kinescope::bench
