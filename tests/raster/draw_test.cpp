#include "raster/image/draw.h"

#include <gtest/gtest.h>

#include <limits>

namespace kinescope {
namespace {

constexpr Srgb8 kBlack{0, 0, 0, 255}, kWhite{255, 255, 255, 255}, kHalfWhite{255, 255, 255, 128};
// Half of white's light, 128/255 of it, by the sRGB curve.
constexpr Srgb8 kHalfLight{188, 188, 188, 255};

std::string shape(const Image<Srgb8>& picture) {
  std::string all;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const Srgb8 p = picture.at(x, y);
      all += p == kBlack ? '.' : p == kWhite ? '#' : p == kHalfLight ? '+' : '?';
    }
    all += '\n';
  }
  return all;
}

TEST(Draw, BlendsInLinearLight) {
  Srgb8 p = kBlack;
  blend(p, decode(kHalfWhite));
  EXPECT_EQ(p, kHalfLight);
  p = kBlack;
  blend(p, decode(kWhite), 0.5f);
  EXPECT_EQ(p, kHalfLight);
  p = Srgb8{10, 20, 30, 255};
  blend(p, decode(kWhite), 0);
  EXPECT_EQ(p, (Srgb8{10, 20, 30, 255}));
  blend(p, decode(Srgb8{1, 2, 3, 255}));
  EXPECT_EQ(p, (Srgb8{1, 2, 3, 255}));
  blend(p, decode(kWhite), std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(p, (Srgb8{1, 2, 3, 255}));
}

TEST(Draw, BlendsOverTransparency) {
  Srgb8 p{0, 0, 0, 0};
  blend(p, decode(Srgb8{200, 100, 50, 255}), 0.25f);
  EXPECT_EQ(p, (Srgb8{200, 100, 50, 64}));
  blend(p, decode(Srgb8{200, 100, 50, 255}), 0.5f);
  EXPECT_EQ(p.a, 160);  // 64 + (255 - 64) / 2, rounded
  EXPECT_EQ(p.r, 200);
}

TEST(Draw, ClipsRectangles) {
  EXPECT_EQ(clipped({2, 3, 4, 5}, 10, 10), (PictureRect{2, 3, 4, 5}));
  EXPECT_EQ(clipped({-2, -3, 4, 5}, 10, 10), (PictureRect{0, 0, 2, 2}));
  EXPECT_EQ(clipped({8, 9, 4, 5}, 10, 10), (PictureRect{8, 9, 2, 1}));
  EXPECT_EQ(clipped({10, 0, 4, 5}, 10, 10), PictureRect{});
  EXPECT_EQ(clipped({-9, 0, 4, 5}, 10, 10), PictureRect{});
  EXPECT_EQ(clipped({3, 3, -2, 5}, 10, 10), PictureRect{});
  constexpr int kMost = std::numeric_limits<int>::max();
  EXPECT_EQ(clipped({5, 5, kMost, kMost}, 10, 10), (PictureRect{5, 5, 5, 5}));
  EXPECT_EQ(clipped({-kMost, -kMost, kMost, kMost}, 10, 10), PictureRect{});
}

TEST(Draw, FillsAndFramesWithoutBlendingTwice) {
  Image<Srgb8> picture(9, 7, kBlack);
  frame_rect(picture, {1, 1, 7, 5}, kHalfWhite, 2);
  EXPECT_EQ(shape(picture),
            ".........\n"
            ".+++++++.\n"
            ".+++++++.\n"
            ".++...++.\n"
            ".+++++++.\n"
            ".+++++++.\n"
            ".........\n");
  picture = Image<Srgb8>(5, 4, kBlack);
  fill_rect(picture, {-3, 2, 6, 9}, kWhite);
  frame_rect(picture, {3, -1, 4, 3}, kHalfWhite);
  EXPECT_EQ(shape(picture),
            "...+.\n"
            "...++\n"
            "###..\n"
            "###..\n");
  picture = Image<Srgb8>(4, 3, kBlack);
  frame_rect(picture, {0, 0, 4, 3}, kHalfWhite, 2);  // thicker than there is room for
  EXPECT_EQ(shape(picture), "++++\n++++\n++++\n");
}

TEST(Draw, LinesAreClippedToThePicture) {
  Image<Srgb8> picture(6, 4, kBlack);
  draw_line(picture, -100, 2, 100, 2, kHalfWhite);
  draw_line(picture, 1, 0, 1, 1, kWhite);
  draw_line(picture, 5, -9, 5, -1, kWhite);
  EXPECT_EQ(shape(picture),
            ".#....\n"
            ".#....\n"
            "++++++\n"
            "......\n");
}

TEST(Draw, BlitCopiesAndBlends) {
  Image<Srgb8> source(3, 2, kWhite);
  source.at(1, 0) = Srgb8{7, 7, 7, 0};
  source.at(2, 0) = kHalfWhite;
  Image<Srgb8> picture(5, 4, kBlack);
  blit(picture, 3, 2, source);
  blit(picture, -1, -1, source);
  blit(picture, 9, 9, source);
  blit(picture, 0, 2, source);
  EXPECT_EQ(shape(picture),
            "##...\n"
            ".....\n"
            "#.+#.\n"
            "#####\n");
}

}  // namespace
}  // namespace kinescope
