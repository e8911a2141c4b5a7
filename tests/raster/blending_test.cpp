// What one fragment does to what lies below, by formula.
#include "raster/blending.h"

#include <gtest/gtest.h>

#include <limits>

#include "raster/base/simd.h"
#include "tests/raster/blend_scene.h"

namespace kinescope {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr LinearRgba kBelow = {0.5f, 0.25f, 1.0f, 0.5f};
constexpr LinearRgba kSource = {1.0f, 0.5f, 0.0f, 0.25f};

LinearRgba drawn(BlendMode mode, BlendOrder order, LinearRgba source, LinearRgba below,
                 int samples) {
  BlendScene scene;
  scene.add_rect({0, 0, 3, 1}, 0.5f, source, mode, order);
  return draw_blended(scene.calls, 3, 1, samples, 1, {}, below).colour.at(1, 0);
}

/// The scalar law, and the rasterizer on every instruction set, at every sample count and in both
/// orders.
void expect_blend(BlendMode mode, LinearRgba source, LinearRgba below, LinearRgba expected) {
  EXPECT_EQ(blended(mode, source, below), expected);
  for (const std::string& target : simd_targets()) {
    use_simd_target(target);
    for (const BlendOrder order : {BlendOrder::kSubmitted, BlendOrder::kByDepth}) {
      for (const int samples : {1, 4, 8}) {
        EXPECT_EQ(drawn(mode, order, source, below, samples), expected)
            << target << ", " << samples << " samples";
      }
    }
  }
  use_simd_target("best");
}

TEST(Blending, AlphaIsSourceOver) {
  // 1/4 source and 3/4 below; alpha 1/4 + 3/4 of 1/2.
  expect_blend(BlendMode::kAlpha, kSource, kBelow, {0.625f, 0.3125f, 0.75f, 0.625f});
  expect_blend(BlendMode::kAlpha, {1, 0.5f, 0, 0}, kBelow, kBelow);
  expect_blend(BlendMode::kAlpha, {1, 0.5f, 0, 1}, kBelow, {1, 0.5f, 0, 1});
}

TEST(Blending, AdditiveAddsLight) {
  expect_blend(BlendMode::kAdditive, kSource, kBelow, {0.75f, 0.375f, 1.0f, 0.5f});
  expect_blend(BlendMode::kAdditive, {2, 2, 2, 1}, kBelow, {2.5f, 2.25f, 3.0f, 0.5f});
}

TEST(Blending, MultiplyFilters) {
  // Three quarters pass unfiltered.
  expect_blend(BlendMode::kMultiply, kSource, kBelow, {0.5f, 0.21875f, 0.75f, 0.5f});
  expect_blend(BlendMode::kMultiply, {0.5f, 0, 1, 1}, kBelow, {0.25f, 0.0f, 1.0f, 0.5f});
}

TEST(Blending, OpaqueReplacesWhateverAlphaIs) {
  expect_blend(BlendMode::kOpaque, kSource, kBelow, kSource);
  expect_blend(BlendMode::kOpaque, {-3, 7, 0x1p99f, 5}, kBelow, {-3, 7, 0x1p99f, 5});
}

TEST(Blending, AlphaOutOfRangeIsCut) {
  for (const BlendMode mode : {BlendMode::kAlpha, BlendMode::kAdditive, BlendMode::kMultiply}) {
    for (const float alpha : {-0.5f, -kInfinity, kNan}) {
      expect_blend(mode, {1, 0.5f, 0, alpha}, kBelow, kBelow);
    }
    const LinearRgba all = blended(mode, {1, 0.5f, 0, 1}, kBelow);
    for (const float alpha : {1.5f, kInfinity})
      expect_blend(mode, {1, 0.5f, 0, alpha}, kBelow, all);
  }
}

TEST(Blending, WhatIsNoNumberAddsNothing) {
  expect_blend(BlendMode::kAdditive, {kNan, 1, kNan, 1}, kBelow, {0.5f, 1.25f, 1.0f, 0.5f});
  expect_blend(BlendMode::kAlpha, {kNan, kInfinity, -kInfinity, 0}, kBelow, kBelow);
  expect_blend(BlendMode::kAlpha, {kNan, 1, 1, 1}, kBelow, {0, 1, 1, 1});
}

TEST(Blending, InfiniteLightIsCutSoThatSumsStayFinite) {
  expect_blend(BlendMode::kAdditive, {kInfinity, 0, 0, 1}, {kMostLight, 0, 0, 1},
               {2 * kMostLight, 0, 0, 1});
}

TEST(Blending, DepthTestsAreSetsOfRelations) {
  const auto expect = [](DepthTest test, bool nearer, bool equal, bool farther) {
    EXPECT_EQ(passes(test, 0.25f, 0.5f), nearer);
    EXPECT_EQ(passes(test, 0.5f, 0.5f), equal);
    EXPECT_EQ(passes(test, 0.75f, 0.5f), farther);
  };
  expect(DepthTest::kNever, false, false, false);
  expect(DepthTest::kLess, true, false, false);
  expect(DepthTest::kEqual, false, true, false);
  expect(DepthTest::kLessEqual, true, true, false);
  expect(DepthTest::kGreater, false, false, true);
  expect(DepthTest::kNotEqual, true, false, true);
  expect(DepthTest::kGreaterEqual, false, true, true);
  expect(DepthTest::kAlways, true, true, true);
}

}  // namespace
}  // namespace kinescope
