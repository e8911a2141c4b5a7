#include "engine/transform/transform2d.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "engine/transform/matrix_class.h"
#include "engine/transform/polar.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

using Vec = glm::dvec2;
using std::numbers::sqrt3;

constexpr std::array<Vec, 3> kTriangle = {Vec(10, 20), Vec(10, 10), Vec(20, 10)};

void expect_near(const Vec& got, const Vec& want, double tolerance = 1e-14) {
  EXPECT_NEAR(got.x, want.x, tolerance * (1 + std::abs(want.x)));
  EXPECT_NEAR(got.y, want.y, tolerance * (1 + std::abs(want.y)));
}

void expect_near(const glm::dmat3& got, const glm::dmat3& want, double tolerance = 1e-14) {
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) EXPECT_NEAR(got[c][r], want[c][r], tolerance) << r << ',' << c;
  }
}

/// As written on paper.
glm::dmat3 rows(Vec first, Vec second) {
  return {first.x, second.x, 0, first.y, second.y, 0, 0, 0, 1};
}

TEST(Transform2D, ScalesTheTextbooksTriangle) {
  const glm::dmat3 m = scaling({2, 1.5});
  EXPECT_EQ(apply(m, kTriangle[0]), Vec(20, 30));
  EXPECT_EQ(apply(m, kTriangle[1]), Vec(20, 15));
  EXPECT_EQ(apply(m, kTriangle[2]), Vec(40, 15));
}

TEST(Transform2D, TranslatesTheTextbooksTriangle) {
  const glm::dmat3 m = translation(Vec(5, 10));
  EXPECT_EQ(apply(m, kTriangle[0]), Vec(15, 30));
  EXPECT_EQ(apply(m, kTriangle[1]), Vec(15, 20));
  EXPECT_EQ(apply(m, kTriangle[2]), Vec(25, 20));
}

TEST(Transform2D, TurnsByAQuarterExactlyAboutAPivot) {
  const glm::dmat3 m = rotation_about_deg({-1, 1}, 90);
  EXPECT_EQ(apply(m, Vec(4, 0)), Vec(0, 6));
  EXPECT_EQ(apply(m, Vec(8, 3)), Vec(-3, 10));
  EXPECT_EQ(apply(m, Vec(6, 2)), Vec(-2, 8));
}

TEST(Transform2D, TurnsByThirtyDegrees) {
  const glm::dmat3 m = rotation_deg(30);
  expect_near(apply(m, Vec(2, -4)), {sqrt3 + 2, 1 - 2 * sqrt3});
  // As printed, to two places.
  expect_near(apply(m, kTriangle[0]), {-1.34, 22.32}, 5e-3);
  expect_near(apply(m, kTriangle[1]), {3.66, 13.66}, 5e-3);
  expect_near(apply(m, kTriangle[2]), {12.32, 18.66}, 5e-3);
  expect_near(apply(m, kTriangle[0]), {5 * sqrt3 - 10, 5 + 10 * sqrt3});
  expect_near(apply(m, kTriangle[2]), {10 * sqrt3 - 5, 10 + 5 * sqrt3});
}

TEST(Transform2D, RotationMatricesAsPrinted) {
  EXPECT_EQ(rotation_deg(90), rows({0, -1}, {1, 0}));
  EXPECT_EQ(rotation_deg(180), rows({-1, 0}, {0, -1}));
  EXPECT_EQ(rotation_deg(-90), rows({0, 1}, {-1, 0}));
  EXPECT_EQ(rotation_deg(36000090), rows({0, -1}, {1, 0}));
  expect_near(rotation_deg(60), rows({0.5, -sqrt3 / 2}, {sqrt3 / 2, 0.5}));
  EXPECT_EQ(rotation_deg(60)[0][0], 0.5);
  // Clockwise: [c s; -s c].
  const double c = std::cos(0.3), s = std::sin(0.3);
  expect_near(rotation_deg(-0.3 * 180 / std::numbers::pi), rows({c, s}, {-s, c}));
}

TEST(Transform2D, SineAndCosineAgreeWithTheLibrary) {
  for (int tenth = -7200; tenth <= 7200; ++tenth) {
    const double deg = tenth * 0.1, rad = deg * std::numbers::pi / 180;
    const auto [s, c] = sine_cosine_deg(deg);
    ASSERT_NEAR(s, std::sin(rad), 4e-15) << deg;
    ASSERT_NEAR(c, std::cos(rad), 4e-15) << deg;
  }
}

TEST(Transform2D, RotationsAddAndTranslationsAdd) {
  for (double a = -200; a < 200; a += 37) {
    for (double b = -100; b < 300; b += 41) {
      expect_near(rotation_deg(a) * rotation_deg(b), rotation_deg(a + b));
    }
  }
  EXPECT_EQ(translation(Vec(3, -4)) * translation(Vec(0.5, 7)), translation(Vec(3.5, 3)));
}

