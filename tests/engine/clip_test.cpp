#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "engine/clip_homogeneous.h"
#include "engine/clip_line_homogeneous.h"

namespace kinescope {
namespace {

using Vec = glm::dvec4;

/// A triangle whose attributes are its barycentric coordinates.
std::array<ClipVertex, 3> triangle(Vec a, Vec b, Vec c) {
  std::array<ClipVertex, 3> t;
  t[0].position = a;
  t[1].position = b;
  t[2].position = c;
  for (std::size_t i = 0; i < 3; ++i) {
    t[i].attributes[i] = 1.0f;
    t[i].corner = static_cast<int>(i);
  }
  return t;
}

/// How far a point lies inside the view volume; negative outside.
double depth_in_volume(Vec p) {
  return std::min({p.x + p.w, p.w - p.x, p.y + p.w, p.w - p.y, p.z, p.w - p.z});
}

/// Distance of (u, v) inside a counter-clockwise polygon of the first two attributes.
double depth_in_polygon(std::span<const ClipVertex> polygon, double u, double v) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i].attributes;
    const auto& b = polygon[(i + 1) % polygon.size()].attributes;
    const double du = b[0] - a[0], dv = b[1] - a[1];
    const double length = std::hypot(du, dv);
    if (length < 1e-7) continue;
    depth = std::min(depth, (du * (v - a[1]) - dv * (u - a[0])) / length);
  }
  return polygon.size() < 3 ? -depth : depth;
}

/// Twice the polygon's area in its first two attributes.
double area(std::span<const ClipVertex> polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i].attributes;
    const auto& b = polygon[(i + 1) % polygon.size()].attributes;
    sum += double{a[0]} * b[1] - double{a[1]} * b[0];
  }
  return sum;
}

class RandomPoints {
 public:
  Vec clip_point() { return {number_(random_), number_(random_), number_(random_), w_(random_)}; }
  double unit() { return unit_(random_); }

 private:
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> number_{-2, 2}, w_{-1, 2}, unit_{0, 1};
};

