// Transparency that does not depend on the order of submission.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "tests/raster/blend_scene.h"

namespace kinescope {
namespace {

/// Every triangle its own colour, wherever it is submitted.
void shade_by_name(const Batch& batch, LinearRgba* out) {
  const auto& names = *static_cast<const std::vector<std::uint32_t>*>(batch.constants);
  for (int i = 0; i < batch.size; ++i) {
    const std::uint32_t n = names[batch.primitive[i]] * 2654435761u;
    const auto part = [n](int shift) { return static_cast<float>(n >> shift & 255) / 255.0f; };
    out[i] = {part(0), part(8), part(16), part(24)};
  }
}

/// Random triangles in a random order, in two calls; the picture that they make.
Image<LinearRgba> draw_shuffled(const TriangleSoup& soup, unsigned seed, int samples) {
  std::vector<std::uint32_t> names(soup.size());
  std::iota(names.begin(), names.end(), 0u);
  std::mt19937 random(seed);
  if (seed != 0) std::shuffle(names.begin(), names.end(), random);
  const std::size_t split = soup.size() / (seed + 2);
  std::array<std::vector<std::uint32_t>, 2> named = {
      std::vector(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(split)),
      std::vector(names.begin() + static_cast<std::ptrdiff_t>(split), names.end())};
  BlendScene scene;
  for (const auto& of_call : named) {
    TriangleSoup part;
    for (const std::uint32_t t : of_call) {
      part.add(soup.vertex(3 * t), soup.vertex(3 * t + 1), soup.vertex(3 * t + 2));
    }
    scene.add(part, shade_by_name, BlendMode::kAlpha, BlendOrder::kByDepth).constants = &of_call;
  }
  return draw_blended(scene.calls, 90, 70, samples).colour;
}

TEST(Transparency, AnyOrderOfSubmissionGivesThePictureBitByBit) {
  for (const int samples : {1, 4, 8}) {
    RandomTriangles random(static_cast<unsigned>(samples));
    TriangleSoup soup;
    for (int i = 0; i < 600; ++i) {
      const float reach = std::array{2.0f, 9.0f, 40.0f, 300.0f}[static_cast<std::size_t>(i % 4)];
      // With these seeds no two depths at a sample are equal, which would show the order.
      const auto corner = [&] {
        return TestVertex{random.between(45 - reach, 45 + reach),
                          random.between(35 - reach, 35 + reach), random.between(0.01f, 0.99f)};
      };
      const std::array corners = {corner(), corner(), corner()};
      soup.add(corners[2], corners[1], corners[0]);
    }
    const Image<LinearRgba> picture = draw_shuffled(soup, 0, samples);
    for (unsigned seed = 1; seed <= 5; ++seed) {
      EXPECT_EQ(draw_shuffled(soup, seed, samples), picture) << seed;
    }
  }
}

TEST(Transparency, TheFartherLiesBelow) {
  const LinearRgba near = {1, 0, 0, 0.5f}, far = {0, 1, 0, 0.5f};
  for (const bool near_first : {false, true}) {
    BlendScene scene;
    for (const bool is_near : {near_first, !near_first}) {
      scene.add_rect({0, 0, 9, 9}, is_near ? 0.25f : 0.75f, is_near ? near : far, BlendMode::kAlpha,
                     BlendOrder::kByDepth);
    }
    EXPECT_EQ(draw_blended(scene.calls, 9, 9).colour.at(4, 4), (LinearRgba{0.5f, 0.25f, 0, 1}));
  }
}

TEST(Transparency, EqualDepthsAreBlendedAsSubmitted) {
  BlendScene scene;
  scene.add_rect({0, 0, 9, 9}, 0.5f, {1, 0, 0, 0.5f}, BlendMode::kAlpha, BlendOrder::kByDepth);
  scene.add_rect({0, 0, 9, 9}, 0.5f, {0, 1, 0, 0.5f}, BlendMode::kAlpha, BlendOrder::kByDepth);
  EXPECT_EQ(draw_blended(scene.calls, 9, 9).colour.at(4, 4), (LinearRgba{0.25f, 0.5f, 0, 1}));
}

/// A tilted rectangle: its depth runs from z0 at the left to z1 at the right.
TriangleSoup tilted(float width, float height, float z0, float z1) {
  TriangleSoup soup;
  soup.add({0, 0, z0}, {0, height, z0}, {width, height, z1});
  soup.add({0, 0, z0}, {width, height, z1}, {width, 0, z1});
  return soup;
}

TEST(Transparency, TrianglesThatPassThroughOneAnotherChangePlacesWhereTheyMeet) {
  constexpr int kWidth = 80, kHeight = 40;
  for (const int samples : {1, 4, 8}) {
    BlendScene scene;
    scene.add(tilted(kWidth, kHeight, 0.2f, 0.8f), {1, 0, 0, 0.5f}, BlendMode::kAlpha,
              BlendOrder::kByDepth);
    scene.add(tilted(kWidth, kHeight, 0.8f, 0.2f), {0, 1, 0, 0.5f}, BlendMode::kAlpha,
              BlendOrder::kByDepth);
    const Image<LinearRgba> picture = draw_blended(scene.calls, kWidth, kHeight, samples).colour;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const LinearRgba red_above = {0.5f, 0.25f, 0, 1}, green_above = {0.25f, 0.5f, 0, 1};
        ASSERT_EQ(picture.at(x, y), x < kWidth / 2 ? red_above : green_above) << x << ',' << y;
      }
    }
  }
}

