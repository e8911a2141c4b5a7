#include "engine/transform/transform3d.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <random>

#include "engine/transform/in_between.h"
#include "engine/transform/matrix_class.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

using Vec = glm::dvec3;
using std::numbers::sqrt2;
using std::numbers::sqrt3;

void expect_near(const Vec& got, const Vec& want, double tolerance = 1e-14) {
  EXPECT_LE(glm::distance(got, want), tolerance * (1 + glm::length(want)))
      << got.x << ' ' << got.y << ' ' << got.z << " is not " << want.x << ' ' << want.y << ' '
      << want.z;
}

void expect_near(const glm::dmat4& got, const glm::dmat4& want, double tolerance = 1e-14) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(got[c][r], want[c][r], tolerance) << r << ',' << c;
  }
}

/// As written on paper.
glm::dmat4 rows(glm::dvec4 a, glm::dvec4 b, glm::dvec4 c) {
  return glm::transpose(glm::dmat4(a, b, c, glm::dvec4(0, 0, 0, 1)));
}

struct Draw {
  std::mt19937_64 random{7};
  double number() { return std::uniform_real_distribution<double>(-5, 5)(random); }
  Vec vector() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
};

TEST(Transform3D, AQuarterAboutYMapsZToXAndXToMinusZ) {
  EXPECT_EQ(apply(rotation_y_deg(90), Vec(0, 0, 1)), Vec(1, 0, 0));
  EXPECT_EQ(apply(rotation_y_deg(90), Vec(1, 0, 0)), Vec(0, 0, -1));
  EXPECT_EQ(apply(rotation_x_deg(90), Vec(0, 1, 0)), Vec(0, 0, 1));
  EXPECT_EQ(apply(rotation_z_deg(90), Vec(1, 0, 0)), Vec(0, 1, 0));
}

TEST(Transform3D, ShearAsPrinted) {
  ShearFactors f;
  f.a = f.c = 2;
  f.b = f.d = 3;
  f.e = f.f = 1;
  EXPECT_EQ(shear(f), rows({1, 2, 3, 0}, {2, 1, 3, 0}, {1, 1, 1, 0}));
}

TEST(Transform3D, MatricesAsPrinted) {
  const double h = sqrt2 / 2;
  expect_near(rotation_z_deg(45), rows({h, -h, 0, 0}, {h, h, 0, 0}, {0, 0, 1, 0}));
  expect_near(rotation_x_deg(30),
              rows({1, 0, 0, 0}, {0, sqrt3 / 2, -0.5, 0}, {0, 0.5, sqrt3 / 2, 0}));
  EXPECT_EQ(translation(Vec(4, 3, 2)), rows({1, 0, 0, 4}, {0, 1, 0, 3}, {0, 0, 1, 2}));
  EXPECT_EQ(scaling({2, 3, 1}), rows({2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 1, 0}));
}

TEST(Transform3D, RotationAboutAnAxisByDefinition) {
  Draw draw;
  for (int i = 0; i < 200; ++i) {
    const Axis axis{draw.vector(), draw.vector()};
    const double deg = draw.number() * 72, rad = deg * std::numbers::pi / 180;
    const Vec u = glm::normalize(axis.direction), p = draw.vector();
    const Vec q = apply(rotation_about_deg(axis, deg), p);
    // Height along the axis and distance from it stay; the angle about it is the given one.
    const Vec a = p - axis.through, b = q - axis.through;
    EXPECT_NEAR(glm::dot(a, u), glm::dot(b, u), 1e-12);
    const Vec a2 = a - u * glm::dot(a, u), b2 = b - u * glm::dot(b, u);
    EXPECT_NEAR(glm::dot(a2, b2), glm::dot(a2, a2) * std::cos(rad), 1e-11);
    EXPECT_NEAR(glm::dot(glm::cross(a2, b2), u), glm::dot(a2, a2) * std::sin(rad), 1e-11);
  }
}

