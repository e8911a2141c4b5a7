// Characters laid on a picture: the same as blending pixel by pixel, whatever the ground.
#include "raster/path/glyph_painter.h"

#include <gtest/gtest.h>

#include <random>

#include "raster/base/direct_cache.h"
#include "raster/image/draw.h"

namespace kinescope {
namespace {

constexpr int kWidth = 21, kHeight = 9;  // of the glyph

/// Nothing, parts, and runs long and short that are covered wholly.
std::vector<std::uint8_t> some_coverage(std::mt19937& random) {
  std::vector<std::uint8_t> pixels(kWidth * kHeight);
  for (std::size_t i = 0; i < pixels.size();) {
    const std::uint8_t kind = random() % 3;
    for (auto left = 1 + random() % 12; left > 0 && i < pixels.size(); --left) {
      pixels[i++] = kind == 0 ? 0 : kind == 1 ? 255 : static_cast<std::uint8_t>(random() % 256);
    }
  }
  return pixels;
}

TEST(GlyphPainter, BlendsEachPixelOnAnyGround) {
  std::mt19937 random(3);
  GlyphPainter painter;
  const std::array grounds = {Srgb8{255, 255, 255, 255}, Srgb8{0, 0, 0, 0}, Srgb8{30, 60, 90, 200}};
  const std::array inks = {Srgb8{0, 0, 0, 255}, Srgb8{200, 30, 90, 255}, Srgb8{9, 240, 60, 80},
                           Srgb8{1, 2, 3, 0}};
  for (int round = 0; round < 300; ++round) {
    const int left = static_cast<int>(random() % 5) - 2, top = static_cast<int>(random() % 5) - 4;
    const std::vector<std::uint8_t> pixels = some_coverage(random);
    const GlyphCoverage glyph(left, top, kWidth, pixels);
    Image<Srgb8> ours(30, 20, grounds[random() % grounds.size()]);
    if (round % 3 == 0) {  // another ground here and there
      for (int i = 0; i < 60; ++i) {
        ours.at(static_cast<int>(random() % 30), static_cast<int>(random() % 20)) =
            grounds[random() % grounds.size()];
      }
    }
    Image<Srgb8> plain = ours;
    const Srgb8 ink = inks[random() % inks.size()];
    const int pen = static_cast<int>(random() % 50) - 25;
    const int baseline = static_cast<int>(random() % 40) - 10;
    GlyphPainter::ask_ahead(ours, glyph, pen, baseline);
    painter.draw(ours, glyph, pen, baseline, ink);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const int px = pen + left + x, py = baseline + top + y;
        if (!plain.contains(px, py)) continue;
        const auto c = pixels[static_cast<std::size_t>(y * kWidth + x)];
        blend(plain.at(px, py), decode(ink), static_cast<float>(c) / 255);
      }
    }
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 30; ++x) ASSERT_EQ(ours.at(x, y), plain.at(x, y)) << round;
    }
  }
}

TEST(GlyphPainter, ACharacterWithoutPixelsDrawsNothing) {
  GlyphPainter painter;
  Image<Srgb8> picture(4, 4, {1, 2, 3, 255});
  painter.draw(picture, GlyphCoverage(), 1, 1, {255, 255, 255, 255});
  painter.draw(picture, GlyphCoverage(0, 0, 2, {0, 0, 0, 0}), 1, 1, {255, 255, 255, 255});
  for (const Srgb8 p : picture.pixels()) EXPECT_EQ(p, (Srgb8{1, 2, 3, 255}));
}

TEST(DirectCache, MakesAValueAgainOnlyWhenAnotherTookItsPlace) {
  DirectCache<int, 2> cache;
  int made = 0;
  const auto get = [&](std::uint64_t key) {
    return cache.get(key, [&] {
      ++made;
      return static_cast<int>(10 * key);
    });
  };
  EXPECT_EQ(get(7), 70);
  EXPECT_EQ(get(7), 70);
  EXPECT_EQ(made, 1);
  for (std::uint64_t key = 0; key < 20; ++key) EXPECT_EQ(get(key), static_cast<int>(10 * key));
  EXPECT_EQ(get(7), 70);
  EXPECT_GT(made, 20);
}

}  // namespace
}  // namespace kinescope
