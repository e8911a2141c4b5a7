// Attributes, batches, depth, calls and targets: what a draw call asks for is what it gets.
#include "raster/rasterizer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "raster/base/error.h"
#include "tests/raster/triangle_soup.h"

namespace kinescope {
namespace {

using Floats = Image<LinearRgba>;

/// A rasterizer with a float target.
struct Canvas {
  Canvas(int width, int height, int samples = 1)
      : workers(2),
        rasterizer(workers),
        target(width, height, samples, ColourFormat::kLinearFloat) {}
  RasterStats draw(std::span<const DrawCall> calls) { return rasterizer.draw(target, calls); }
  const LinearRgba& at(int x, int y) const { return std::get<Floats>(target.colour).at(x, y); }

  Workers workers;
  Rasterizer rasterizer;
  RenderTarget target;
};

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
    Canvas canvas(80, 80);
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
    Canvas canvas(80, 80);
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
    Canvas canvas(80, 80);
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
  Canvas canvas(64, 64);
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

TEST(Rasterizer, TheNearestWinsAndOfEqualsTheFirst) {
  Canvas canvas(40, 4);
  const TestVertex a{-1, -1}, b{-1, 9}, c{50, -1};
  const auto at_depth = [](TestVertex v, float z) {
    v.z = z;
    return v;
  };
  TriangleSoup soup;
  for (const float z : {0.5f, 0.25f, 0.25f, 0.75f}) {
    soup.add(at_depth(a, z), at_depth(b, z), at_depth(c, z));
  }
  // A small triangle, which takes another path, ties with the large ones and came last.
  soup.add(at_depth({2, 0}, 0.25f), at_depth({2, 3}, 0.25f), at_depth({5, 0}, 0.25f));
  const DrawCall call = soup.call(shade_primitive);
  canvas.draw({&call, 1});
  EXPECT_EQ(canvas.at(2, 0).r, 1.0f);
  EXPECT_EQ(canvas.at(30, 0).r, 1.0f);
}

TEST(Rasterizer, DepthOfOneIsStillDrawn) {
  Canvas canvas(2, 2);
  canvas.target.clear.r = -1;
  TriangleSoup soup;
  soup.add({-1, -1, 1}, {-1, 9, 1}, {9, -1, 1});
  const DrawCall call = soup.call(shade_primitive);
  canvas.draw({&call, 1});
  EXPECT_EQ(canvas.at(1, 1).r, 0.0f);
}

void show_constants(const Batch& b, LinearRgba* out) {
  const float value = *static_cast<const float*>(b.constants);
  for (int i = 0; i < b.size; ++i) {
    out[i] = {value, static_cast<float>(b.primitive[i]), static_cast<float>(b.x[i]),
              static_cast<float>(b.y[i])};
  }
}

TEST(Rasterizer, CallsMixInOneTileAndKeepTheirOwnConstants) {
  constexpr int kCalls = 23;
  std::vector<float> constants(kCalls);
  std::iota(constants.begin(), constants.end(), 100.0f);
  std::vector<TriangleSoup> soups(kCalls);
  std::vector<DrawCall> calls;
  const std::uint32_t sources[] = {7, 9};
  for (std::size_t i = 0; i < kCalls; ++i) {
    const auto x = static_cast<float>(i);
    soups[i].add({x, -1}, {x, 40}, {x + 1, -1});
    soups[i].add({x + 1, -1}, {x, 40}, {x + 1, 40});
    calls.push_back(soups[i].call(show_constants));
    calls.back().constants = &constants[i];
    if (i == 5) calls.back().source_triangle = sources;
  }
  Canvas canvas(kCalls, 30);
  canvas.draw(calls);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < kCalls; ++x) {
      const LinearRgba got = canvas.at(x, y);
      EXPECT_EQ(got.r, 100.0f + static_cast<float>(x));
      EXPECT_EQ(got.b, static_cast<float>(x));
      EXPECT_EQ(got.a, static_cast<float>(y));
      if (x == 5)
        EXPECT_TRUE(got.g == 7 || got.g == 9);
      else
        EXPECT_LT(got.g, 2.0f);
    }
  }
}

