#include "engine/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numbers>

namespace kinescope {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

glm::vec3 view_point(const Camera& camera, glm::vec3 world) {
  return glm::vec3(camera.view_from_world() * glm::vec4(world, 1));
}

glm::vec3 ndc(const Camera& camera, glm::vec3 world) {
  const glm::vec4 clip = camera.clip_from_world() * glm::vec4(world, 1);
  return glm::vec3(clip) / clip.w;
}

void expect_near(glm::vec3 got, glm::vec3 want, float tolerance = 1e-5f) {
  EXPECT_NEAR(glm::distance(got, want), 0.0f, tolerance)
      << got.x << ' ' << got.y << ' ' << got.z << " is not " << want.x << ' ' << want.y << ' '
      << want.z;
}

TEST(Camera, LooksAlongItsNegativeZ) {
  Camera camera;
  camera.eye = {3, 4, 5};
  camera.look_at = {3, 4, -5};
  expect_near(view_point(camera, {3, 4, 5}), {0, 0, 0});
  expect_near(view_point(camera, {4, 6, 2}), {1, 2, -3});
}

// From (0, 0, 10) to the origin, turned so that +x is up: y of the world points to the left.
TEST(Camera, UpTurnsThePicture) {
  Camera camera;
  camera.eye = {0, 0, 10};
  camera.up = {1, 0, 0};
  expect_near(view_point(camera, {1, 0, 0}), {0, 1, -10});
  expect_near(view_point(camera, {0, 1, 0}), {-1, 0, -10});
}

TEST(Camera, UpNeedNotBeSquareToTheLineOfSight) {
  Camera camera;
  camera.eye = {0, 3, 4};
  // Forward is (0, -3, -4) / 5, so the picture's up is (0, 4, -3) / 5.
  expect_near(view_point(camera, {0, 4, -3}), {0, 5, -5});
  expect_near(view_point(camera, {7, 0, 0}), {7, 0, -5});
}

TEST(Camera, ViewMatrixIsRigidForAnyUp) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const glm::vec3 ups[] = {{0, 1, 0},         {0, 0, 0},   {0, -2, 0},   {1e-30f, 0, 0},
                           {kInfinity, 0, 0}, {NAN, 1, 0}, {0, 1e30f, 0}};
  const glm::vec3 targets[] = {{0, -1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, -1}, {1, 2, 3}};
  for (const glm::vec3& up : ups) {
    for (const glm::vec3& target : targets) {
      Camera camera;
      camera.eye = glm::vec3(0.0f);
      camera.look_at = target;
      camera.up = up;
      const glm::mat3 m(camera.view_from_world());
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          EXPECT_NEAR(glm::dot(m[i], m[j]), i == j ? 1.0f : 0.0f, 1e-5f);
        }
      }
      EXPECT_GT(glm::dot(glm::cross(m[0], m[1]), m[2]), 0.9f);
    }
  }
}

TEST(Camera, LookingStraightDownPutsXToTheRight) {
  Camera camera;
  camera.eye = {0, 5, 0};
  expect_near(view_point(camera, {1, 0, 0}), {1, 0, -5});
  expect_near(view_point(camera, {0, 0, -1}), {0, 1, -5});
}

TEST(Camera, FieldOfViewReachesTheEdges) {
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.look_at = {0, 0, -1};
  camera.view_distance = 3.0f;
  camera.set_field_of_view(kPi / 2, 2.0f);
  // At 90 degrees the half height equals the distance; the half width is twice that.
  expect_near(ndc(camera, {14, 7, -7}) * glm::vec3(1, 1, 0), {1, 1, 0});
  expect_near(ndc(camera, {-10, -5, -5}) * glm::vec3(1, 1, 0), {-1, -1, 0});
}

TEST(Camera, DepthRunsFromNearToFar) {
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    Camera camera;
    camera.eye = {0, 0, 0};
    camera.look_at = {0, 0, -1};
    camera.projection = projection;
    camera.near_plane = 2.0f;
    camera.far_plane = 50.0f;
    EXPECT_NEAR(ndc(camera, {0, 0, -2}).z, 0.0f, 1e-6f);
    EXPECT_NEAR(ndc(camera, {0, 0, -50}).z, 1.0f, 1e-6f);
    EXPECT_LT(ndc(camera, {0, 0, -5}).z, ndc(camera, {0, 0, -6}).z);
  }
}

