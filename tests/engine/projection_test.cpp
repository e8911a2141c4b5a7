#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numbers>

#include "engine/projection/axonometric.h"
#include "engine/projection/oblique.h"
#include "engine/projection/orthographic.h"
#include "engine/projection/vanishing_points.h"
#include "engine/projection/viewing_steps.h"
#include "engine/projection/window_to_viewport.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

using Flat = glm::dvec2;
using Vec = glm::dvec3;

Flat picture(const glm::dmat4& m, const Vec& p) { return Flat(apply(m, p)); }

double angle_deg(const Flat& v) { return std::atan2(v.y, v.x) * 180 / std::numbers::pi; }

void expect_near(const Flat& got, const Flat& want, double tolerance = 1e-12) {
  EXPECT_NEAR(got.x, want.x, tolerance);
  EXPECT_NEAR(got.y, want.y, tolerance);
}

TEST(Orthographic, FrontTopAndSideOfOneCorner) {
  const Vec p(1, 2, 3);
  EXPECT_EQ(apply(picture_from_world(OrthographicView::kFront), p), Vec(1, 2, 3));
  EXPECT_EQ(apply(picture_from_world(OrthographicView::kTop), p), Vec(1, -3, 2));
  EXPECT_EQ(apply(picture_from_world(OrthographicView::kSide), p), Vec(-3, 2, 1));
}

TEST(Axonometric, IsometricFiguresAsPrinted) {
  const Axonometric view = isometric();
  EXPECT_NEAR(view.turn_deg, -45, 1e-12);
  EXPECT_NEAR(view.tilt_deg, 35.264389682754654, 1e-12);
  const glm::dmat4 m = picture_from_world(view);
  const Vec f = foreshortening(m);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(f[i], std::sqrt(2.0 / 3.0), 1e-14);
  EXPECT_NEAR(angle_deg(picture(m, {1, 0, 0})), -30, 1e-12);
  EXPECT_NEAR(angle_deg(picture(m, {0, 1, 0})), 90, 1e-12);
  EXPECT_NEAR(angle_deg(picture(m, {0, 0, 1})), -150, 1e-12);
  EXPECT_EQ(axonometric_kind(view), AxonometricKind::kIsometric);
}

TEST(Axonometric, DimetricForeshortensZAsAsked) {
  for (const double f : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Axonometric view = dimetric(f);
    const Vec got = foreshortening(picture_from_world(view));
    EXPECT_NEAR(got.z, f, 1e-12);
    EXPECT_NEAR(got.x, got.y, 1e-12);
    EXPECT_EQ(axonometric_kind(view), AxonometricKind::kDimetric);
  }
  // By half: 20.705 and 22.208 degrees.
  EXPECT_NEAR(dimetric(0.5).tilt_deg, 20.705, 5e-4);
  EXPECT_NEAR(dimetric(0.5).turn_deg, -22.208, 5e-4);
  EXPECT_THROW(dimetric(1.1), Error);
  EXPECT_THROW(dimetric(-0.1), Error);
  EXPECT_THROW(dimetric(NAN), Error);
}

TEST(Axonometric, TrimetricSquaresAddUpToTwo) {
  for (double turn = -80; turn < 90; turn += 33) {
    const Axonometric view{turn, 25};
    const Vec f = foreshortening(picture_from_world(view));
    EXPECT_NEAR(glm::dot(f, f), 2, 1e-14);
    EXPECT_NEAR(f.y, std::cos(25 * std::numbers::pi / 180), 1e-14);
    EXPECT_EQ(axonometric_kind(view), AxonometricKind::kTrimetric);
  }
}

TEST(Oblique, CavalierAndCabinet) {
  const double h = std::numbers::sqrt2 / 2;
  const glm::dmat4 cavalier = picture_from_world(Oblique{kCavalierDepth, 45});
  const glm::dmat4 cabinet = picture_from_world(Oblique{kCabinetDepth, 30});
  expect_near(picture(cavalier, {1, 2, -1}), {1 + h, 2 + h});
  expect_near(picture(cabinet, {1, 2, -4}), {1 + std::numbers::sqrt3, 3});
  EXPECT_EQ(picture(cabinet, {5, 6, 0}), Flat(5, 6));
  EXPECT_NEAR(projector_angle_deg({kCavalierDepth, 45}), 45, 1e-12);
  EXPECT_NEAR(projector_angle_deg({kCabinetDepth, 45}), 63.43494882292201, 1e-12);
  EXPECT_EQ(projector_angle_deg({0, 45}), 90);
}

