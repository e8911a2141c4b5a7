// Scissors cut pixels, not triangles: inside nothing changes, outside nothing is drawn.
#include <gtest/gtest.h>

#include <limits>

#include "raster/reference_rasterizer.h"
#include "tests/raster/blend_scene.h"

namespace kinescope {
namespace {

constexpr int kWidth = 150, kHeight = 110;

bool contains(const PixelRect& r, int x, int y) {
  return x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1;
}

/// Draws a soup of every size class whole and within a scissor, and compares pixel by pixel.
void expect_cut(const PixelRect& scissor, int samples, bool plain, unsigned seed) {
  RandomTriangles random(seed);
  BlendScene scene;
  DrawCall& call =
      scene.add(random.soup(500, kWidth, kHeight), shade_by_number_and_pixel,
                plain ? BlendMode::kOpaque : BlendMode::kAlpha, BlendOrder::kSubmitted);
  const LinearRgba clear = {-1, 0, 0, 1};
  const BlendDrawn whole = draw_blended(scene.calls, kWidth, kHeight, samples, 2, {}, clear);
  call.scissor = scissor;
  const BlendDrawn cut = draw_blended(scene.calls, kWidth, kHeight, samples, 2, {}, clear);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = contains(scissor, x, y);
      ASSERT_EQ(cut.colour.at(x, y), inside ? whole.colour.at(x, y) : clear) << x << ',' << y;
      ASSERT_EQ(cut.depth.at(x, y), inside ? whole.depth.at(x, y) : 1.0f) << x << ',' << y;
    }
  }
  EXPECT_EQ(cut.stats.visibility_hash,
            draw_reference(kWidth, kHeight, samples, scene.calls).visibility_hash);
}

TEST(Scissor, CutsPixelsExactly) {
  const PixelRect scissors[] = {{10, 20, 90, 77}, {0, 0, 64, 32},       {63, 31, 65, 33},
                                {40, 50, 41, 51}, {149, 109, 150, 110}, {-50, 30, 1000, 31}};
  unsigned seed = 1;
  for (const int samples : {1, 4, 8}) {
    for (const PixelRect& scissor : scissors) {
      for (const bool plain : {true, false}) expect_cut(scissor, samples, plain, ++seed);
    }
  }
}

TEST(Scissor, BeyondTheTargetCutsNothing) {
  constexpr int kMost = std::numeric_limits<int>::max(), kLeast = std::numeric_limits<int>::min();
  for (const bool plain : {true, false}) {
    expect_cut({kLeast, kLeast, kMost, kMost}, 4, plain, 31);
    expect_cut({0, 0, kWidth, kHeight}, 1, plain, 32);
  }
}

TEST(Scissor, WithoutAreaNothingIsDrawn) {
  const PixelRect scissors[] = {
      {}, {10, 10, 10, 90}, {50, 50, 20, 20}, {-9, -9, 0, 0}, {kWidth, 0, kWidth + 40, kHeight}};
  for (const PixelRect& scissor : scissors) {
    for (const BlendMode mode : {BlendMode::kOpaque, BlendMode::kAlpha}) {
      BlendScene scene;
      scene.add_rect({0, 0, kWidth, kHeight}, 0.5f, {1, 1, 1, 1}, mode).scissor = scissor;
      const BlendDrawn drawn = draw_blended(scene.calls, kWidth, kHeight);
      EXPECT_EQ(drawn.stats.fragments, 0u);
      EXPECT_EQ(drawn.stats.drawn, 0u);
      EXPECT_EQ(drawn.colour, Image<LinearRgba>(kWidth, kHeight, LinearRgba{0, 0, 0, 1}));
    }
  }
}

TEST(Scissor, BelongsToItsCallOnly) {
  for (const BlendOrder order : {BlendOrder::kSubmitted, BlendOrder::kByDepth}) {
    BlendScene scene;
    scene.add_rect({0, 0, 9, 9}, 0.75f, {0, 0, 1, 1}, BlendMode::kAlpha, order).scissor =
        PixelRect{0, 0, 3, 9};
    scene.add_rect({0, 0, 9, 9}, 0.5f, {1, 0, 0, 0.5f}, BlendMode::kAlpha, order);
    const Image<LinearRgba> picture = draw_blended(scene.calls, 9, 9).colour;
    EXPECT_EQ(picture.at(2, 8), (LinearRgba{0.5f, 0, 0.5f, 1}));
    EXPECT_EQ(picture.at(3, 8), (LinearRgba{0.5f, 0, 0, 1}));
  }
}

/// Two halves of a picture, each drawn alone, are the picture.
TEST(Scissor, PartsMakeTheWhole) {
  RandomTriangles random(8);
  BlendScene whole, parts;
  const TriangleSoup soup = random.soup(700, kWidth, kHeight);
  whole.add(soup, shade_by_number_and_pixel, BlendMode::kOpaque, BlendOrder::kSubmitted);
  for (const PixelRect& part : {PixelRect{0, 0, 37, kHeight}, {37, 0, kWidth, kHeight}}) {
    parts.add(soup, shade_by_number_and_pixel, BlendMode::kOpaque, BlendOrder::kSubmitted).scissor =
        part;
  }
  EXPECT_EQ(draw_blended(parts.calls, kWidth, kHeight, 4).colour,
            draw_blended(whole.calls, kWidth, kHeight, 4).colour);
}

}  // namespace
}  // namespace kinescope