TEST(Camera, WKeepsTheDistanceInFront) {
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.look_at = {0, 0, -1};
  EXPECT_FLOAT_EQ((camera.clip_from_world() * glm::vec4(1, 2, -7, 1)).w, 7.0f);
}

// A window that lies aside of the axis, as in a picture cut from a larger one.
TEST(Camera, WindowNeedNotBeCentred) {
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.look_at = {0, 0, -1};
  camera.view_distance = 2.0f;
  camera.window_min = {1, -1};
  camera.window_max = {5, 1};
  // The ray through the window's corner (5, 1, -2), and twice as far.
  expect_near(ndc(camera, {5, 1, -2}) * glm::vec3(1, 1, 0), {1, 1, 0});
  expect_near(ndc(camera, {10, 2, -4}) * glm::vec3(1, 1, 0), {1, 1, 0});
  expect_near(ndc(camera, {1, -1, -2}) * glm::vec3(1, 1, 0), {-1, -1, 0});
  expect_near(ndc(camera, {3, 0, -2}) * glm::vec3(1, 1, 0), {0, 0, 0});
  camera.projection = Projection::kOrthographic;
  expect_near(ndc(camera, {5, 1, -4}) * glm::vec3(1, 1, 0), {1, 1, 0});
  expect_near(ndc(camera, {1, -1, -9}) * glm::vec3(1, 1, 0), {-1, -1, 0});
}

TEST(Camera, AspectWidensAboutTheWindowsCentre) {
  Camera camera;
  camera.window_min = {1, -1};
  camera.window_max = {5, 3};
  camera.set_aspect(2.0f);
  EXPECT_EQ(camera.window_min, glm::vec2(-1, -1));
  EXPECT_EQ(camera.window_max, glm::vec2(7, 3));
}

TEST(Camera, SafeWithUnorderedDepthPlanes) {
  Camera camera;
  for (const glm::vec2 planes : {glm::vec2(0, 0), glm::vec2(-1, 5), glm::vec2(5, 1),
                                 glm::vec2(NAN, 10), glm::vec2(1, INFINITY)}) {
    camera.near_plane = planes.x;
    camera.far_plane = planes.y;
    for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
      camera.projection = projection;
      const glm::mat4 clip = camera.clip_from_view();
      for (int i = 0; i < 16; ++i) EXPECT_TRUE(std::isfinite(clip[i / 4][i % 4]));
    }
  }
}

TEST(WindowToViewport, MapsCornersExactly) {
  const ViewportTransform map = device_from_ndc({10, 20, 640, 480});
  const auto at = [&](float x, float y) { return glm::vec2(x, y) * map.scale + map.offset; };
  EXPECT_EQ(at(-1, 1), glm::vec2(10, 20));    // top left
  EXPECT_EQ(at(1, -1), glm::vec2(650, 500));  // bottom right
  EXPECT_EQ(at(0, 0), glm::vec2(330, 260));   // middle
  EXPECT_EQ(at(-0.5f, 0.5f), glm::vec2(170, 140));
}

// The textbook's chain: a window of the world onto a viewport, by way of (0, 0)-(1, 1).
TEST(WindowToViewport, CarriesAWindowOntoTheDevice) {
  Camera camera;
  camera.projection = Projection::kOrthographic;
  camera.eye = {0, 0, 1};
  camera.window_min = {10, 5};
  camera.window_max = {50, 25};
  const ViewportTransform map = device_from_ndc({0, 0, 400, 200});
  const glm::vec3 p = ndc(camera, {20, 10, 0});
  EXPECT_NEAR(p.x * map.scale.x + map.offset.x, 100.0f, 1e-4f);
  EXPECT_NEAR(p.y * map.scale.y + map.offset.y, 150.0f, 1e-4f);
}

}  // namespace
}  // namespace kinescope
