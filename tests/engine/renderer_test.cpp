#include "engine/renderer.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <set>

#include "raster/base/simd.h"
#include "renderer_testing.h"

namespace kinescope {
namespace {

TEST(Renderer, SameHashesForAnyThreads) {
  const Scene scene = lit_teapot(8);
  Camera camera = frame_scene(scene, 1.5f);
  camera.eye = glm::mix(camera.eye, camera.look_at, 0.6f);  // near enough that some is cut
  camera.near_plane = 1.0f;
  for (const ShadingModel model :
       {ShadingModel::kFlat, ShadingModel::kGouraud, ShadingModel::kPhong}) {
    std::optional<Picture> first;
    for (const int threads : {1, 2, 8}) {
      Workers workers(threads);
      Renderer renderer(workers);
      Picture p = render_with(renderer, scene, camera, with(model));
      if (!first)
        first = std::move(p);
      else {
        EXPECT_EQ(p.stats.raster.visibility_hash, first->stats.raster.visibility_hash);
        EXPECT_EQ(differing(p, *first), 0);
      }
    }
  }
}

TEST(Renderer, SameVisibilityForAnyInstructionSet) {
  const Scene scene = lit_teapot(8);
  const Camera camera = frame_scene(scene, 1.5f);
  std::optional<Picture> first;
  for (const std::string& target : simd_targets()) {
    use_simd_target(target);
    Picture p = render(scene, camera);
    if (!first)
      first = std::move(p);
    else {
      EXPECT_EQ(p.stats.raster.visibility_hash, first->stats.raster.visibility_hash) << target;
      EXPECT_EQ(differing(p, *first, 1.0f / 255), 0) << target;
    }
  }
  use_simd_target("best");
}

TEST(Renderer, AMeshAtNodesEqualsTheMeshBakedInPlace) {
  const glm::mat4 places[] = {
      glm::translate(glm::mat4(1.0f), {4, 1, 0}),
      glm::scale(glm::rotate(glm::mat4(1.0f), 1.0f, glm::vec3(0, 1, 0)), glm::vec3(0.5f, 2, 1))};
  Scene instanced = lit_teapot(4);
  instanced.nodes = {{"", -1, places[0], {0}}, {"", 0, places[1], {0}}};
  Scene baked = instanced;
  baked.nodes = {{"", -1, glm::mat4(1.0f), {0, 1}}};
  baked.meshes.push_back(baked.meshes[0]);
  const glm::mat4 world[] = {places[0], places[0] * places[1]};
  for (std::size_t i = 0; i < 2; ++i) {
    const glm::mat3 normals = glm::transpose(glm::inverse(glm::mat3(world[i])));
    const glm::mat4& m = world[i];
    for (glm::vec3& p : baked.meshes[i].positions) {
      // In the pipeline's order of additions.
      glm::vec3 q;
      for (int r = 0; r < 3; ++r) {
        q[r] = ((m[0][r] * p.x + m[1][r] * p.y) + m[2][r] * p.z) + m[3][r];
      }
      p = q;
    }
    for (glm::vec3& n : baked.meshes[i].normals) n = glm::normalize(normals * n);
  }
  const Camera camera = frame_scene(instanced, 1.5f);
  const Picture a = render(instanced, camera), b = render(baked, camera);
  EXPECT_EQ(a.stats.raster.visibility_hash, b.stats.raster.visibility_hash);
  EXPECT_EQ(differing(a, b, 1e-4f), 0);
  EXPECT_GT(painted(a), 1000);
  EXPECT_EQ(a.stats.raster.triangles, drawn_triangle_count(instanced));
}

// A mirrored teapot is the mirror image: the same picture with left and right exchanged.
TEST(Renderer, MirrorsKeepTheirFrontFaces) {
  Scene scene = scene_of(teapot_mesh(6));
  scene.ambient = glm::vec3(0.1f);
  scene.lights.push_back({-1, {LightKind::kDirectional, glm::vec3(1), kZero, {0, -0.6f, -0.8f}}});
  Camera camera;
  camera.eye = {0, 3, 12};
  camera.look_at = {0, 1.5f, 0};
  camera.set_field_of_view(0.6f, 1.5f);
  Scene mirrored = scene;
  mirrored.nodes[0].parent_from_local = glm::scale(glm::mat4(1.0f), glm::vec3(-1, 1, 1));
  for (const ShadingModel model : {ShadingModel::kFlat, ShadingModel::kPhong}) {
    const Picture a = render(scene, camera, with(model));
    const Picture b = render(mirrored, camera, with(model));
    int different = 0;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 150; ++x) {
        different += difference(a.pixels().at(x, y), b.pixels().at(149 - x, y)) > 0.02f;
      }
    }
    EXPECT_GT(painted(a), 2000);
    EXPECT_LT(different, 40);  // pixels along outlines, where a sample falls on an edge
  }
}

