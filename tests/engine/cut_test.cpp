// The clipping stage: what it leaves alone stays the same to the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "engine/cut_triangles.h"
#include "engine/framing.h"
#include "engine/teapot.h"
#include "raster/rasterizer.h"

namespace kinescope {
namespace {

constexpr int kWidth = 160, kHeight = 120;

/// The world position as a colour.
void shade_position(const Batch& batch, LinearRgba* out) {
  for (int i = 0; i < batch.size; ++i) {
    out[i] = {batch.attribute[0][i] * 0.1f + 0.5f, batch.attribute[1][i] * 0.1f + 0.5f,
              batch.attribute[2][i] * 0.1f + 0.5f, 1.0f};
  }
}

/// A mesh of world space through the stage, with any guard band, into a picture.
class Stage {
 public:
  Stage(const Mesh& mesh, const Camera& camera, float guard_band_px, int threads = 2)
      : workers_(threads), indices_(mesh.indices) {
    world_.resize(mesh.positions.size());
    for (std::size_t i = 0; i < world_.count; ++i) {
      const glm::vec3 p = mesh.positions[i];
      world_.x[i] = p.x, world_.y[i] = p.y, world_.z[i] = p.z;
      rows_.insert(rows_.end(), {p.x, p.y, p.z, 0.0f});
    }
    device_.resize(world_.count + Positions::kPadding);
    const Projector projector =
        make_projector(camera.clip_from_world(), {0, 0, kWidth, kHeight}, guard_band_px);
    project(projector, world_, 0, world_.count, device_);
    cut_.cut(workers_, projector, guard_band_px, world_, indices_, device_, rows_, 4, 3);
  }

  DrawCall call() const {
    DrawCall call;
    const std::size_t n = vertices();
    call.vertices = std::span(device_.vertices).first(n);
    call.indices = cut_.indices();
    call.source_triangle = cut_.source_triangle();
    call.attributes = rows_;
    call.attribute_count = 3;
    call.attribute_stride = 4;
    call.cull = CullMode::kNone;
    call.shade = shade_position;
    return call;
  }

  Image<LinearRgba> picture() {
    RenderTarget target(kWidth, kHeight, 1, ColourFormat::kLinearFloat);
    Rasterizer rasterizer(workers_);
    const DrawCall only = call();
    hash_ = rasterizer.draw(target, {&only, 1}, true).visibility_hash;
    return std::get<Image<LinearRgba>>(target.colour);
  }

  std::size_t vertices() const { return world_.count + cut_.new_vertices(); }
  const CutTriangles& cut() const { return cut_; }
  const DevicePositions& device() const { return device_; }
  std::uint64_t hash() const { return hash_; }

