// Depth tests and depth writes against a simulation of whole pixels, written another way.
#include <gtest/gtest.h>

#include "tests/raster/blend_scene.h"

namespace kinescope {
namespace {

constexpr int kWidth = 45, kHeight = 37;

/// A rectangle at one depth, drawn in a colour that tells it from the others.
struct Layer {
  PixelRect rect;
  float z;
  DepthTest test;
  bool write;
};

bool oracle_passes(DepthTest test, float z, bool has_depth, float stored) {
  switch (test) {
    case DepthTest::kNever:
      return false;
    case DepthTest::kLess:
      return !has_depth || z < stored;
    case DepthTest::kEqual:
      return has_depth && z == stored;
    case DepthTest::kLessEqual:
      return !has_depth || z <= stored;
    case DepthTest::kGreater:
      return has_depth && z > stored;
    case DepthTest::kNotEqual:
      return !has_depth || z != stored;
    case DepthTest::kGreaterEqual:
      return has_depth && z >= stored;
    case DepthTest::kAlways:
      return true;
  }
  return false;
}

/// Layers of every size class: a few pixels, tens, the whole target and beyond.
std::vector<Layer> random_layers(unsigned seed, int count) {
  RandomTriangles random(seed);
  std::vector<Layer> layers;
  for (int i = 0; i < count; ++i) {
    const int side = std::array{3, 7, 20, 60}[static_cast<std::size_t>(random.below(4))];
    const int x = random.below(kWidth + 9) - 9, y = random.below(kHeight + 9) - 9;
    layers.push_back({{x, y, x + 1 + random.below(side), y + 1 + random.below(side)},
                      static_cast<float>(random.below(5)) / 4.0f,
                      static_cast<DepthTest>(random.below(8)),
                      random.below(3) != 0});
  }
  return layers;
}

struct Pixel {
  float colour = -1;
  bool has_depth = false;
  float depth = 1;
};

Pixel oracle_pixel(const std::vector<Layer>& layers, int x, int y) {
  Pixel p;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const Layer& layer = layers[i];
    const PixelRect& r = layer.rect;
    if (x < r.x0 || x >= r.x1 || y < r.y0 || y >= r.y1) continue;
    if (!oracle_passes(layer.test, layer.z, p.has_depth, p.depth)) continue;
    p.colour = static_cast<float>(i);
    if (layer.write) {
      p.has_depth = true;
      p.depth = layer.z;
    }
  }
  return p;
}

BlendScene scene_of(const std::vector<Layer>& layers) {
  BlendScene scene;
  for (const Layer& layer : layers) {
    const LinearRgba number = {static_cast<float>(scene.calls.size()), 0, 0, 1};
    DrawCall& call = scene.add_rect(layer.rect, layer.z, number, BlendMode::kOpaque);
    call.depth_test = layer.test;
    call.depth_write = layer.write;
  }
  return scene;
}

void expect_oracle(const std::vector<Layer>& layers, int samples) {
  const BlendScene scene = scene_of(layers);
  const BlendDrawn drawn =
      draw_blended(scene.calls, kWidth, kHeight, samples, 2, {}, {-1, 0, 0, 1});
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Pixel expected = oracle_pixel(layers, x, y);
      ASSERT_EQ(drawn.colour.at(x, y).r, expected.colour) << x << ',' << y;
      ASSERT_EQ(drawn.depth.at(x, y), expected.depth) << x << ',' << y;
    }
  }
}