TEST(Renderer, BackFacesAreCulledUnlessDoubleSided) {
  Scene scene = floor_scene(2.0f);
  Camera below = floor_camera();
  below.look_at = {0, 0, 0};
  below.eye.y = -2.0f;
  EXPECT_EQ(painted(render(scene, below)), 0);
  scene.materials[0].double_sided = true;
  EXPECT_GT(painted(render(scene, below)), 1000);
}

// Far aside of the eye, a surface that faces the direction of view shows its front all the same.
TEST(Renderer, ParallelProjectionLooksAlongOneDirection) {
  Scene scene = floor_scene(1.0f);
  scene.meshes[0].colours.clear();
  scene.materials[0].double_sided = true;
  scene.lights.push_back({-1, {LightKind::kDirectional, glm::vec3(1), kZero, {-1, 0, 0}}});
  // The floor's normal turned from +y to +x, and a little towards the camera.
  scene.nodes[0].parent_from_local =
      glm::rotate(glm::rotate(glm::translate(glm::mat4(1.0f), {10, 0, 0}), -0.1f, {0, 1, 0}),
                  -1.5707964f, {0, 0, 1});
  Camera camera;
  camera.projection = Projection::kOrthographic;
  camera.window_min = {9, -1};
  camera.window_max = {11, 1};
  const Picture p = render(scene, camera);
  EXPECT_GT(painted(p), 500);
  EXPECT_NEAR(p.pixels().at(75, 50).r, 0.1f + std::cos(0.1f), 1e-3f);
}

TEST(Renderer, MovedNodesAndNewMeshesAreSeen) {
  Workers workers(2);
  Renderer renderer(workers);
  Scene scene = lit_teapot(4);
  const Camera camera = frame_scene(scene, 1.5f);
  const Picture first = render_with(renderer, scene, camera);
  scene.nodes[0].parent_from_local = glm::translate(glm::mat4(1.0f), {1, 0, 0});
  const Picture moved = render_with(renderer, scene, camera);
  EXPECT_GT(differing(first, moved, 0.01f), 100);
  EXPECT_EQ(differing(moved, render(scene, camera)), 0);
  scene.meshes[0] = teapot_mesh(3);
  EXPECT_EQ(differing(render_with(renderer, scene, camera), render(scene, camera)), 0);
  // The same memory with other places in it.
  for (glm::vec3& p : scene.meshes[0].positions) p *= 0.5f;
  renderer.invalidate();
  EXPECT_EQ(differing(render_with(renderer, scene, camera), render(scene, camera)), 0);
}

TEST(Renderer, MeshesOutOfSightCostNothing) {
  Scene scene = lit_teapot(4);
  const Camera camera = frame_scene(scene, 1.5f);
  const Picture alone = render(scene, camera);
  for (const glm::vec3 aside : {glm::vec3(0, 0, 500), glm::vec3(80, 0, 0), glm::vec3(0, -90, 0)}) {
    scene.nodes.push_back({"", -1, glm::translate(glm::mat4(1.0f), aside), {0}});
  }
  const Picture crowd = render(scene, camera);
  EXPECT_EQ(crowd.stats.vertices, alone.stats.vertices);
  EXPECT_EQ(crowd.stats.raster.visibility_hash, alone.stats.raster.visibility_hash);
  EXPECT_EQ(differing(crowd, alone), 0);
}