/// Where the lines a-b and c-d meet.
Flat meet(const Flat& a, const Flat& b, const Flat& c, const Flat& d) {
  const Flat u = b - a, v = d - c, w = c - a;
  return a + u * ((w.x * v.y - w.y * v.x) / (u.x * v.y - u.y * v.x));
}

int count(const std::array<std::optional<Flat>, 3>& points) {
  int n = 0;
  for (const auto& p : points) n += p.has_value();
  return n;
}

// A vanishing point is where the pictures of a box's parallel edges meet.
TEST(VanishingPoints, LieWhereParallelEdgesMeet) {
  const PerspectiveView views[] = {{5, 0, 0, {0.5, 1, -3}},  {5, 40, 0, {0, 1, -3}},
                                   {5, 0, 25, {1, 0, -3}},   {5, 40, 25, {0.2, 0.3, -3}},
                                   {2, 90, 0, {1, 0.5, -3}}, {9, -30, -50, {0, 0, -2}}};
  const int counts[] = {1, 2, 2, 3, 1, 3};
  for (int v = 0; v < 6; ++v) {
    const glm::dmat4 m = picture_from_world(views[v]);
    const auto points = principal_vanishing_points(m);
    EXPECT_EQ(count(points), counts[v]) << v;
    for (int axis = 0; axis < 3; ++axis) {
      Vec along(0), aside(0);
      along[axis] = 1;
      aside[(axis + 1) % 3] = aside[(axis + 2) % 3] = 1;
      const Flat a = picture(m, Vec(0)), b = picture(m, along);
      const Flat c = picture(m, aside), d = picture(m, aside + along);
      if (points[static_cast<std::size_t>(axis)]) {
        expect_near(meet(a, b, c, d), *points[static_cast<std::size_t>(axis)], 1e-9);
      } else {
        const Flat u = b - a, w = d - c;
        EXPECT_NEAR(u.x * w.y - u.y * w.x, 0, 1e-12) << v << ' ' << axis;
      }
    }
  }
}

// In closed form: at 45 degrees the two lie an eye's distance to both sides, at eye's height.
TEST(VanishingPoints, ClosedForms) {
  const auto two = principal_vanishing_points(picture_from_world(PerspectiveView{5, 45, 0, {}}));
  expect_near(*two[0], {5, 0});
  EXPECT_FALSE(two[1]);
  expect_near(*two[2], {-5, 0});
  // The three are a triangle whose heights meet below the eye.
  const auto three = principal_vanishing_points(picture_from_world(PerspectiveView{5, 35, 20, {}}));
  for (std::size_t i = 0; i < 3; ++i) {
    const Flat a = *three[i], b = *three[(i + 1) % 3];
    EXPECT_NEAR(glm::dot(a, b), -25, 1e-10);
  }
  EXPECT_FALSE(vanishing_point(glm::dmat4(1), {1, 2, 3}));
}

// By similar triangles from the eye.
TEST(VanishingPoints, ProjectorsPassThroughTheEye) {
  const glm::dmat4 m = picture_from_world(PerspectiveView{4, 0, 0, {}});
  EXPECT_EQ(picture(m, {3, 2, 0}), Flat(3, 2));
  EXPECT_EQ(picture(m, {3, 2, -4}), Flat(1.5, 1));
  EXPECT_EQ(picture(m, {3, 2, 2}), Flat(6, 4));
  EXPECT_LT(apply(m, {0, 0, -9}).z, apply(m, {0, 0, -8}).z);
  EXPECT_THROW(picture_from_world(PerspectiveView{0, 0, 0, {}}), Error);
  EXPECT_THROW(picture_from_world(PerspectiveView{NAN, 0, 0, {}}), Error);
}