// A point of the triangle lies in the volume exactly if it lies in the clipped polygon.
TEST(ClipHomogeneous, AgreesWithPointsInTheVolume) {
  RandomPoints random;
  const auto planes = view_volume_planes();
  PolygonClipper clipper;
  int inside = 0, outside = 0;
  for (int round = 0; round < 3000; ++round) {
    const Vec a = random.clip_point(), b = random.clip_point(), c = random.clip_point();
    const auto polygon = clipper.clip(triangle(a, b, c), planes, 3);
    EXPECT_LE(polygon.size(), 9u);
    for (int i = 0; i < 20; ++i) {
      double u = random.unit(), v = random.unit();
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const double in_volume = depth_in_volume(u * a + v * b + (1 - u - v) * c);
      if (std::abs(in_volume) < 1e-5) continue;
      const bool in_polygon = !polygon.empty() && depth_in_polygon(polygon, u, v) > -1e-5;
      const bool off_polygon = polygon.empty() || depth_in_polygon(polygon, u, v) < 1e-5;
      if (in_volume > 0) {
        EXPECT_TRUE(in_polygon);
        ++inside;
      } else {
        EXPECT_TRUE(off_polygon);
        ++outside;
      }
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

TEST(ClipHomogeneous, CornersLieInTheVolumeAndCarryTheirAttributes) {
  RandomPoints random;
  const auto planes = view_volume_planes();
  PolygonClipper clipper;
  for (int round = 0; round < 2000; ++round) {
    const Vec a = random.clip_point(), b = random.clip_point(), c = random.clip_point();
    for (const ClipVertex& v : clipper.clip(triangle(a, b, c), planes, 3)) {
      EXPECT_GT(depth_in_volume(v.position), -1e-12);
      const auto& t = v.attributes;
      const Vec want = double{t[0]} * a + double{t[1]} * b + double{t[2]} * c;
      EXPECT_LT(glm::distance(want, v.position), 1e-6);
      if (v.corner >= 0) {
        EXPECT_EQ(t[static_cast<std::size_t>(v.corner)], 1.0f);
      }
    }
  }
}

TEST(ClipHomogeneous, TheTwoSidesOfAPlaneMakeUpTheTriangle) {
  RandomPoints random;
  PolygonClipper clipper;
  for (int round = 0; round < 1000; ++round) {
    const auto t = triangle(random.clip_point(), random.clip_point(), random.clip_point());
    const ClipPlane plane{random.clip_point(), random.unit() - 0.5};
    const ClipPlane other{-plane.normal, -plane.least};
    double sum = area(clipper.clip(t, {&plane, 1}, 3));
    sum += area(clipper.clip(t, {&other, 1}, 3));
    EXPECT_NEAR(sum, 1.0, 1e-5);
  }
}

TEST(ClipHomogeneous, LeavesWhatIsInsideAlone) {
  const auto t = triangle({-1, -1, 0, 1}, {1, -1, 1, 1}, {0, 1, 0.5, 1});  // corners on the planes
  PolygonClipper clipper;
  const auto polygon = clipper.clip(t, view_volume_planes(), 3);
  ASSERT_EQ(polygon.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(polygon[i].position, t[i].position);
    EXPECT_EQ(polygon[i].corner, static_cast<int>(i));
  }
}

TEST(ClipHomogeneous, OneCornerCutOffMakesAQuadrilateral) {
  const auto t = triangle({0, 0, 0.5, 1}, {3, 0, 0.5, 1}, {0, 1, 0.5, 1});
  PolygonClipper clipper;
  const auto polygon = clipper.clip(t, view_volume_planes(), 3);
  ASSERT_EQ(polygon.size(), 4u);
  EXPECT_EQ(polygon[1].position, Vec(1, 0, 0.5, 1));
  EXPECT_FLOAT_EQ(polygon[1].attributes[1], 1.0f / 3);
  EXPECT_EQ(polygon[1].corner, -1);
}

TEST(ClipHomogeneous, NothingLeftBehindTheEye) {
  PolygonClipper clipper;
  const auto planes = view_volume_planes();
  EXPECT_TRUE(
      clipper.clip(triangle({0, 0, -1, -1}, {1, 0, -1, -2}, {0, 1, -1, -1}), planes, 3).empty());
  EXPECT_TRUE(
      clipper.clip(triangle({0, 0, 1, -1}, {1, 0, 5, -2}, {0, 1, 2, -1}), planes, 3).empty());
  EXPECT_TRUE(clipper.clip(triangle({5, 0, 0, 1}, {6, 0, 0, 1}, {7, 1, 0, 1}), planes, 3).empty());
}

TEST(ClipHomogeneous, NothingOfWhatIsNotFinite) {
  PolygonClipper clipper;
  const auto planes = view_volume_planes();
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (int i = 0; i < 4; ++i) {
      Vec corner(0, 0, 0.5, 1);
      corner[i] = bad;
      EXPECT_TRUE(
          clipper.clip(triangle({0, 0, 0.5, 1}, {1, 0, 0.5, 1}, corner), planes, 3).empty());
    }
  }
  EXPECT_TRUE(clipper.clip({}, planes, 3).empty());
}

TEST(ClipHomogeneous, ExactDownToAMillionthInFrontOfTheEye) {
  // From a metre before the eye to a thousand kilometres behind it; near plane at w = 1e-6, where
  // z = w - 1e-6 (an infinite far plane).
  const auto at = [](double x, double w) { return Vec(x, 0, w - 1e-6, w); };
  const ClipPlane near{{0, 0, 1, 0}, 0.0};
  PolygonClipper clipper;
  const auto polygon = clipper.clip(triangle(at(0.25, 1), at(0.5, 1), at(3, -1e6)), {&near, 1}, 3);
  ASSERT_EQ(polygon.size(), 4u);
  for (const ClipVertex& v : polygon) {
    if (v.corner >= 0) continue;
    EXPECT_NEAR(v.position.w, 1e-6, 1e-9);
    EXPECT_NEAR(v.position.z, 0.0, 1e-9);
  }
}

TEST(ClipHomogeneous, NeighboursMeetInTheSamePoints) {
  RandomPoints random;
  const auto planes = view_volume_planes();
  PolygonClipper one, two;
  for (int round = 0; round < 2000; ++round) {
    const Vec a = random.clip_point(), b = random.clip_point();
    const auto left = one.clip(triangle(a, b, random.clip_point()), planes, 0);
    const auto right = two.clip(triangle(b, a, random.clip_point()), planes, 0);
    // Corners of the left polygon on the edge a-b are corners of the right one, bit for bit.
    const auto on_edge = [&](const Vec& p) {
      const Vec along = b - a;
      const double t = glm::dot(p - a, along) / glm::dot(along, along);
      return glm::distance(a + t * along, p) < 1e-13;
    };
    for (const ClipVertex& v : left) {
      if (!on_edge(v.position)) continue;
      EXPECT_TRUE(std::any_of(right.begin(), right.end(),
                              [&](const ClipVertex& w) { return w.position == v.position; }));
    }
  }
}

TEST(ClipLine, AgreesWithPointsInTheVolume) {
  RandomPoints random;
  const auto planes = view_volume_planes();
  int cut = 0;
  for (int round = 0; round < 5000; ++round) {
    const Vec from = random.clip_point(), to = random.clip_point();
    Vec a = from, b = to;
    const bool left = clip_line(planes, a, b);
    cut += left && (a != from || b != to);
    for (int i = 0; i <= 20; ++i) {
      const double t = i / 20.0;
      const Vec p = from + t * (to - from);
      const double depth = depth_in_volume(p);
      if (std::abs(depth) < 1e-9) continue;
      const Vec along = to - from;
      const double enter = glm::dot(a - from, along) / glm::dot(along, along);
      const double leave = glm::dot(b - from, along) / glm::dot(along, along);
      EXPECT_EQ(depth > 0, left && t > enter - 1e-12 && t < leave + 1e-12);
    }
  }
  EXPECT_GT(cut, 500);
}

TEST(ClipLine, KeepsEndsThatAreInside) {
  const auto planes = view_volume_planes();
  Vec a(-1, 1, 0, 1), b(0.5, 0, 1, 1);
  EXPECT_TRUE(clip_line(planes, a, b));
  EXPECT_EQ(a, Vec(-1, 1, 0, 1));
  EXPECT_EQ(b, Vec(0.5, 0, 1, 1));
  Vec c(std::nan(""), 0, 0, 1);
  EXPECT_FALSE(clip_line(planes, c, b));
}

}  // namespace
}  // namespace kinescope