TEST(Renderer, FlatShadingGivesEachTriangleOneColour) {
  const Scene scene = lit_teapot(2);
  const Camera camera = frame_scene(scene, 1.5f);
  const auto colours = [&](ShadingModel model) {
    std::set<std::array<float, 3>> set;
    const auto drawn = render(scene, camera, with(model));
    for (const LinearRgba& c : drawn.pixels().pixels()) set.insert({c.r, c.g, c.b});
    return set.size();
  };
  EXPECT_LE(colours(ShadingModel::kFlat), 64u * 4 - 8 * 2 + 1);
  EXPECT_GT(colours(ShadingModel::kGouraud), 1000u);
  EXPECT_GT(colours(ShadingModel::kPhong), 1000u);
}

// One light above the middle of a large quad: only Phong's highlight appears between vertices.
TEST(Renderer, GouraudMissesAHighlightThatPhongShows) {
  Scene scene = floor_scene(2.0f);
  scene.meshes[0].colours.clear();
  scene.materials[0].specular = glm::vec3(1.0f);
  scene.materials[0].shininess = 60.0f;
  scene.lights.push_back({-1, {LightKind::kPoint, glm::vec3(1), {0, 3, 0}, {}}});
  Camera camera;
  camera.eye = {0, 4, 0.001f};
  camera.look_at = kZero;
  camera.set_field_of_view(0.8f, 1.5f);
  const auto middle = [&](ShadingModel model) {
    return render(scene, camera, with(model)).pixels().at(75, 50).r;
  };
  // Ambient 0.1 + diffuse 1 + highlight 1, against the mean of the corners.
  EXPECT_NEAR(middle(ShadingModel::kPhong), 2.1f, 0.01f);
  EXPECT_NEAR(middle(ShadingModel::kGouraud), 0.1f + 3.0f / std::sqrt(17.0f), 0.02f);
  EXPECT_LT(middle(ShadingModel::kFlat), 1.2f);
}

TEST(Renderer, BadScenesGiveCalmPictures) {
  Scene nothing;
  EXPECT_EQ(painted(render(nothing, Camera{})), 0);
  Scene scene = lit_teapot(3);
  const Camera camera = frame_scene(scene, 1.5f);
  const int whole = painted(render(scene, camera));
  for (std::size_t i = 0; i < scene.meshes[0].positions.size(); i += 7) {
    scene.meshes[0].positions[i].x = i % 2 ? NAN : INFINITY;
  }
  const Picture holes = render(scene, camera);
  EXPECT_GT(painted(holes), whole / 10);
  EXPECT_LT(painted(holes), whole);
  for (const LinearRgba& c : holes.pixels().pixels()) EXPECT_TRUE(std::isfinite(c.r));
  scene.meshes[0].indices.back() = 1u << 30;
  scene.nodes.push_back({"", -1, glm::mat4(NAN), {0, -3, 9}});
  EXPECT_EQ(painted(render(scene, camera)), 0);
}

TEST(Renderer, FromInsideAModel) {
  Scene scene = lit_teapot(8);
  scene.materials[0].double_sided = true;
  Camera camera;
  camera.eye = {0, 1.2f, 0};
  camera.look_at = {1, 1.3f, 0.2f};
  camera.near_plane = 1e-4f;
  camera.far_plane = 100.0f;
  camera.set_field_of_view(1.5f, 1.5f);
  const Picture p = render(scene, camera);
  EXPECT_EQ(painted(p), 150 * 100);  // walls all around
  for (const LinearRgba& c : p.pixels().pixels()) ASSERT_TRUE(std::isfinite(c.r));
}

}  // namespace
}  // namespace kinescope