void check_batch(const Batch& b, LinearRgba* out) {
  ASSERT_GE(b.size, 1);
  ASSERT_LE(b.size, Batch::kMaxSize);
  const auto aligned = [](const void* p) { return reinterpret_cast<std::uintptr_t>(p) % 64 == 0; };
  EXPECT_TRUE(aligned(b.x) && aligned(b.y) && aligned(b.primitive) && aligned(b.attribute[0]));
  EXPECT_EQ(b.du_dx, nullptr);
  EXPECT_EQ(b.attribute[1], nullptr);
  // A shader may write whole vectors, up to the largest batch.
  std::fill_n(out, Batch::kMaxSize, LinearRgba{0.5f, 0, 0, 1});
}

TEST(Rasterizer, BatchesAreAlignedPaddedAndNotTooLarge) {
  TriangleSoup soup;
  soup.add({-1, -1}, {-1, 900}, {900, -1});
  const std::vector<float> rows(3, 1.0f);
  DrawCall call = soup.call(check_batch);
  call.attributes = rows;
  call.attribute_count = call.attribute_stride = 1;
  Canvas canvas(300, 77, 4);
  EXPECT_EQ(canvas.draw({&call, 1}).fragments, 300u * 77);
  EXPECT_EQ(canvas.at(299, 76).r, 0.5f);
}

TEST(Rasterizer, NoCallsOrNoTrianglesLeaveTheClearColour) {
  Canvas canvas(70, 40, 4);
  canvas.target.clear = {0.25f, 0.5f, 0.75f, 1};
  canvas.target.keep_depth = true;
  EXPECT_EQ(canvas.draw({}).triangles, 0u);
  EXPECT_EQ(canvas.at(69, 39), canvas.target.clear);
  const DrawCall empty;
  const RasterStats stats = canvas.draw({&empty, 1});
  EXPECT_EQ(stats.drawn + stats.fragments + stats.triangles, 0u);
  EXPECT_EQ(canvas.at(0, 0), canvas.target.clear);
  EXPECT_EQ(canvas.target.depth.at(69, 39), 1.0f);
}

TEST(Rasterizer, WithoutAShaderTheClearColourHidesWhatLiesBehind) {
  TriangleSoup front, back;
  front.add({-1, -1, 0.2f}, {-1, 90, 0.2f}, {20, -1, 0.2f});
  back.add({-1, -1, 0.8f}, {-1, 900, 0.8f}, {900, -1, 0.8f});
  Canvas canvas(60, 4);
  canvas.target.clear.r = -1;
  const DrawCall calls[] = {front.call(nullptr), back.call(shade_primitive)};
  canvas.draw(calls);
  EXPECT_EQ(canvas.at(3, 1).r, -1.0f);
  EXPECT_EQ(canvas.at(50, 1).r, 0.0f);
}

TEST(Rasterizer, CountsTriangles) {
  TriangleSoup soup;
  soup.add({0, 0}, {0, 8}, {8, 0});               // drawn, front
  soup.add({0, 0}, {8, 0}, {0, 8});               // faces away
  soup.add({0, 0}, {4, 4}, {8, 8});               // no area
  soup.add({900, 0}, {900, 80}, {980, 0});        // off the target
  soup.add({-900, -900}, {-900, 900}, {900, 0});  // drawn, large
  const DrawCall call = soup.call(shade_primitive, CullMode::kBack);
  Canvas canvas(50, 50);
  const RasterStats stats = canvas.draw({&call, 1});
  EXPECT_EQ(stats.triangles, 5u);
  EXPECT_EQ(stats.drawn, 2u);
  EXPECT_EQ(stats.visibility_hash, 0u);
}

TEST(Rasterizer, AMillionDegenerateTriangles) {
  const std::vector<float> one = {3, 9}, w = {1, 1};
  std::vector<std::uint32_t> indices(3'000'000);
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i % 7 == 0;
  DrawCall call;
  call.vertices = {one, one, one, w};
  call.indices = indices;
  call.cull = CullMode::kNone;
  Canvas canvas(20, 20);
  const RasterStats stats = canvas.draw({&call, 1});
  EXPECT_EQ(stats.triangles, 1'000'000u);
  EXPECT_EQ(stats.drawn, 0u);
}