TEST(Transform3D, SevenStepsMakeTheRotation) {
  Draw draw;
  for (int i = 0; i < 100; ++i) {
    const Axis axis{draw.vector(), draw.vector()};
    const auto steps = rotation_about_steps(axis, 10.0 * i);
    EXPECT_EQ(steps.size(), 7u);
    expect_near(compose(steps), rotation_about_deg(axis, 10.0 * i), 1e-12);
  }
  for (const Vec& along : {Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, -1), Vec(-1, 0, 0)}) {
    expect_near(compose(rotation_about_steps({Vec(1, 2, 3), along}, 40)),
                rotation_about_deg({Vec(1, 2, 3), along}, 40), 1e-14);
  }
  EXPECT_EQ(rotation_about_deg({Vec(0), Vec(0, 0, 1)}, 90), rotation_z_deg(90));
  EXPECT_EQ(rotation_about_deg({Vec(0), Vec(0, 5, 0)}, 90), rotation_y_deg(90));
}

TEST(Transform3D, ReflectionInAPlaneByDefinition) {
  Draw draw;
  for (int i = 0; i < 200; ++i) {
    const Plane plane = plane_by_normal(draw.vector(), draw.vector());
    const Vec p = draw.vector(), q = apply(reflection_in_plane(plane), p);
    EXPECT_NEAR(plane.distance_to(p), -plane.distance_to(q), 1e-12);
    EXPECT_LE(glm::length(glm::cross(q - p, plane.unit_normal)), 1e-11);
    expect_near(compose(reflection_in_plane_steps(plane)), reflection_in_plane(plane), 1e-12);
  }
  EXPECT_EQ(reflection_in_plane({}), scaling({1, 1, -1}));
}

TEST(Transform3D, ReflectionAboutAnAxisIsAHalfTurn) {
  Draw draw;
  for (int i = 0; i < 50; ++i) {
    const Axis axis{draw.vector(), draw.vector()};
    expect_near(reflection_about_axis(axis), rotation_about_deg(axis, 180), 1e-13);
  }
  EXPECT_EQ(apply(reflection_about_axis({Vec(0), Vec(0, 0, 2)}), Vec(1, 2, 3)), Vec(-1, -2, 3));
}

TEST(Transform3D, ScalesAboutAPointAndInverts) {
  EXPECT_EQ(apply(scaling_about({1, 2, 3}, {2, 3, 4}), Vec(2, 3, 4)), Vec(3, 5, 7));
  const glm::dmat4 m = translation(Vec(1, 2, 3)) * rotation_x_deg(20) * scaling({1, 2, 3});
  expect_near(coordinate_from_geometric(m) * m, glm::dmat4(1));
  EXPECT_THROW(coordinate_from_geometric(scaling({1, 1, 0})), Error);
}

TEST(TransformClass, TellsEachClassOfSpace) {
  using enum TransformClass;
  EXPECT_EQ(transform_class(glm::dmat4(1)), kIdentity);
  EXPECT_EQ(transform_class(translation(Vec(0, 1, 0))), kTranslation);
  EXPECT_EQ(transform_class(rotation_about_deg({Vec(1), Vec(1, 2, 3)}, 20)), kRigid);
  EXPECT_EQ(transform_class(reflection_in_plane({})), kIsometry);
  EXPECT_EQ(transform_class(scaling(Vec(3))), kConformal);
  EXPECT_EQ(transform_class(shear({1, 0, 0, 0, 0, 0})), kAffine);
  glm::dmat4 perspective(1);
  perspective[2][3] = -0.2;
  EXPECT_EQ(transform_class(perspective), kProjective);
  EXPECT_EQ(transform_class(scaling({1, 1, 0})), kSingular);
}

