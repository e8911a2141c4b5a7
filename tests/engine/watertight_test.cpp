// Closed meshes in perspective: a ray enters as often as it leaves, at every sample.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "engine/framing.h"
#include "engine/io/import.h"
#include "engine/vertex_transform.h"
#include "raster/rasterizer.h"
#include "raster/reference_rasterizer.h"
#include "tests/raster/optional_data.h"
#include "tests/sanitized.h"

namespace kinescope {
namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr float kPi = std::numbers::pi_v<float>;

constexpr bool kOneByOne = !kSanitized;  // a hundred thousand frames

/// A grid of vertices closed in both directions, as a torus is.
Mesh torus_grid(int along, int around, glm::vec3 (*place)(float u, float v)) {
  Mesh mesh;
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      mesh.positions.push_back(place(2 * kPi * static_cast<float>(i) / static_cast<float>(along),
                                     2 * kPi * static_cast<float>(j) / static_cast<float>(around)));
    }
  }
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>(i % along * around + j % around);
  };
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
  }
  return mesh;
}

/// The tube of a trefoil, twisted: its frame need not be smooth to be closed.
Mesh knot(int along, int around) {
  return torus_grid(along, around, [](float u, float v) {
    const float radius = 2 + std::cos(3 * u) + 0.6f * std::cos(v);
    return glm::vec3(radius * std::cos(2 * u), radius * std::sin(2 * u),
                     0.6f * std::sin(v) - std::sin(3 * u));
  });
}

/// Meridians that meet in the poles.
Mesh sphere(int rings, int sectors) {
  Mesh mesh;
  mesh.positions = {{0, 1, 0}, {0, -1, 0}};
  const auto at = [&](int ring, int sector) {
    return ring == 0 ? 0u
           : ring == rings
               ? 1u
               : static_cast<std::uint32_t>(2 + (ring - 1) * sectors + sector % sectors);
  };
  for (int ring = 1; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const float a = kPi * static_cast<float>(ring) / static_cast<float>(rings);
      const float b = 2 * kPi * static_cast<float>(sector) / static_cast<float>(sectors);
      mesh.positions.emplace_back(std::sin(a) * std::cos(b), std::cos(a),
                                  std::sin(a) * std::sin(b));
    }
  }
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const std::uint32_t a = at(ring, sector), b = at(ring, sector + 1),
                          c = at(ring + 1, sector + 1), d = at(ring + 1, sector);
      if (a != b) mesh.indices.insert(mesh.indices.end(), {a, b, c});
      if (c != d) mesh.indices.insert(mesh.indices.end(), {a, c, d});
    }
  }
  return mesh;
}

/// The mesh as the device sees it from somewhere outside.
class Projected {
 public:
  explicit Projected(const Mesh& mesh, float azimuth) : indices_(mesh.indices) {
    Scene scene;
    scene.meshes.push_back(mesh);
    scene.nodes.push_back({"", -1, glm::mat4(1.0f), {0}});
    const Camera camera = frame_scene(scene, static_cast<float>(kWidth) / kHeight, azimuth);
    Positions world;
    world.resize(mesh.positions.size());
    for (std::size_t i = 0; i < world.count; ++i) {
      const glm::vec3 p = mesh.positions[i];
      world.x[i] = p.x, world.y[i] = p.y, world.z[i] = p.z;
    }
    device_.resize(world.count + Positions::kPadding);
    const OutcodeSummary codes = project(
        make_projector(camera.clip_from_world(), {0, 0, kWidth, kHeight}, DeviceVertex::kGuardBand),
        world, 0, world.count, device_);
    EXPECT_EQ(codes.any & outcode::kMustCut, 0);
  }
  DrawCall call(CullMode cull) const {
    DrawCall c;
    c.vertices = device_.vertices;
    c.indices = indices_;
    c.cull = cull;
    return c;
  }

 private:
  std::vector<std::uint32_t> indices_;
  DevicePositions device_;
};

/// How often each pixel's centre is covered by the fast path, every triangle drawn alone.
std::vector<int> coverage_one_by_one(const DrawCall& call) {
  Workers workers(1);
  Rasterizer rasterizer(workers);
  RenderTarget target(kWidth, kHeight, 1);
  target.keep_depth = true;
  std::vector<int> times(std::size_t{kWidth} * kHeight, 0);
  for (std::size_t i = 0; i + 3 <= call.indices.size(); i += 3) {
    DrawCall alone = call;
    alone.indices = call.indices.subspan(i, 3);
    if (rasterizer.draw(target, {&alone, 1}).drawn == 0) continue;
    for (std::size_t p = 0; p < times.size(); ++p) times[p] += target.depth.pixels()[p] < 1.0f;
  }
  return times;
}

void expect_watertight(const Mesh& mesh) {
  constexpr float kAzimuths[] = {0.3f, 2.1f};
  for (const float azimuth : kAzimuths) {
    const Projected projected(mesh, azimuth);
    const DrawCall fronts = projected.call(CullMode::kBack);
    const DrawCall backs = projected.call(CullMode::kFront);
    for (const int samples : {1, 4, 8}) {
      const ReferenceImage front = draw_reference(kWidth, kHeight, samples, {&fronts, 1});
      const ReferenceImage back = draw_reference(kWidth, kHeight, samples, {&backs, 1});
      EXPECT_EQ(front.coverage, back.coverage) << samples << " samples from " << azimuth;
      EXPECT_GT(std::count_if(front.coverage.begin(), front.coverage.end(),
                              [](std::uint32_t n) { return n > 0; }),
                kWidth * kHeight * samples / 8);
    }
    if (kOneByOne && azimuth == kAzimuths[0]) {
      EXPECT_EQ(coverage_one_by_one(fronts), coverage_one_by_one(backs));
    }
  }
}

TEST(Watertight, Sphere) { expect_watertight(sphere(40, 64)); }

TEST(Watertight, Knot) {
  expect_watertight(knot(60, 12));
  expect_watertight(knot(700, 24));
}

TEST(Watertight, Bunny) {
  const char* path = "/usr/share/glmark2/models/bunny.obj";
  KINESCOPE_NEEDS(path);
  Warnings warnings;
  const Scene scene = import_model(path, warnings);
  ASSERT_EQ(scene.meshes.size(), 1u);
  expect_watertight(scene.meshes[0]);
}

}  // namespace
}  // namespace kinescope