TEST(Rasterizer, OnePixel) {
  TriangleSoup soup;
  soup.add({0, 0}, {0, 3}, {3, 0});
  const DrawCall call = soup.call(shade_primitive);
  for (const int samples : {1, 4, 8}) {
    Canvas canvas(1, 1, samples);
    canvas.target.clear.r = -1;
    EXPECT_EQ(canvas.draw({&call, 1}).fragments, 1u);
    EXPECT_EQ(canvas.at(0, 0).r, 0.0f);
  }
}

TEST(Rasterizer, TheLargestTargetToItsLastPixel) {
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget target(RenderTarget::kMaxSize, 16, 1);
  RenderTarget tall(16, RenderTarget::kMaxSize, 1);
  TriangleSoup soup;
  soup.add({-32768, -32768}, {-32768, 32768}, {32768, 32768});
  soup.add({-32768, -32768}, {32768, 32768}, {32768, -32768});
  const DrawCall call = soup.call([](const Batch& b, LinearRgba* out) {
    for (int i = 0; i < b.size; ++i) {
      out[i] = {static_cast<float>(b.x[i]) / 16383, static_cast<float>(b.y[i]) / 16383, 0, 1};
    }
  });
  EXPECT_EQ(rasterizer.draw(target, {&call, 1}).fragments, 16u * 16384);
  EXPECT_EQ(target.srgb8().at(16383, 15).r, 255);
  EXPECT_EQ(rasterizer.draw(tall, {&call, 1}).fragments, 16u * 16384);
  EXPECT_EQ(tall.srgb8().at(15, 16383).g, 255);
}

TEST(RenderTarget, RefusesSizesThatNoMemoryHolds) {
  for (const int bad : {0, -1, 16385, 1 << 30, std::numeric_limits<int>::min()}) {
    EXPECT_THROW(RenderTarget(bad, 10), Error) << bad;
    EXPECT_THROW(RenderTarget(10, bad), Error) << bad;
  }
  EXPECT_THROW(RenderTarget(10, 10, 3), Error);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(RenderTarget, SaysSoWhenMemoryCannotBeHad) {
  const auto draw_with_little_memory = [] {
    rlimit limit{};
    limit.rlim_cur = limit.rlim_max = 600u << 20;
    setrlimit(RLIMIT_AS, &limit);
    try {
      const RenderTarget target(RenderTarget::kMaxSize, RenderTarget::kMaxSize);
    } catch (const Error& e) {
      std::fputs(e.what(), stderr);
      std::_Exit(3);
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(draw_with_little_memory(), testing::ExitedWithCode(3),
              "no memory for a picture of 16384x16384 \\(1073 MB\\)");
}
#endif

TEST(Rasterizer, RefusesTilesThatAreNotMultiplesOfEight) {
  Workers workers(1);
  RenderTarget target(10, 10);
  for (const int bad : {-8, 4, 12, 72}) {
    Rasterizer wide(workers, {bad, 8}), high(workers, {8, bad});
    EXPECT_THROW(wide.draw(target, {}), Error) << bad;
    EXPECT_THROW(high.draw(target, {}), Error) << bad;
  }
}

TEST(Rasterizer, FormatsAreEncodedAsTheyEnd) {
  TriangleSoup soup;
  soup.add({-1, -1}, {-1, 9}, {9, -1});
  const DrawCall call = soup.call([](const Batch& b, LinearRgba* out) {
    std::fill_n(out, b.size, LinearRgba{0.5f, 2, -1, 0.25f});
  });
  Workers workers(1);
  Rasterizer rasterizer(workers);
  RenderTarget srgb(3, 3, 1, ColourFormat::kSrgb8), linear(3, 3, 1, ColourFormat::kLinear8),
      floats(3, 3, 1, ColourFormat::kLinearFloat);
  for (RenderTarget* target : {&srgb, &linear, &floats}) rasterizer.draw(*target, {&call, 1});
  EXPECT_EQ(srgb.srgb8().at(1, 1), (Srgb8{188, 255, 0, 64}));
  EXPECT_EQ(std::get<Image<Linear8>>(linear.colour).at(1, 1), (Linear8{128, 255, 0, 64}));
  EXPECT_EQ(std::get<Floats>(floats.colour).at(1, 1), (LinearRgba{0.5f, 2, -1, 0.25f}));
}

}  // namespace
}  // namespace kinescope
