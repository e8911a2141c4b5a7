#include "shading/procedural_texture.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace kinescope {
namespace {

TEST(LabelledCheckerboard, CellsAlternateAndCornersDiffer) {
  const Image<Srgb8> picture = labelled_checkerboard();
  ASSERT_EQ(picture.width(), 1024);
  ASSERT_EQ(picture.height(), 1024);
  // Cells of 64 pixels.
  EXPECT_EQ(picture.at(256, 256), picture.at(319, 319));
  EXPECT_NE(picture.at(319, 256), picture.at(320, 256));
  EXPECT_EQ(picture.at(256, 256), picture.at(320, 320));
  EXPECT_EQ(picture.at(320, 256), picture.at(256, 320));
  std::set<std::tuple<int, int, int>> corners;
  for (const int x : {0, 1023}) {
    for (const int y : {0, 1023}) {
      const Srgb8 c = picture.at(x, y);
      corners.emplace(c.r, c.g, c.b);
    }
  }
  EXPECT_EQ(corners.size(), 4u);
  EXPECT_GT(picture.at(0, 0).r, 200);
  EXPECT_LT(picture.at(0, 0).g, 60);
}

TEST(LabelledCheckerboard, AnySizeIsFilled) {
  const Image<Srgb8> picture = labelled_checkerboard(37, 5, 4);
  for (const Srgb8& p : picture.pixels()) EXPECT_EQ(p.a, 255);
  EXPECT_EQ(labelled_checkerboard(1, 1, 4).at(0, 0), labelled_checkerboard(1024, 1024, 4).at(0, 0));
}

}  // namespace
}  // namespace kinescope
