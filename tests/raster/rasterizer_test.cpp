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
#include "tests/raster/float_canvas.h"
#include "tests/raster/triangle_soup.h"

namespace kinescope {
namespace {

TEST(Rasterizer, TheNearestWinsAndOfEqualsTheFirst) {
  FloatCanvas canvas(40, 4);
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
  FloatCanvas canvas(2, 2);
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
  FloatCanvas canvas(kCalls, 30);
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
  FloatCanvas canvas(300, 77, 4);
  EXPECT_EQ(canvas.draw({&call, 1}).fragments, 300u * 77);
  EXPECT_EQ(canvas.at(299, 76).r, 0.5f);
}

TEST(Rasterizer, NoCallsOrNoTrianglesLeaveTheClearColour) {
  FloatCanvas canvas(70, 40, 4);
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
  FloatCanvas canvas(60, 4);
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
  FloatCanvas canvas(50, 50);
  const RasterStats stats = canvas.draw({&call, 1});
  EXPECT_EQ(stats.triangles, 5u);
  EXPECT_EQ(stats.drawn, 2u);
  EXPECT_EQ(stats.visibility_hash, 0u);
}

TEST(Rasterizer, AMillionDegenerateTriangles) {
  const std::vector<DeviceVertex> vertices = {{3, 3, 3, 1}, {9, 9, 9, 1}};
  std::vector<std::uint32_t> indices(3'000'000);
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i % 7 == 0;
  DrawCall call;
  call.vertices = vertices;
  call.indices = indices;
  call.cull = CullMode::kNone;
  FloatCanvas canvas(20, 20);
  const RasterStats stats = canvas.draw({&call, 1});
  EXPECT_EQ(stats.triangles, 1'000'000u);
  EXPECT_EQ(stats.drawn, 0u);
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