TEST(Transparency, WhatIsOpaqueHidesWhereverItIsSubmitted) {
  for (const bool opaque_first : {false, true}) {
    BlendScene scene;
    const auto add_opaque = [&] {
      scene.add_rect({0, 0, 9, 9}, 0.5f, {0, 0, 1, 1}, BlendMode::kOpaque);
    };
    if (opaque_first) add_opaque();
    scene.add_rect({0, 0, 9, 9}, 0.75f, {1, 0, 0, 0.5f}, BlendMode::kAlpha, BlendOrder::kByDepth);
    scene.add_rect({0, 0, 9, 5}, 0.25f, {0, 1, 0, 0.5f}, BlendMode::kAlpha, BlendOrder::kByDepth);
    if (!opaque_first) add_opaque();
    const BlendDrawn drawn = draw_blended(scene.calls, 9, 9);
    EXPECT_EQ(drawn.colour.at(4, 2), (LinearRgba{0, 0.5f, 0.5f, 1}));
    EXPECT_EQ(drawn.colour.at(4, 7), (LinearRgba{0, 0, 1, 1}));
    EXPECT_EQ(drawn.depth.at(4, 2), 0.5f) << "depth is not written by depth";
  }
}

/// Triangles that lie apart in depth are drawn one by one; one more that does not must change
/// nothing about them.
TEST(Transparency, LayersApartAndLayersThatMeetGiveOnePicture) {
  RandomTriangles random(12);
  for (const int samples : {1, 4}) {
    BlendScene apart;
    for (int i = 0; i < 40; ++i) {
      const int x = random.below(50) - 9, y = random.below(40) - 9, side = 5 + random.below(50);
      // Some at one depth.
      const float z = static_cast<float>(random.below(30) + 1) / 32.0f;
      const LinearRgba colour = {random.between(0, 1), random.between(0, 1), random.between(0, 1),
                                 random.between(0, 1)};
      apart.add_rect({x, y, x + side, y + side}, z, colour, BlendMode::kAlpha,
                     BlendOrder::kByDepth);
    }
    BlendScene meeting = apart;
    // Across all depths, and invisible.
    meeting.add(tilted(60, 50, 0, 1), {0, 0, 0, 0}, BlendMode::kAdditive, BlendOrder::kByDepth);
    EXPECT_EQ(draw_blended(apart.calls, 60, 50, samples).colour,
              draw_blended(meeting.calls, 60, 50, samples).colour);
  }
}