TEST(Plane, ThroughThreePoints) {
  const Plane p = plane_by_points({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  expect_near(p.unit_normal, Vec(1 / sqrt3));
  EXPECT_NEAR(p.from_origin, 1 / sqrt3, 1e-15);
  EXPECT_NEAR(p.distance_to({1, 1, 1}), 2 / sqrt3, 1e-15);
  EXPECT_LT(plane_by_points({0, 1, 0}, {1, 0, 0}, {0, 0, 1}).unit_normal.x, 0);
}

TEST(Plane, BadInputIsRefused) {
  EXPECT_THROW(plane_by_points({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), Error);
  EXPECT_THROW(plane_by_points({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}), Error);
  EXPECT_THROW(plane_by_points({0, 0, 0}, {0, 0, 0}, {1, 0, 0}), Error);
  EXPECT_THROW(plane_by_points({NAN, 0, 0}, {0, 1, 0}, {1, 0, 0}), Error);
  EXPECT_THROW(plane_by_normal({0, 0, 0}, {0, 0, 0}), Error);
  EXPECT_THROW(plane_by_normal({INFINITY, 0, 0}, {1, 0, 0}), Error);
  EXPECT_THROW(rotation_about_deg({Vec(0), Vec(0)}, 1), Error);
  EXPECT_THROW(mapped_normal(scaling({1, 0, 1}), {0, 0, 1}), Error);
}

// The image's normal by three mapped points, against the map of the normal.
TEST(Plane, NormalsUnderAffineMaps) {
  Draw draw;
  for (int i = 0; i < 200; ++i) {
    glm::dmat4 m(1);
    for (int c = 0; c < 4; ++c) m[c] = glm::dvec4(draw.vector(), c == 3 ? 1 : 0);
    const Vec a = draw.vector(), b = draw.vector(), c = draw.vector();
    const Plane image = mapped_plane(m, plane_by_points(a, b, c));
    const double turned = glm::determinant(glm::dmat3(m)) < 0 ? -1 : 1;
    const Plane want = plane_by_points(apply(m, a), apply(m, b), apply(m, c));
    expect_near(image.unit_normal, want.unit_normal * turned, 1e-9);
    EXPECT_NEAR(image.from_origin, want.from_origin * turned, 1e-8);
  }
  // The trap: scaled by (1, 2, 1), the normal of x + y = 1 is not (1, 2, 0).
  expect_near(mapped_normal(scaling({1, 2, 1}), {1, 1, 0}), glm::normalize(Vec(2, 1, 0)));
}

TEST(InBetween, TurnsEvenlyAndEndsExactly) {
  Draw draw;
  for (int i = 0; i < 50; ++i) {
    const Axis axis{{0, 0, 0}, {draw.number(), draw.number(), draw.number()}};
    const double angle = 36 * draw.number(), share = std::abs(draw.number()) / 5;
    const glm::dmat4 whole = rotation_about_deg(axis, angle);
    expect_near(in_between(whole, share), rotation_about_deg(axis, share * angle), 1e-12);
    EXPECT_EQ(in_between(whole, 0), glm::dmat4(1.0));
    EXPECT_EQ(in_between(whole, 1), whole);
  }
  const glm::dmat4 half = in_between(rotation_y_deg(180), 0.5);
  expect_near(half, rotation_y_deg(half[2][0] > 0 ? 90 : -90), 1e-12);
}

TEST(InBetween, BlendsWhatIsNoRotation) {
  expect_near(in_between(translation({2, 4, -6}), 0.25), translation({0.5, 1, -1.5}));
  expect_near(in_between(scaling({1, 1, -1}), 0.5), scaling({1, 1, 0}));
  ShearFactors factors;
  factors.b = 3;
  const glm::dmat4 whole = shear(factors);
  factors.b = 1;
  expect_near(in_between(whole, 1.0 / 3), shear(factors));
  // The origin of a rotation about an axis elsewhere goes straight.
  const glm::dmat4 about = rotation_about_deg({{1, 0, 0}, {0, 0, 1}}, 90);
  expect_near(Vec(in_between(about, 0.5)[3]), 0.5 * Vec(about[3]));
}

}  // namespace
}  // namespace kinescope