 private:
  Workers workers_;
  std::vector<std::uint32_t> indices_;
  Positions world_;
  DevicePositions device_;
  std::vector<float> rows_;
  CutTriangles cut_;
  std::uint64_t hash_ = 0;
};

Camera camera_of(const Mesh& mesh) {
  Scene scene;
  scene.meshes.push_back(mesh);
  scene.nodes.push_back({"", -1, glm::mat4(1.0f), {0}});
  return frame_scene(scene, static_cast<float>(kWidth) / kHeight);
}

float difference(LinearRgba a, LinearRgba b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

TEST(CutTriangles, LeavesAPictureThatFitsAlone) {
  const Mesh mesh = teapot_mesh(6);
  const Camera camera = camera_of(mesh);
  Stage wide(mesh, camera, 32768.0f), tight(mesh, camera, 170.0f);
  EXPECT_EQ(wide.cut().cut_count(), 0u);
  EXPECT_EQ(tight.cut().cut_count(), 0u);
  ASSERT_EQ(wide.cut().indices().size(), mesh.indices.size());
  EXPECT_TRUE(std::equal(mesh.indices.begin(), mesh.indices.end(), wide.cut().indices().begin()));
  EXPECT_EQ(wide.picture(), tight.picture());
  EXPECT_EQ(wide.hash(), tight.hash());
}

TEST(CutTriangles, AnotherTriangleThatIsCutChangesNothingElse) {
  Mesh mesh = teapot_mesh(6);
  const Camera camera = camera_of(mesh);
  Stage alone(mesh, camera, 32768.0f);
  // From left of the picture and from below it, past its corner, to behind the eye: cut, and still
  // not seen, as x + w is -3, 1 and 0 at the corners, and y + w is 1, -3 and 0.
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const glm::mat4 world_from_view = glm::inverse(camera.view_from_world());
  const float distance = glm::length(camera.eye - camera.look_at);
  for (const glm::vec3 xyw : {glm::vec3(-4, 0, 1), {0, -4, 1}, {1, 1, -1}}) {
    const glm::vec3 view(xyw.x * camera.window_max.x, xyw.y * camera.window_max.y, -xyw.z);
    mesh.positions.emplace_back(world_from_view * glm::vec4(distance * view, 1.0f));
  }
  mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  Stage both(mesh, camera, 32768.0f);
  EXPECT_EQ(alone.cut().cut_count(), 0u);
  EXPECT_GE(both.cut().cut_count(), 1u);
  EXPECT_GT(both.cut().source_triangle().size(), alone.cut().source_triangle().size());
  EXPECT_EQ(alone.picture(), both.picture());
}

// A guard band hardly larger than the picture cuts many triangles at its edge, out of sight.
TEST(CutTriangles, ATightGuardBandHardlyChangesThePicture) {
  const Mesh mesh = teapot_mesh(5);
  Camera camera = camera_of(mesh);
  camera.window_min *= 0.3f;
  camera.window_max *= 0.3f;
  Stage wide(mesh, camera, 32768.0f), tight(mesh, camera, 164.0f);
  EXPECT_EQ(wide.cut().cut_count(), 0u);
  EXPECT_GT(tight.cut().cut_count(), 10u);
  const Image<LinearRgba> a = wide.picture(), b = tight.picture();
  int different = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    different += difference(a.pixels()[i], b.pixels()[i]) > 1e-3f;
  }
  EXPECT_LT(different, 30);  // of 19200: where a cut edge meets the screen at another 1/256 pixel
  for (const DeviceVertex& v : tight.device().vertices) EXPECT_LE(std::abs(v.x_px), 164.0f);
}

TEST(CutTriangles, NewVerticesLieInTheGuardBandAndTheDepthRange) {
  Mesh mesh = teapot_mesh(5);
  Camera camera;
  camera.eye = {0, 1, 0.3f};
  camera.look_at = {1, 1, 0};
  camera.near_plane = 1e-6f;
  camera.far_plane = 2.5f;
  camera.set_field_of_view(1.0f, 1.33f);
  const Stage stage(mesh, camera, 32768.0f);
  EXPECT_GT(stage.cut().cut_count(), 10u);
  for (const std::uint32_t i : stage.cut().indices()) {
    ASSERT_LT(i, stage.vertices());
    EXPECT_LE(std::abs(stage.device().vertices[i].x_px), 32768.0f);
    EXPECT_LE(std::abs(stage.device().vertices[i].y_px), 32768.0f);
    EXPECT_TRUE(stage.device().vertices[i].z >= 0.0f && stage.device().vertices[i].z <= 1.0f);
    EXPECT_TRUE(stage.device().vertices[i].inv_w > 0.0f &&
                std::isfinite(stage.device().vertices[i].inv_w));
  }
}

TEST(CutTriangles, KeepsOrderAndSourcesForAnyThreads) {
  Mesh mesh = teapot_mesh(24);  // several tasks
  Camera camera = camera_of(mesh);
  camera.near_plane = glm::length(camera.eye - camera.look_at);
  const Stage one(mesh, camera, 32768.0f, 1), eight(mesh, camera, 32768.0f, 8);
  EXPECT_GT(one.cut().cut_count(), 100u);
  EXPECT_TRUE(std::ranges::equal(one.cut().indices(), eight.cut().indices()));
  EXPECT_TRUE(std::ranges::equal(one.cut().source_triangle(), eight.cut().source_triangle()));
  EXPECT_TRUE(std::ranges::is_sorted(one.cut().source_triangle()));
  EXPECT_EQ(one.device().vertices, eight.device().vertices);
}

TEST(CutTriangles, DropsWhatIsOutsideOrNotFinite) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0},  {1, 0, 0},   {0, 1, 0},  {50, 0, 0}, {51, 0, 0},
                    {50, 1, 0}, {NAN, 0, 0}, {0, 0, 50}, {1, 0, 50}, {0, 1, 50}};
  mesh.indices = {0, 1, 2, 3, 4, 5, 0, 1, 6, 7, 8, 9, 0, 2, 1};
  Camera camera;
  const Stage stage(mesh, camera, 32768.0f);
  EXPECT_EQ(stage.cut().cut_count(), 0u);
  const std::vector<std::uint32_t> want{0, 1, 2, 0, 2, 1}, sources{0, 4};
  EXPECT_TRUE(std::ranges::equal(stage.cut().indices(), want));
  EXPECT_TRUE(std::ranges::equal(stage.cut().source_triangle(), sources));
}

}  // namespace
}  // namespace kinescope