TEST(WindowAndViewport, CornersAndTheRenderersOwn) {
  const glm::dmat3 m = viewport_from_window({{10, 5}, {50, 25}}, {{0, 200}, {400, 0}});
  EXPECT_EQ(apply(m, Flat(10, 5)), Flat(0, 200));
  EXPECT_EQ(apply(m, Flat(50, 25)), Flat(400, 0));
  EXPECT_EQ(apply(m, Flat(20, 10)), Flat(100, 150));
  EXPECT_EQ(window_to_viewport_steps({}, {}).size(), 3u);
  const ViewportTransform ours = device_from_ndc({10, 20, 640, 480});
  const glm::dmat3 same = viewport_from_window({{-1, -1}, {1, 1}}, {{10, 500}, {650, 20}});
  for (const Flat& p : {Flat(-1, 1), Flat(0.25, -0.5), Flat(1, 0)}) {
    EXPECT_EQ(apply(same, p), p * Flat(ours.scale) + Flat(ours.offset));
  }
  EXPECT_THROW(viewport_from_window({{1, 0}, {1, 2}}, {}), Error);
  EXPECT_THROW(viewport_from_window({{0, 0}, {NAN, 2}}, {}), Error);
}

TEST(WindowAndViewport, OfTheSameShapeIsTheLargestPart) {
  const Window window{{10, 5}, {50, 25}};  // twice as wide as high
  const Window wide = of_same_shape(window, {{0, 200}, {800, 0}});
  EXPECT_EQ(wide.low, Flat(0, 200));
  EXPECT_EQ(wide.high, Flat(400, 0));
  const Window high = of_same_shape(window, {{0, 200}, {100, 0}});
  EXPECT_EQ(high.high, Flat(100, 150));
}

Camera aside_camera(Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.eye = {3, 4, 7};
  camera.look_at = {1, 0, -2};
  camera.up = {0.2f, 1, 0};
  camera.view_distance = 2;
  camera.window_min = {-1, -0.5f};
  camera.window_max = {3, 1};
  camera.far_plane = 40;
  return camera;
}

// Four steps, one product: x and y as the camera's own matrices have them.
TEST(ViewingSteps, MakeTheCamerasPicture) {
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    const Camera camera = aside_camera(projection);
    const auto steps = viewing_steps(camera);
    ASSERT_EQ(steps.size(), 4u);
    for (const Vec& p : {Vec(1, 0, -2), Vec(-4, 2, -9), Vec(2, -3, 0)}) {
      const Vec got = apply(compose(steps), p);
      const double w = projection == Projection::kPerspective ? -got.z : 1.0;
      const glm::vec4 clip = camera.clip_from_world() * glm::vec4(glm::vec3(p), 1);
      expect_near(Flat(got) / w, Flat(clip.x, clip.y) / static_cast<double>(clip.w), 1e-5);
    }
  }
}

TEST(ViewingSteps, EachDoesItsPart) {
  const Camera camera = aside_camera(Projection::kPerspective);
  const auto steps = viewing_steps(camera);
  EXPECT_EQ(apply(steps[0].matrix, Vec(3, 4, 7)), Vec(0));
  const Vec ahead = apply(steps[1].matrix, apply(steps[0].matrix, Vec(1, 0, -2)));
  expect_near(Flat(ahead), {0, 0}, 1e-5);
  EXPECT_NEAR(ahead.z, -std::sqrt(101.0), 1e-5);
  EXPECT_EQ(apply(steps[2].matrix, Vec(1, 0.25, -2)), Vec(0, 0, -2));
  // The far corner of the volume is the canonical one's.
  const glm::dmat4 last = steps[3].matrix * steps[2].matrix;
  EXPECT_LT(glm::distance(apply(last, Vec(60, 20, -40)), Vec(1, 1, -1)), 1e-14);
}

TEST(ViewingSteps, BadInputIsRefused) {
  Camera camera;
  camera.far_plane = std::numeric_limits<float>::infinity();
  EXPECT_EQ(apply(viewing_steps(camera)[3].matrix, Vec(2, 3, -4)), Vec(2, 3, -4));
  camera.window_max = camera.window_min;
  EXPECT_THROW(viewing_steps(camera), Error);
  camera = {};
  camera.view_distance = 0;
  EXPECT_THROW(viewing_steps(camera), Error);
}

}  // namespace
}  // namespace kinescope
