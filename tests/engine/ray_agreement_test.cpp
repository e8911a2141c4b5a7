// The renderer against rays: what each pixel of a floor shows is where its ray meets it.
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "renderer_testing.h"

namespace kinescope {
namespace {

/// Where the ray through a pixel's centre meets the floor, from the camera's own data.
struct Hit {
  double x = 0, z = 0, distance = -1;
};
Hit floor_hit(const Camera& camera, double px, double py, int width, int height) {
  const glm::dvec3 eye(camera.eye);
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.look_at) - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
  const glm::dvec3 up = glm::cross(right, forward);
  const glm::dvec2 size = camera.window_max - camera.window_min;
  const double wx = camera.window_min.x + size.x * px / width;
  const double wy = camera.window_max.y - size.y * py / height;
  const glm::dvec3 ray = forward * double{camera.view_distance} + right * wx + up * wy;
  if (ray.y >= 0) return {};
  const double t = -eye.y / ray.y;
  return {eye.x + t * ray.x, eye.z + t * ray.z, t};
}

/// Compares every pixel of the floor with the ray's hit.
void expect_floor(const Picture& p, const Camera& camera, float size, double tolerance) {
  int inside = 0;
  for (int y = 0; y < p.target.height; ++y) {
    for (int x = 0; x < p.target.width; ++x) {
      const Hit hit = floor_hit(camera, x + 0.5, y + 0.5, p.target.width, p.target.height);
      const double edge = std::max(std::abs(hit.x), std::abs(hit.z)) - size;
      if (hit.distance < 0 || edge > -0.05 * hit.distance) continue;
      const LinearRgba c = p.pixels().at(x, y);
      ASSERT_NEAR(c.r, (hit.x / size + 1) / 2, tolerance) << x << ',' << y;
      ASSERT_NEAR(c.g, (hit.z / size + 1) / 2, tolerance) << x << ',' << y;
      ++inside;
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(Renderer, AttributesFollowTheRayThroughEveryPixel) {
  const Scene scene = floor_scene(2.0f);
  Camera camera = floor_camera();
  camera.look_at = {0, 0, 0};
  const Picture p = render(scene, camera, with(ShadingModel::kUnlit));
  EXPECT_EQ(p.stats.clipped, 0u);
  // Snapping to 1/256 pixel moves the floor by as much as that.
  expect_floor(p, camera, 2.0f, 5e-4);
}

// The floor runs on below and behind the camera: cut at the near plane, it stays where it is.
TEST(Renderer, CutTrianglesFollowTheRayToo) {
  const float size = 40.0f;
  const Picture p = render(floor_scene(size), floor_camera(), with(ShadingModel::kUnlit));
  EXPECT_EQ(p.stats.clipped, 2u);
  expect_floor(p, floor_camera(), size, 1e-3);
}

TEST(Renderer, AWindowAsideOfTheAxisShowsItsPartOfThePicture) {
  Camera camera = floor_camera();
  camera.view_distance = 2.0f;
  camera.window_min = {0.2f, -1.5f};
  camera.window_max = {1.7f, -0.5f};
  expect_floor(render(floor_scene(40.0f), camera, with(ShadingModel::kUnlit)), camera, 40.0f, 1e-3);
}

TEST(Renderer, TexturesArePerspectiveCorrect) {
  Image<Linear8> picture(256, 256);
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      picture.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 0, 255};
    }
  }
  Scene scene = floor_scene(2.0f);
  scene.meshes[0].colours.clear();
  scene.textures.emplace_back(picture, Filter::kBilinear, Wrap::kClamp, Wrap::kClamp);
  scene.materials[0].base_texture = 0;
  Camera camera = floor_camera();
  camera.look_at = {0, 0, 0};
  // A texel's centre at u holds 256 u - 0.5 in 255ths.
  const Picture p = render(scene, camera, with(ShadingModel::kUnlit));
  expect_floor(p, camera, 2.0f, 1.5 / 255);
  RenderSettings plain = with(ShadingModel::kUnlit);
  plain.textures = false;
  EXPECT_EQ(render(scene, camera, plain).pixels().at(75, 60), (LinearRgba{1, 1, 1, 1}));
}

}  // namespace
}  // namespace kinescope
