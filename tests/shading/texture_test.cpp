// The mipmap chain against its definition: each texel is the mean over the area that it covers.
#include "shading/texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/shading/batch_arrays.h"

namespace kinescope {
namespace {

/// How much of [i, i + 1) of `from` cells lies in [j, j + 1) of `to` equal cells over the same
/// line.
double overlap(int i, int from, int j, int to) {
  const double ratio = static_cast<double>(from) / to;
  return std::max(0.0, std::min(i + 1.0, (j + 1) * ratio) - std::max<double>(i, j * ratio));
}

/// The mean of a channel over the area of texel (x, y) of a picture of width x height.
double mean(const Image<Texel>& from, int width, int height, int x, int y,
            std::uint16_t Texel::*channel) {
  double sum = 0, area = 0;
  for (int j = 0; j < from.height(); ++j) {
    for (int i = 0; i < from.width(); ++i) {
      const double part = overlap(i, from.width(), x, width) * overlap(j, from.height(), y, height);
      sum += part * from.at(i, j).*channel;
      area += part;
    }
  }
  return sum / area;
}

TEST(Texture, LevelsHalveDownToOneTexel) {
  struct Case {
    int width, height, levels;
  };
  for (const Case& c : {Case{1, 1, 1}, Case{2, 1, 2}, Case{1, 5, 3}, Case{3, 3, 2}, Case{4, 4, 3},
                        Case{17, 5, 5}, Case{256, 1, 9}, Case{255, 256, 9}}) {
    const Texture texture(Image<Linear8>(c.width, c.height));
    ASSERT_EQ(texture.levels(), c.levels) << c.width << "x" << c.height;
    for (int i = 0; i < c.levels; ++i) {
      EXPECT_EQ(texture.level(i).width(), std::max(1, c.width >> i));
      EXPECT_EQ(texture.level(i).height(), std::max(1, c.height >> i));
    }
  }
}

TEST(Texture, EachLevelIsTheAreaMeanOfTheOneAbove) {
  Random random(1);
  for (const auto& [width, height] : {std::pair{8, 8}, {7, 7}, {13, 6}, {1, 9}, {5, 1}, {31, 33}}) {
    const Texture texture(noise<Linear8>(random, width, height));
    for (int level = 1; level < texture.levels(); ++level) {
      const Image<Texel> above = texture.level(level - 1), here = texture.level(level);
      for (int y = 0; y < here.height(); ++y) {
        for (int x = 0; x < here.width(); ++x) {
          for (const auto channel : {&Texel::r, &Texel::g, &Texel::b, &Texel::a}) {
            EXPECT_NEAR(here.at(x, y).*channel,
                        mean(above, here.width(), here.height(), x, y, channel), 0.5 + 1e-6);
          }
        }
      }
    }
  }
}

TEST(Texture, TheLastTexelIsTheMeanOfThePicture) {
  Random random(2);
  for (const auto& [width, height] : {std::pair{64, 64}, {37, 53}, {100, 3}}) {
    const Texture texture(noise<Linear8>(random, width, height));
    const Image<Texel> picture = texture.level(0);
    const Texel last = texture.level(texture.levels() - 1).at(0, 0);
    // Each level rounds by at most a half.
    EXPECT_NEAR(last.r, mean(picture, 1, 1, 0, 0, &Texel::r), 0.5 * texture.levels());
    EXPECT_NEAR(last.a, mean(picture, 1, 1, 0, 0, &Texel::a), 0.5 * texture.levels());
  }
}

TEST(Texture, AveragesLightNotCode) {
  Image<Srgb8> picture(2, 1);
  picture.at(0, 0) = {0, 0, 0, 255};
  picture.at(1, 0) = {255, 255, 255, 255};
  const Texel grey = Texture(picture).level(1).at(0, 0);
  EXPECT_EQ(grey.r, 32768);  // half the light of white, code 188, not 128
  EXPECT_EQ(grey.a, 65535);
}

TEST(Texture, DecodesTheSrgbCurve) {
  Image<Srgb8> picture(256, 1);
  for (int i = 0; i < 256; ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    picture.at(i, 0) = {byte, byte, byte, byte};
  }
  const Image<Texel> level = Texture(picture).level(0);
  for (int i = 0; i < 256; ++i) {
    const double code = i / 255.0;
    const double light = code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(level.at(i, 0).g, 65535 * light, 0.6) << i;
    EXPECT_EQ(level.at(i, 0).a, 257 * i);
  }
}

TEST(Texture, LinearValuesAreKept) {
  const Texture texture(Image<Linear8>(1, 1, Linear8{0, 1, 128, 255}));
  EXPECT_EQ(texture.level(0).at(0, 0), (Texel{0, 257, 128 * 257, 65535}));
}

TEST(Texture, KnowsWhetherItHasAlpha) {
  Image<Srgb8> picture(5, 3);
  EXPECT_FALSE(Texture(picture).has_alpha());
  picture.at(4, 2).a = 254;
  EXPECT_TRUE(Texture(picture).has_alpha());
}

TEST(Texture, LevelsArePaddedByTheirOwnFirstRowAndColumn) {
  Random random(3);
  const Texture texture(noise<Linear8>(random, 11, 6));
  for (int i = 0; i < texture.levels(); ++i) {
    const Texture::Level level = texture.view(i);
    for (int y = 0; y <= level.height(); ++y) {
      for (int x = 0; x <= level.width(); ++x) {
        EXPECT_EQ(level.row(y)[x], texture.level(i).at(x % level.width(), y % level.height()));
      }
    }
  }
}

TEST(Texture, CopiesAndMovesKeepTheirTexels) {
  Random random(4);
  Texture texture(noise<Linear8>(random, 9, 9));
  const Image<Texel> second = texture.level(1);
  const Texture copy = texture;
  const Texture moved = std::move(texture);
  EXPECT_EQ(copy.level(1), second);
  EXPECT_EQ(moved.level(1), second);
}

TEST(Texture, AnEmptyPictureIsWhite) {
  for (const Texture& texture : {Texture(), Texture(Image<Srgb8>()), Texture(Image<Srgb8>(0, 5))}) {
    EXPECT_EQ(texture.levels(), 0);
    EXPECT_EQ(texture.sample(0.3f, 0.4f, 1), (LinearRgba{1, 1, 1, 1}));
    EXPECT_FALSE(texture.has_alpha());
  }
}

}  // namespace
}  // namespace kinescope
