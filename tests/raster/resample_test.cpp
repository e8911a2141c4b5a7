#include "raster/image/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

Image<Srgb8> noise(int width, int height) {
  Image<Srgb8> picture(width, height);
  unsigned n = 1;
  for (Srgb8& p : picture.pixels()) {
    n = n * 1664525u + 1013904223u;
    p = {static_cast<std::uint8_t>(n >> 24), static_cast<std::uint8_t>(n >> 16),
         static_cast<std::uint8_t>(n >> 8), 255};
  }
  return picture;
}

TEST(DarkestOfBlocks, KeepsThinLinesAndLeavesOutPartsOfBlocks) {
  Image<Srgb8> paper(8, 7, {255, 255, 255, 255});
  for (int y = 0; y < 7; ++y) paper.at(4, y) = {60, 50, 40, 255};
  paper.at(1, 6) = {0, 0, 0, 255};  // in no whole block
  const Image<Srgb8> small = darkest_of_blocks(paper, 3);
  ASSERT_EQ(small.width(), 2);
  ASSERT_EQ(small.height(), 2);
  for (int y = 0; y < 2; ++y) {
    EXPECT_EQ(small.at(0, y), (Srgb8{255, 255, 255, 255}));
    EXPECT_EQ(small.at(1, y), (Srgb8{60, 50, 40, 255}));
  }
}

TEST(Mitchell, IsTheCubicOfThePaper) {
  // Mitchell and Netravali 1988, equation 8 with B = C = 1/3.
  EXPECT_NEAR(mitchell(0), 8.0 / 9, 1e-12);
  EXPECT_NEAR(mitchell(1), 1.0 / 18, 1e-12);
  EXPECT_NEAR(mitchell(-1.5), -5.0 / 144, 1e-12);
  EXPECT_EQ(mitchell(2), 0);
  for (double x = 0; x < 1; x += 0.125) {
    EXPECT_NEAR(mitchell(x) + mitchell(x - 1) + mitchell(x + 1) + mitchell(x - 2), 1, 1e-12);
  }
}

TEST(Resampler, SameSizeIsTheSamePicture) {
  Workers workers(2);
  const Image<Srgb8> picture = noise(17, 9);
  EXPECT_EQ(Resampler(17, 9, 17, 9)(picture, workers), picture);
}

TEST(Resampler, OneColourStaysOneColour) {
  Workers workers(2);
  const Image<Srgb8> picture(20, 13, {200, 30, 77, 255});
  for (const auto& [width, height] : {std::pair(7, 31), std::pair(640, 480), std::pair(1, 1)}) {
    Resampler resample(20, 13, width, height);
    for (const Srgb8 p : resample(picture, workers).pixels()) {
      ASSERT_EQ(p, (Srgb8{200, 30, 77, 255}));
    }
  }
}

TEST(Resampler, FinePatternsBecomeTheMeanOfTheirLight) {
  Workers workers(2);
  Image<Srgb8> stripes(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) stripes.at(x, y) = x % 2 ? Srgb8{255, 255, 255, 255} : Srgb8{};
  }
  Resampler resample(64, 64, 16, 16);
  const Image<Srgb8>& small = resample(stripes, workers);
  for (int x = 2; x < 14; ++x) EXPECT_NEAR(small.at(x, 8).r, 188, 1);  // half of white's light
}

TEST(Resampler, EachPixelIsTheWeightedSumOfItsNeighbours) {
  Workers workers(1);
  const Image<Srgb8> picture = noise(9, 1);
  Resampler resample(9, 1, 21, 1);
  const Image<Srgb8>& wide = resample(picture, workers);
  for (int x = 0; x < 21; ++x) {
    const double centre = (x + 0.5) * 9 / 21 - 0.5;
    double sum = 0, weights = 0;
    for (int k = 0; k < 9; ++k) {
      weights += mitchell(k - centre);
      sum += mitchell(k - centre) * decode(picture.at(k, 0)).g;
    }
    const auto expected = encode_srgb8(LinearRgb{0, static_cast<float>(sum / weights), 0});
    EXPECT_NEAR(wide.at(x, 0).g, expected.g, 1) << x;
  }
}

TEST(Resampler, TheTransparentIsBlack) {
  Workers workers(1);
  const Image<Srgb8> picture(4, 4, {255, 255, 255, 0});
  Resampler resample(4, 4, 8, 8);
  for (const Srgb8 p : resample(picture, workers).pixels()) EXPECT_EQ(p, Srgb8{});
}

}  // namespace
}  // namespace kinescope