// y = m x + c turned by +90 degrees is y = -x/m - c/m: its slope is -1/m.
TEST(Transform2D, ALineTurnedByAQuarter) {
  for (const Vec& line : {Vec(2, 3), Vec(-0.5, 1), Vec(4, -8)}) {
    const double m = line.x, c = line.y;
    for (const double x : {-3.0, 0.0, 2.0, 16.0}) {
      const Vec p = apply(rotation_deg(90), Vec(x, m * x + c));
      EXPECT_EQ(p.y, -p.x / m - c / m);
    }
  }
}

TEST(Transform2D, ReflectionsAsPrinted) {
  EXPECT_EQ(reflection_in_diagonal(), rows({0, 1}, {1, 0}));
  EXPECT_EQ(reflection_in_y_axis(), rows({-1, 0}, {0, 1}));
  EXPECT_EQ(reflection_in_x_axis(), rows({1, 0}, {0, -1}));
  EXPECT_EQ(reflection_in_origin(), rows({-1, 0}, {0, -1}));
  EXPECT_EQ(reflection_in_line(1, 0), reflection_in_diagonal());
  const double m = 2, c = 3, x = 5, y = -7;
  const Vec p = apply(reflection_in_line(m, c), Vec(x, y));
  expect_near(p, {((1 - m * m) * x + 2 * m * (y - c)) / (1 + m * m),
                  (2 * m * x + (m * m - 1) * y + 2 * c) / (1 + m * m)});
}

// By definition: the line halves the way from a point to its image, at right angles.
TEST(Transform2D, ReflectionInAnyLineByDefinition) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> u(-10, 10);
  for (int i = 0; i < 200; ++i) {
    const Vec through(u(random), u(random)), d(u(random), u(random)), p(u(random), u(random));
    const glm::dmat3 m = reflection_in_line(through, d);
    const Vec q = apply(m, p), middle = (p + q) * 0.5 - through;
    EXPECT_NEAR((q.x - p.x) * d.x + (q.y - p.y) * d.y, 0, 1e-11);
    EXPECT_NEAR(middle.x * d.y - middle.y * d.x, 0, 1e-11);
    expect_near(apply(m, q), p, 1e-12);
    if (std::abs(d.x) < 0.1) continue;
    const double slope = d.y / d.x, intercept = through.y - slope * through.x;
    expect_near(apply(reflection_in_line(slope, intercept), p), q, 1e-9);
  }
  EXPECT_EQ(apply(reflection_in_line(Vec(3, 0), Vec(0, -2)), Vec(5, 1)), Vec(1, 1));  // vertical
}

TEST(Transform2D, StepsMultiplyToTheWhole) {
  expect_near(compose(rotation_about_steps({-1, 1}, 37)), rotation_about_deg({-1, 1}, 37));
  expect_near(compose(scaling_about_steps({4, 2}, {3, -2})), scaling_about({4, 2}, {3, -2}));
  expect_near(compose(reflection_in_line_steps(-0.75, 2)), reflection_in_line(-0.75, 2));
  expect_near(compose(about_steps({4, 2}, "scale", scaling(Vec(3, -2)))),
              scaling_about({4, 2}, {3, -2}));
  EXPECT_EQ(rotation_about_steps({0, 0}, 1).size(), 3u);
}

TEST(Transform2D, FixedPointsStay) {
  EXPECT_EQ(apply(scaling_about({4, 2}, {3, -2}), Vec(4, 2)), Vec(4, 2));
  EXPECT_EQ(apply(scaling_about({4, 2}, {3, -2}), Vec(5, 3)), Vec(7, 0));
}

TEST(Transform2D, ShearOfTheUnitSquare) {
  EXPECT_EQ(apply(shear(2, 0), Vec(1, 1)), Vec(3, 1));
  EXPECT_EQ(apply(shear(0, 3), Vec(1, 1)), Vec(1, 4));
  EXPECT_EQ(apply(shear(2, 3), Vec(1, 0)), Vec(1, 3));
  EXPECT_EQ(apply(shear(2, 3), Vec(0, 1)), Vec(2, 1));
}

TEST(Transform2D, CoordinatesMoveTheOtherWay) {
  // Axes turned by 90 degrees: a point on the old y axis lies on the new x axis.
  const glm::dmat3 axes = coordinate_from_geometric(rotation_deg(90));
  expect_near(apply(axes, Vec(0, 5)), {5, 0});
  expect_near(axes, rotation_deg(-90));
  expect_near(coordinate_from_geometric(translation(Vec(3, 4))), translation(Vec(-3, -4)));
  expect_near(coordinate_from_geometric(scaling({2, 4})), scaling({0.5, 0.25}));
}