/// Half a pixel of a layer blends onto half its samples.
TEST(Transparency, SamplesAreBlendedOneByOne) {
  for (const int samples : {4, 8}) {
    for (const BlendOrder order : {BlendOrder::kSubmitted, BlendOrder::kByDepth}) {
      TriangleSoup left, right;
      left.add({0, 0, 0.5f}, {0, 8, 0.5f}, {2.5f, 8, 0.5f});
      left.add({0, 0, 0.5f}, {2.5f, 8, 0.5f}, {2.5f, 0, 0.5f});
      right.add({2.5f, 0, 0.5f}, {2.5f, 8, 0.5f}, {8, 8, 0.5f});
      right.add({2.5f, 0, 0.5f}, {8, 8, 0.5f}, {8, 0, 0.5f});
      BlendScene scene;
      scene.add(left, {1, 0, 0, 0.5f}, BlendMode::kAlpha, order);
      scene.add(right, {0, 0, 1, 0.5f}, BlendMode::kAlpha, order);
      EXPECT_EQ(draw_blended(scene.calls, 8, 8, samples).colour.at(2, 4),
                (LinearRgba{0.25f, 0, 0.25f, 1}));
    }
  }
}

TEST(Transparency, TenThousandLayersInOneTile) {
  constexpr int kLayers = 10000;
  std::vector<int> order(kLayers);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(3);
  std::shuffle(order.begin(), order.end(), random);
  BlendScene scene;
  // From the farthest: each takes a thousandth of what lies below.
  TriangleSoup soup;
  for (const int i : order) {
    const float z = static_cast<float>(kLayers - i) / (kLayers + 1);
    soup.add({0, 0, z}, {0, 80, z}, {80, 0, z});
  }
  std::vector<LinearRgba> colours;
  double expected = 0;
  for (int i = 0; i < kLayers; ++i) expected += (i % 7 / 7.0 - expected) * 0x1p-10;
  for (const int i : order) colours.push_back({static_cast<float>(i % 7) / 7.0f, 0, 0, 0x1p-10f});
  const auto shade = [](const Batch& batch, LinearRgba* out) {
    for (int i = 0; i < batch.size; ++i) {
      out[i] = static_cast<const LinearRgba*>(batch.constants)[batch.primitive[i]];
    }
  };
  scene.add(soup, shade, BlendMode::kAlpha, BlendOrder::kByDepth).constants = colours.data();
  for (const int samples : {1, 4}) {
    const BlendDrawn drawn = draw_blended(scene.calls, 17, 11, samples);
    EXPECT_EQ(drawn.stats.fragments, 17u * 11u * kLayers);
    for (const LinearRgba& pixel : drawn.colour.pixels()) ASSERT_NEAR(pixel.r, expected, 1e-4);
    EXPECT_EQ(drawn.colour, draw_blended(scene.calls, 17, 11, samples, 1, {8, 8}).colour);
  }
}

TEST(Transparency, TenThousandLayersInOrderSumExactly) {
  TriangleSoup soup;
  for (int i = 0; i < 10000; ++i) soup.add({0, 0}, {0, 80}, {80, 0});
  BlendScene scene;
  DrawCall& call =
      scene.add(soup, {0x1p-14f, 0, 1, 1}, BlendMode::kAdditive, BlendOrder::kSubmitted);
  call.depth_test = DepthTest::kAlways;
  const Image<LinearRgba> picture = draw_blended(scene.calls, 20, 20, 4).colour;
  for (const LinearRgba& pixel : picture.pixels()) {
    ASSERT_EQ(pixel, (LinearRgba{10000 * 0x1p-14f, 0, 10000, 1}));
  }
}

TEST(Transparency, NothingIsTouchedByCallsThatDrawNothing) {
  BlendScene scene;
  scene.add_rect({0, 0, 9, 9}, 0.5f, {0, 0, 1, 1}, BlendMode::kOpaque);
  const BlendDrawn plain = draw_blended(scene.calls, 40, 40);
  scene.add_rect({50, 50, 60, 60}, 0.5f, {1, 1, 1, 1});
  scene.add(TriangleSoup(), {1, 1, 1, 1}, BlendMode::kAlpha, BlendOrder::kByDepth);
  scene.add_rect({0, 0, 0, 9}, 0.5f, {1, 1, 1, 1});
  const BlendDrawn drawn = draw_blended(scene.calls, 40, 40);
  EXPECT_EQ(drawn.colour, plain.colour);
  EXPECT_EQ(drawn.stats.visibility_hash, plain.stats.visibility_hash);
  EXPECT_EQ(drawn.stats.fragments, plain.stats.fragments);
}

}  // namespace
}  // namespace kinescope
