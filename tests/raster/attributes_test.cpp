// Attributes, their gradients and depth across a triangle, against planes in space.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/raster/float_canvas.h"
#include "tests/raster/triangle_soup.h"

namespace kinescope {
namespace {

void show_attributes(const Batch& b, LinearRgba* out) {
  for (int i = 0; i < b.size; ++i) {
    out[i] = {b.attribute[0][i], b.attribute[1][i], b.attribute[2][i], 1};
  }
}

void show_gradients(const Batch& b, LinearRgba* out) {
  for (int i = 0; i < b.size; ++i) out[i] = {b.du_dx[i], b.dv_dx[i], b.du_dy[i], b.dv_dy[i]};
}

/// A triangle of a plane in space, with attributes linear in space.
struct PerspectiveTriangle {
  explicit PerspectiveTriangle(unsigned seed, float reach) {
    RandomTriangles random(seed);
    for (int i = 0; i < 3; ++i) {
      TestVertex v{40 + random.between(-reach, reach), 40 + random.between(-reach, reach), 0.5f,
                   random.between(0.05f, 3)};
      v.x = std::floor(v.x * 256) / 256;
      v.y = std::floor(v.y * 256) / 256;
      vertex.push_back(v);
      for (int a = 0; a < 4; ++a) rows.push_back(random.between(-2, 2));
    }
    soup.add(vertex[0], vertex[1], vertex[2]);
  }
  DrawCall call(ShadeFunction shade) const {
    DrawCall c = soup.call(shade);
    c.attributes = rows;
    c.attribute_count = 3;
    c.attribute_stride = 4;
    c.texcoord_attribute = 1;
    return c;
  }
  double area() const {
    const auto& v = vertex;
    return (double{v[1].x} - v[0].x) * (double{v[2].y} - v[0].y) -
           (double{v[2].x} - v[0].x) * (double{v[1].y} - v[0].y);
  }
  /// Attribute `a` at a point of the screen: sum of b_i a_i / w_i over sum of b_i / w_i.
  double attribute(int a, double x, double y) const {
    double above = 0, below = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const TestVertex &p = vertex[(i + 1) % 3], &q = vertex[(i + 2) % 3];
      const double weight =
          ((double{p.x} - x) * (double{q.y} - y) - (double{q.x} - x) * (double{p.y} - y)) / area() *
          vertex[i].inv_w;
      above += weight * rows[4 * i + static_cast<std::size_t>(a)];
      below += weight;
    }
    return above / below;
  }

  std::vector<TestVertex> vertex;
  std::vector<float> rows;
  TriangleSoup soup;
};

TEST(Rasterizer, AttributesArePerspectiveCorrect) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const PerspectiveTriangle t(seed, seed % 3 == 0 ? 5.0f : seed % 3 == 1 ? 30.0f : 300.0f);
    if (std::abs(t.area()) < 4) continue;
    FloatCanvas canvas(80, 80);
    canvas.target.clear.a = 0;
    const DrawCall call = t.call(show_attributes);
    canvas.draw({&call, 1});
    for (int y = 0; y < 80; ++y) {
      for (int x = 0; x < 80; ++x) {
        const LinearRgba got = canvas.at(x, y);
        if (got.a == 0) continue;
        ++compared;
        ASSERT_NEAR(got.r, t.attribute(0, x + 0.5, y + 0.5), 2e-4) << seed;
        ASSERT_NEAR(got.g, t.attribute(1, x + 0.5, y + 0.5), 2e-4) << seed;
        ASSERT_NEAR(got.b, t.attribute(2, x + 0.5, y + 0.5), 2e-4) << seed;
      }
    }
  }
  EXPECT_GT(compared, 20000);
}

TEST(Rasterizer, TellsWhichSideIsSeenWhereBothAreDrawn) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const PerspectiveTriangle t(seed, 30);
    FloatCanvas canvas(80, 80);
    DrawCall call = t.call([](const Batch& b, LinearRgba* out) {
      for (int i = 0; i < b.size; ++i) out[i] = {b.facing[i], b.facing[i], 0, 1};
    });
    call.cull = CullMode::kNone;
    const RasterStats stats = canvas.draw({&call, 1});
    std::uint64_t right = 0;
    for (const LinearRgba& p : std::get<Floats>(canvas.target.colour).pixels()) {
      right += p.r == (t.area() < 0 ? 1.0f : -1.0f);  // y points down
    }
    EXPECT_EQ(right, stats.fragments) << seed;
  }
}

TEST(Rasterizer, GradientsAreTheDerivativesOfTextureCoordinates) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const PerspectiveTriangle t(seed, 30);
    if (std::abs(t.area()) < 40) continue;
    FloatCanvas canvas(80, 80);
    canvas.target.clear.r = NAN;
    const DrawCall call = t.call(show_gradients);
    canvas.draw({&call, 1});
    const auto slope = [&](int a, double x, double y, double dx, double dy) {
      constexpr double kStep = 1e-4;
      return (t.attribute(a, x + kStep * dx, y + kStep * dy) -
              t.attribute(a, x - kStep * dx, y - kStep * dy)) /
             (2 * kStep);
    };
    for (int y = 0; y < 80; ++y) {
      for (int x = 0; x < 80; ++x) {
        const LinearRgba got = canvas.at(x, y);
        if (std::isnan(got.r)) continue;
        const double px = x + 0.5, py = y + 0.5;
        ASSERT_NEAR(got.r, slope(1, px, py, 1, 0), 1e-3) << seed;
        ASSERT_NEAR(got.g, slope(2, px, py, 1, 0), 1e-3);
        ASSERT_NEAR(got.b, slope(1, px, py, 0, 1), 1e-3);
        ASSERT_NEAR(got.a, slope(2, px, py, 0, 1), 1e-3);
      }
    }
  }
}

TEST(Rasterizer, DepthIsThePlaneThroughTheVertices) {
  FloatCanvas canvas(64, 64);
  canvas.target.keep_depth = true;
  TriangleSoup soup;
  soup.add({0, 0, 0.25f}, {0, 64, 0.5f}, {64, 0, 0.75f});
  const DrawCall call = soup.call(nullptr);
  canvas.draw({&call, 1});
  for (int y = 0; y < 63; ++y) {
    for (int x = 0; x + y < 63; ++x) {
      EXPECT_NEAR(canvas.target.depth.at(x, y), 0.25 + 0.5 * (x + 0.5) / 64 + 0.25 * (y + 0.5) / 64,
                  1e-6);
    }
  }
  EXPECT_EQ(canvas.target.depth.at(63, 63), 1.0f);
}

}  // namespace
}  // namespace kinescope