TEST(Transform2D, BadInputIsRefused) {
  EXPECT_THROW(reflection_in_line(Vec(1, 1), Vec(0, 0)), Error);
  EXPECT_THROW(reflection_in_line(Vec(1, 1), Vec(NAN, 1)), Error);
  EXPECT_THROW(coordinate_from_geometric(scaling({1, 0})), Error);
  EXPECT_THROW(coordinate_from_geometric(scaling(NAN)), Error);
}

TEST(TransformClass, TellsEachClassOfThePlane) {
  using enum TransformClass;
  EXPECT_EQ(transform_class(glm::dmat3(1)), kIdentity);
  EXPECT_EQ(transform_class(glm::dmat3(3)), kIdentity);  // w = 3: the same points
  EXPECT_EQ(transform_class(translation(Vec(1e-3, 0))), kTranslation);
  EXPECT_EQ(transform_class(rotation_about_deg({3, 1}, 30)), kRigid);
  EXPECT_EQ(transform_class(reflection_in_line(2, 1)), kIsometry);
  EXPECT_EQ(transform_class(scaling(2.0) * rotation_deg(10)), kConformal);
  EXPECT_EQ(transform_class(scaling(-2.0)), kConformal);
  EXPECT_EQ(transform_class(reflection_in_origin()), kRigid);  // a half turn
  EXPECT_EQ(transform_class(scaling({2, 1})), kAffine);
  EXPECT_EQ(transform_class(shear(1e-6, 0)), kAffine);
  EXPECT_EQ(transform_class(shear(1, 1)), kSingular);
  EXPECT_EQ(transform_class(glm::dmat3(0)), kSingular);
  EXPECT_EQ(transform_class(glm::dmat3(1, 0, 0.5, 0, 1, 0, 0, 0, 1)), kProjective);
  EXPECT_EQ(transform_class(glm::dmat3(1, 0, 1, 0, 1, 0, 1, 0, 1)), kSingular);
  EXPECT_EQ(transform_class(scaling(NAN)), kNotFinite);
  EXPECT_EQ(transform_class(scaling(1e200)), kConformal);
  EXPECT_EQ(transform_class(scaling(1e-200)), kConformal);
}

TEST(TransformClass, Nests) {
  EXPECT_TRUE(is_rigid(TransformClass::kTranslation));
  EXPECT_FALSE(is_rigid(TransformClass::kIsometry));
  EXPECT_TRUE(is_conformal(TransformClass::kIsometry));
  EXPECT_FALSE(is_conformal(TransformClass::kAffine));
  EXPECT_TRUE(is_affine(TransformClass::kConformal));
  EXPECT_FALSE(is_affine(TransformClass::kProjective));
}

TEST(TransformClass, HasNames) {
  EXPECT_STREQ(class_name(TransformClass::kIdentity), "identity");
  EXPECT_STREQ(class_name(TransformClass::kConformal), "conformal");
  EXPECT_STREQ(class_name(TransformClass::kNotFinite), "not finite");
}

TEST(Polar, GoesThereAndBack) {
  for (double x = -3; x <= 3; x += 0.75) {
    for (double y = -3; y <= 3; y += 0.75) {
      expect_near(cartesian_from_polar(polar_from_cartesian({x, y})), {x, y}, 1e-15);
      for (const double z : {-2.0, 0.0, 5.0}) {
        const glm::dvec3 p(x, y, z);
        const glm::dvec3 a = cartesian_from_spherical(spherical_from_cartesian(p));
        const glm::dvec3 b = cartesian_from_cylindrical(cylindrical_from_cartesian(p));
        for (int i = 0; i < 3; ++i) {
          EXPECT_NEAR(a[i], p[i], 4e-15);
          EXPECT_NEAR(b[i], p[i], 4e-15);
        }
      }
    }
  }
  EXPECT_EQ(polar_from_cartesian({0, 2}).angle_rad, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(polar_from_cartesian({3e200, 4e200}).radius, 5e200);
}

TEST(Polar, GridsHaveTheirLines) {
  int lines = 0;
  cartesian_grid(2.0, 0.5, [&](const Vec& a, const Vec& b) {
    ++lines;
    EXPECT_TRUE((a.x == b.x && a.y == -2 && b.y == 2) || (a.y == b.y && a.x == -2 && b.x == 2));
  });
  EXPECT_EQ(lines, 18);
  double length = 0;
  polar_grid(2.0, 1.0, 12, 360,
             [&](const Vec& a, const Vec& b) { length += std::hypot(b.x - a.x, b.y - a.y); });
  EXPECT_NEAR(length, 2 * std::numbers::pi * 3 + 12 * 2, 1e-3);
  for (const double step : {0.0, -1.0, static_cast<double>(NAN)}) {
    int bounded = 0;
    cartesian_grid(1.0, step, [&](const Vec&, const Vec&) { ++bounded; });
    EXPECT_LE(bounded, 40002);
  }
}

}  // namespace
}  // namespace kinescope
