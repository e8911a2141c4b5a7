#include "display/tube/deflection.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kinescope {
namespace {

DeflectionSettings crooked() {
  DeflectionSettings d;
  d.width = 1.05;
  d.height = 0.95;
  d.shift_x = 0.03;
  d.shift_y = -0.02;
  d.pincushion_x = 0.04;
  d.pincushion_y = 0.03;
  d.keystone = 0.05;
  d.rotation_deg = 2;
  d.s_curve = 0.08;
  d.convergence[2] = {0.3, -0.2, 0.4, 0.5};
  return d;
}

TEST(Deflection, SweepIsFoundAgainFromEveryPlaceOnTheGlass) {
  for (const int gun : {0, 2}) {
    const Deflection deflection(crooked(), GlassSettings{}, gun);
    for (double y = -1; y <= 1; y += 0.125) {
      for (double x = -1; x <= 1; x += 0.125) {
        const Place back = deflection.sweep_of_glass(deflection.glass_of_sweep({x, y}));
        ASSERT_NEAR(back.x, x, 1e-8);
        ASSERT_NEAR(back.y, y, 1e-8);
      }
    }
  }
}

TEST(Deflection, EachFaultMovesWhatItsNameSays) {
  const GlassSettings glass;
  const auto landing = [&](const DeflectionSettings& d, Place sweep, int gun = 1) {
    return Deflection(d, glass, gun).glass_of_sweep(sweep);
  };
  DeflectionSettings d;
  d.pincushion_x = 0.1;  // edges' middles pull in, corners stay
  EXPECT_NEAR(landing(d, {1, 0}).x, 0.9, 1e-12);
  EXPECT_NEAR(landing(d, {1, 1}).x, 1, 1e-12);
  d = {};
  d.keystone = 0.1;
  EXPECT_NEAR(landing(d, {1, 1}).x, 1.1, 1e-12);
  EXPECT_NEAR(landing(d, {1, -1}).x, 0.9, 1e-12);
  d = {};
  d.rotation_deg = 90;  // clockwise: right goes down, by as many millimetres
  EXPECT_NEAR(landing(d, {1, 0}).x, 0, 1e-12);
  EXPECT_NEAR(landing(d, {1, 0}).y, glass.aspect, 1e-12);
  d = {};
  d.s_curve = 0.2;
  EXPECT_NEAR(landing(d, {1, 0}).x, 1, 1e-12);
  EXPECT_GT(landing(d, {0.5, 0}).x, 0.5);
  d = {};
  d.convergence[0].x_mm = 2;
  const double half_width_mm = 0.5 * glass.diagonal_mm * 0.8;  // 4:3
  EXPECT_NEAR(landing(d, {0, 0}, 0).x, 2 / half_width_mm, 1e-12);
  EXPECT_EQ(landing(d, {0, 0}, 1).x, 0);
}

TEST(GlassCamera, FlatGlassIsSeenAsItIs) {
  const Place p = GlassCamera(GlassSettings{}).glass_of_picture({0.3, -0.8});
  EXPECT_EQ(p.x, 0.3);
  EXPECT_EQ(p.y, -0.8);
}

TEST(GlassCamera, CurvedGlassFillsThePicturesWidthAndPullsItsCornersIn) {
  GlassSettings glass;
  glass.curvature_mm = 500;
  const GlassCamera camera(glass);
  EXPECT_NEAR(camera.glass_of_picture({1, 0}).x, 1, 1e-9);
  EXPECT_NEAR(camera.glass_of_picture({-1, 0}).x, -1, 1e-9);
  EXPECT_NEAR(camera.glass_of_picture({0, 0}).x, 0, 1e-9);
  // The picture's corner shows what lies beyond the glass's.
  EXPECT_GT(camera.glass_of_picture({1, 1}).x, 1.005);
  // A ray through a known place of the sphere: 100 mm along it to the right.
  const double angle = 100.0 / 500;
  const double slope = 500 * std::sin(angle) / (glass.distance_mm + 500 * (1 - std::cos(angle)));
  const double half_width_mm = 0.5 * glass.diagonal_mm * 0.8, edge = half_width_mm / 500;
  const double edge_slope = 500 * std::sin(edge) / (glass.distance_mm + 500 * (1 - std::cos(edge)));
  EXPECT_NEAR(camera.glass_of_picture({slope / edge_slope, 0}).x, 100 / half_width_mm, 1e-9);
}

TEST(GlassCamera, FindsWhereInThePictureAPlaceOnTheGlassIs) {
  for (const double radius_mm : {0.0, 400.0, 1000.0}) {
    GlassSettings glass;
    glass.curvature_mm = radius_mm;
    const GlassCamera camera(glass);
    for (const Place place : {Place{0, 0}, {0.7, 0}, {-0.3, 0.9}, {1, -1}}) {
      const Place back = camera.picture_of_glass(camera.glass_of_picture(place));
      EXPECT_NEAR(back.x, place.x, 1e-9);
      EXPECT_NEAR(back.y, place.y, 1e-9);
    }
  }
}

TEST(GlassCamera, RaysBesideTheTubeLandFarFromThePicture) {
  GlassSettings glass;
  glass.curvature_mm = 150;
  EXPECT_GT(std::abs(GlassCamera(glass).glass_of_picture({3, 3}).x), 2);
}

}  // namespace
}  // namespace kinescope
