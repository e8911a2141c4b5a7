// Blended pictures against the scalar reference, and against themselves drawn otherwise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "raster/base/simd.h"
#include "raster/reference_rasterizer.h"
#include "tests/raster/blend_scene.h"

namespace kinescope {
namespace {

constexpr int kWidth = 119, kHeight = 83;
constexpr LinearRgba kClear = {0.2f, 0.3f, 0.4f, 1};

LinearRgba mean(const ReferenceImage& image, int x, int y) {
  LinearRgba sum = {0, 0, 0, 0};
  for (std::size_t s = 0; s < static_cast<std::size_t>(image.samples); ++s) {
    const LinearRgba& c = image.colour[image.index(x, y, s)];
    sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b, sum.a + c.a};
  }
  const float share = 1.0f / static_cast<float>(image.samples);
  return {sum.r * share, sum.g * share, sum.b * share, sum.a * share};
}

void expect_reference(const BlendScene& scene, const ReferenceImage& reference, float tolerance) {
  const BlendDrawn drawn =
      draw_blended(scene.calls, kWidth, kHeight, reference.samples, 2, {}, kClear);
  EXPECT_EQ(drawn.stats.visibility_hash, reference.visibility_hash);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_EQ(drawn.depth.at(x, y), reference.depth[reference.index(x, y, 0)]) << x << ',' << y;
      const LinearRgba got = drawn.colour.at(x, y), want = mean(reference, x, y);
      ASSERT_NEAR(got.r, want.r, tolerance) << x << ',' << y;
      ASSERT_NEAR(got.g, want.g, tolerance) << x << ',' << y;
      ASSERT_NEAR(got.b, want.b, tolerance) << x << ',' << y;
      ASSERT_NEAR(got.a, want.a, tolerance) << x << ',' << y;
    }
  }
}

TEST(OrderedReference, ColoursAndDepthOnEveryInstructionSet) {
  for (const int samples : {1, 4, 8}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      const BlendScene scene = random_blend_scene(seed, kWidth, kHeight);
      const ReferenceImage reference =
          draw_reference_colours(kWidth, kHeight, samples, scene.calls, kClear);
      for (const std::string& name : simd_targets()) {
        SCOPED_TRACE(name + ", seed " + std::to_string(seed));
        use_simd_target(name);
        // One sample has nothing to be averaged: equal bit by bit.
        expect_reference(scene, reference, samples == 1 ? 0.0f : 1e-5f);
      }
      use_simd_target("best");
    }
  }
}

TEST(OrderedReference, AttributesToACodeOfEight) {
  for (const int samples : {1, 4, 8}) {
    RandomTriangles random(static_cast<unsigned>(samples));
    std::vector<float> rows;
    for (int i = 0; i < 4 * 3 * 100; ++i) rows.push_back(random.between(0, 1));
    BlendScene scene = random_blend_scene(9, kWidth, kHeight, shade_attributes);
    for (DrawCall& call : scene.calls) {
      call.attributes = rows;
      call.attribute_count = call.attribute_stride = 4;
    }
    expect_reference(scene, draw_reference_colours(kWidth, kHeight, samples, scene.calls, kClear),
                     1.0f / 255.0f);
  }
}

void expect_same(const BlendDrawn& a, const BlendDrawn& b) {
  EXPECT_EQ(a.colour, b.colour);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.stats.visibility_hash, b.stats.visibility_hash);
  EXPECT_EQ(a.stats.fragments, b.stats.fragments);
}

TEST(OrderedReference, SameForAnyThreadsAndTiles) {
  for (const int samples : {1, 4, 8}) {
    const BlendScene scene = random_blend_scene(20, kWidth, kHeight);
    const BlendDrawn one = draw_blended(scene.calls, kWidth, kHeight, samples, 1, {}, kClear);
    for (const int threads : {2, 8}) {
      expect_same(draw_blended(scene.calls, kWidth, kHeight, samples, threads, {}, kClear), one);
    }
    for (const auto& [w, h] : {std::pair{8, 8}, {16, 64}, {24, 40}, {64, 64}, {64, 8}}) {
      expect_same(draw_blended(scene.calls, kWidth, kHeight, samples, 2, {w, h}, kClear), one);
    }
  }
}

/// More triangles than one range of the front end takes, so that several workers fill the bins.
TEST(OrderedReference, ManyRangesKeepTheirOrder) {
  RandomTriangles random(6);
  BlendScene scene;
  scene.add(random.soup(4000, 64, 48), shade_by_number_and_pixel, BlendMode::kAlpha,
            BlendOrder::kSubmitted);
  scene.calls[0].depth_test = DepthTest::kAlways;
  const ReferenceImage reference = draw_reference_colours(64, 48, 1, scene.calls, kClear);
  for (const int threads : {1, 8}) {
    const BlendDrawn drawn = draw_blended(scene.calls, 64, 48, 1, threads, {}, kClear);
    EXPECT_TRUE(std::ranges::equal(drawn.colour.pixels(), reference.colour));
  }
}

/// One rasterizer, frame after frame: what was blended before leaves nothing behind.
TEST(OrderedReference, FramesDoNotSeeOneAnother) {
  const BlendScene blended = random_blend_scene(3, kWidth, kHeight);
  RandomTriangles random(4);
  BlendScene plain;
  plain.add(random.soup(300, kWidth, kHeight), shade_by_number_and_pixel, BlendMode::kOpaque,
            BlendOrder::kSubmitted);
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget target(kWidth, kHeight, 4);
  rasterizer.draw(target, plain.calls);
  const Image<Srgb8> first = target.srgb8();
  rasterizer.draw(target, blended.calls);
  const Image<Srgb8> second = target.srgb8();
  EXPECT_NE(first, second);
  rasterizer.draw(target, plain.calls);
  EXPECT_EQ(target.srgb8(), first);
  rasterizer.draw(target, blended.calls);
  EXPECT_EQ(target.srgb8(), second);
}

TEST(OrderedReference, EveryFormatHoldsTheSamePicture) {
  const BlendScene scene = random_blend_scene(7, kWidth, kHeight);
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget linear(kWidth, kHeight, 4, ColourFormat::kLinearFloat);
  RenderTarget encoded(kWidth, kHeight, 4), quantized(kWidth, kHeight, 4, ColourFormat::kLinear8);
  for (RenderTarget* target : {&linear, &encoded, &quantized})
    rasterizer.draw(*target, scene.calls);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const LinearRgba c = std::get<Image<LinearRgba>>(linear.colour).at(x, y);
      ASSERT_EQ(encoded.srgb8().at(x, y), encode_srgb8(c));
      const float r = std::clamp(c.r, 0.0f, 1.0f) * 255.0f;
      ASSERT_EQ(std::get<Image<Linear8>>(quantized.colour).at(x, y).r,
                static_cast<std::uint8_t>(std::nearbyint(r)));
    }
  }
}

}  // namespace
}  // namespace kinescope
