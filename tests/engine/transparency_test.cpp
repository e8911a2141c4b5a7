// Materials that let light through.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/renderer.h"
#include "raster/image/codecs.h"
#include "tests/engine/model_files.h"

namespace kinescope {
namespace {

using testing::import_contents;

/// A square that faces the camera and fills the picture, `depth` in front of it.
Mesh pane(float depth, int material) {
  Mesh mesh;
  for (int i = 0; i < 4; ++i) {
    const float x = static_cast<float>(i & 1), y = static_cast<float>(i >> 1);
    mesh.positions.emplace_back((2 * x - 1) * 50.0f, (2 * y - 1) * 50.0f, -depth);
    mesh.normals.emplace_back(0, 0, 1);
    mesh.texcoords.emplace_back(x, 1 - y);
  }
  mesh.indices = {0, 1, 3, 0, 3, 2};
  mesh.material = material;
  return mesh;
}

Material glass(glm::vec3 colour, float opacity) {
  Material material;
  material.base_colour = colour;
  material.opacity = opacity;
  return material;
}

struct Pane {
  float depth;
  glm::vec3 colour;
  float opacity;
};

Scene scene_of(std::initializer_list<Pane> panes) {
  Scene scene;
  Node node;
  for (const Pane& p : panes) {
    const auto i = static_cast<int>(scene.meshes.size());
    scene.materials.push_back(glass(p.colour, p.opacity));
    scene.meshes.push_back(pane(p.depth, i));
    node.meshes.push_back(i);
  }
  scene.nodes.push_back(node);
  return scene;
}

LinearRgba middle(const Scene& scene, bool textures = true) {
  Workers workers(2);
  Renderer renderer(workers);
  RenderTarget target(16, 12, 4, ColourFormat::kLinearFloat);
  RenderSettings settings;
  settings.shading = ShadingModel::kUnlit;
  settings.textures = textures;
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.look_at = {0, 0, -1};
  camera.set_field_of_view(0.5f, 16.0f / 12.0f);
  renderer.render(scene, camera, settings, target);
  return std::get<Image<LinearRgba>>(target.colour).at(7, 5);
}

void expect_near(LinearRgba got, LinearRgba want) {
  EXPECT_NEAR(got.r, want.r, 1e-3f);
  EXPECT_NEAR(got.g, want.g, 1e-3f);
  EXPECT_NEAR(got.b, want.b, 1e-3f);
}

constexpr Pane kRedGlass = {2, {1, 0, 0}, 0.5f};
constexpr Pane kGreenGlass = {4, {0, 1, 0}, 0.25f};
constexpr Pane kWall = {6, {0, 0, 1}, 1.0f};

TEST(RendererTransparency, PanesAreBlendedFarToNearInAnyOrder) {
  const LinearRgba expected = {0.5f, 0.125f, 0.375f, 1};
  expect_near(middle(scene_of({kRedGlass, kGreenGlass, kWall})), expected);
  expect_near(middle(scene_of({kWall, kGreenGlass, kRedGlass})), expected);
  expect_near(middle(scene_of({kGreenGlass, kWall, kRedGlass})), expected);
}

TEST(RendererTransparency, AWallHidesTheGlassBehindIt) {
  expect_near(middle(scene_of({{1, {0, 0, 1}, 1.0f}, kRedGlass, kGreenGlass})), {0, 0, 1, 1});
  expect_near(middle(scene_of({kRedGlass, {1, {0, 0, 1}, 1.0f}})), {0, 0, 1, 1});
}

TEST(RendererTransparency, NothingIsSeenOfASurfaceWithoutOpacity) {
  expect_near(middle(scene_of({{2, {1, 1, 1}, 0.0f}, kWall})), {0, 0, 1, 1});
}

/// The left half of the picture's texture is missing, the right half is there.
TEST(RendererTransparency, ATexturesAlphaLetsLightThrough) {
  for (const bool is_hole : {false, true}) {
    Scene scene = scene_of({{2, {1, 1, 1}, 1.0f}, kWall});
    Image<Srgb8> picture(2, 1, {255, 0, 0, 255});
    picture.at(is_hole ? 0 : 1, 0).a = 0;
    scene.textures.emplace_back(picture, Filter::kNearest, Wrap::kClamp, Wrap::kClamp);
    scene.materials[0].base_texture = 0;
    // Pixel 7 of 16 lies left of the middle.
    expect_near(middle(scene), is_hole ? LinearRgba{0, 0, 1, 1} : LinearRgba{1, 0, 0, 1});
    expect_near(middle(scene, false), {1, 1, 1, 1});
  }
}

TEST(RendererTransparency, DissolvedMaterialsOfFilesAreTransparent) {
  testing::write_file("glass.mtl", "newmtl red\nKd 1 0 0\nd 0.5\nnewmtl wall\nKd 0 0 1\n");
  const auto model = import_contents("glass.obj",
                                     "mtllib glass.mtl\n"
                                     "v -50 -50 -2\nv 50 -50 -2\nv 50 50 -2\nv -50 50 -2\n"
                                     "v -50 -50 -6\nv 50 -50 -6\nv 50 50 -6\nv -50 50 -6\n"
                                     "usemtl red\nf 1 2 3 4\nusemtl wall\nf 5 6 7 8\n");
  expect_near(middle(model.scene), {0.5f, 0, 0.5f, 1});
}

}  // namespace
}  // namespace kinescope