TEST(DepthModes, EveryModeAloneAgainstEveryOther) {
  for (int first = 0; first < 8; ++first) {
    for (int second = 0; second < 8; ++second) {
      std::vector<Layer> layers;
      for (int i = 0; i < 25; ++i) {
        const auto z = [](int n) { return static_cast<float>(n) / 4.0f; };
        const PixelRect cell = {i % 5 * 7, i / 5 * 6, i % 5 * 7 + 6, i / 5 * 6 + 5};
        // Something to be compared with, then every pair of depths.
        layers.push_back({cell, 0.5f, DepthTest::kLess, true});
        layers.push_back({cell, z(i % 5), static_cast<DepthTest>(first), true});
        layers.push_back({cell, z(i / 5), static_cast<DepthTest>(second), i % 2 == 0});
        layers.push_back({cell, 0.5f, DepthTest::kLessEqual, true});
      }
      expect_oracle(layers, 1);
    }
  }
}

TEST(DepthModes, RandomLayersInOrder) {
  for (const int samples : {1, 4, 8}) {
    for (unsigned seed = 1; seed <= 12; ++seed) expect_oracle(random_layers(seed, 60), samples);
  }
}

/// A test that fails on an empty target passes nowhere; one that passes sees even depth 1.
TEST(DepthModes, NothingLiesBehindEverything) {
  for (int test = 0; test < 8; ++test) {
    const auto mode = static_cast<DepthTest>(test);
    const std::vector<Layer> layers = {{{0, 0, kWidth, kHeight}, 1.0f, mode, true}};
    expect_oracle(layers, 1);
    const BlendScene scene = scene_of(layers);
    const bool shown = draw_blended(scene.calls, 4, 4).stats.fragments != 0;
    EXPECT_EQ(shown, mode == DepthTest::kLess || mode == DepthTest::kLessEqual ||
                         mode == DepthTest::kNotEqual || mode == DepthTest::kAlways);
  }
}

TEST(DepthModes, OnlyDepthMayBeDrawn) {
  BlendScene scene;
  // Light that adds nothing still hides.
  scene.add_rect({0, 0, 8, 8}, 0.25f, {1, 1, 1, 0}, BlendMode::kAlpha);
  scene.add_rect({0, 0, 8, 8}, 0.5f, {1, 0, 0, 1}, BlendMode::kAlpha);
  const BlendDrawn drawn = draw_blended(scene.calls, 8, 8);
  EXPECT_EQ(drawn.colour.at(3, 3), (LinearRgba{0, 0, 0, 1}));
  EXPECT_EQ(drawn.depth.at(3, 3), 0.25f);
}

TEST(DepthModes, FragmentsThatFailAreNotShaded) {
  BlendScene scene;
  scene.add_rect({0, 0, 8, 8}, 0.25f, {1, 1, 1, 1}, BlendMode::kOpaque);
  scene.add_rect({0, 0, 8, 8}, 0.5f, {1, 0, 0, 1}, BlendMode::kAlpha);
  scene.add_rect({0, 0, 4, 8}, 0.75f, {1, 0, 0, 1}, BlendMode::kAlpha, BlendOrder::kByDepth);
  EXPECT_EQ(draw_blended(scene.calls, 8, 8).stats.fragments, 64u);
}

/// Plain calls after the first that is not plain are drawn in their turn.
TEST(DepthModes, PlainCallsAfterOthersStillHideWhatLiesBehind) {
  BlendScene scene;
  scene.add_rect({0, 0, 8, 8}, 0.5f, {0.5f, 0, 0, 1}, BlendMode::kAdditive).depth_write = false;
  scene.add_rect({0, 0, 4, 8}, 0.75f, {0, 0, 1, 1}, BlendMode::kOpaque);
  scene.add_rect({0, 0, 8, 4}, 0.9f, {0, 1, 0, 1}, BlendMode::kOpaque);
  const BlendDrawn drawn = draw_blended(scene.calls, 8, 8);
  EXPECT_EQ(drawn.colour.at(1, 1), (LinearRgba{0, 0, 1, 1}));
  EXPECT_EQ(drawn.colour.at(6, 1), (LinearRgba{0, 1, 0, 1}));
  EXPECT_EQ(drawn.colour.at(6, 6), (LinearRgba{0.5f, 0, 0, 1}));
}

}  // namespace
}  // namespace kinescope
