// Which pixels a triangle owns, drawn in ASCII so that a failure is a picture.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "raster/rasterizer.h"
#include "tests/raster/triangle_soup.h"

namespace kinescope {
namespace {

/// Draws in a float target and gives each pixel a letter: '.' for nothing, 'a' for triangle 0, ...
std::string picture(const TriangleSoup& soup, int width, int height,
                    CullMode cull = CullMode::kNone) {
  Workers workers(1);
  Rasterizer rasterizer(workers);
  RenderTarget target(width, height, 1, ColourFormat::kLinearFloat);
  target.clear.r = -1;
  const DrawCall call = soup.call(shade_primitive, cull);
  rasterizer.draw(target, {&call, 1});
  std::string out = "\n";
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float id = std::get<Image<LinearRgba>>(target.colour).at(x, y).r;
      out += id < 0 ? '.' : static_cast<char>('a' + static_cast<int>(id));
    }
    out += '\n';
  }
  return out;
}

TEST(Triangle, OwnsPixelCentresOnItsTopAndLeftEdgesOnly) {
  TriangleSoup soup;
  // A square cut from corner to corner, all corners upon pixel centres.
  soup.add({1.5f, 1.5f}, {1.5f, 4.5f}, {4.5f, 4.5f});
  soup.add({1.5f, 1.5f}, {4.5f, 4.5f}, {4.5f, 1.5f});
  EXPECT_EQ(picture(soup, 6, 6), R"(
......
.bbb..
.abb..
.aab..
......
......
)");
}

TEST(Triangle, PointUpAndPointDown) {
  TriangleSoup up;
  up.add({4, 0.5f}, {0.5f, 4}, {7.5f, 4});
  EXPECT_EQ(picture(up, 8, 5), R"(
........
...aa...
..aaaa..
.aaaaaa.
........
)");
  TriangleSoup down;
  down.add({0.5f, 0.5f}, {4, 4}, {7.5f, 0.5f});
  EXPECT_EQ(picture(down, 8, 5), R"(
aaaaaaa.
.aaaaa..
..aaa...
...a....
........
)");
}

TEST(Triangle, FanAroundAPixelCentreCoversItOnce) {
  TriangleSoup fan;
  constexpr int kBlades = 7;
  for (int i = 0; i < kBlades; ++i) {
    const auto rim = [&](int k) {
      const double a = 2 * std::numbers::pi * k / kBlades;
      return TestVertex{static_cast<float>(4.5 + 3.3 * std::cos(a)),
                        static_cast<float>(4.5 + 3.3 * std::sin(a))};
    };
    fan.add({4.5f, 4.5f}, rim(i), rim((i + 1) % kBlades));
  }
  const std::string drawn = picture(fan, 9, 9);
  EXPECT_NE(drawn[1 + 4 * 10 + 4], '.');
}

TEST(Triangle, SnapsToThe256thOfAPixel) {
  TriangleSoup soup;
  // The left edge lies 0.4 of a 256th right of the centre: snapped, it lies upon it.
  const float left = 1.5f + 0.4f / 256;
  soup.add({left, 0}, {left, 4}, {4, 2});
  EXPECT_EQ(picture(soup, 4, 4), "\n.a..\n.aa.\n.aa.\n.a..\n");
  TriangleSoup beyond;
  const float right = 1.5f + 0.6f / 256;
  beyond.add({right, 0}, {right, 4}, {4, 2});
  EXPECT_EQ(picture(beyond, 4, 4), "\n....\n..a.\n..a.\n....\n");
}

TEST(Triangle, FrontFacesRunCounterClockwiseOnTheScreen) {
  TriangleSoup soup;
  soup.add({0, 0}, {0, 2}, {2, 2});  // down, then right: counter-clockwise as seen
  EXPECT_EQ(picture(soup, 2, 2, CullMode::kBack), "\n..\na.\n");
  EXPECT_EQ(picture(soup, 2, 2, CullMode::kNone), "\n..\na.\n");
  EXPECT_EQ(picture(soup, 2, 2, CullMode::kFront), "\n..\n..\n");
  TriangleSoup turned;
  turned.add({0, 0}, {2, 2}, {0, 2});
  EXPECT_EQ(picture(turned, 2, 2, CullMode::kBack), "\n..\n..\n");
  EXPECT_EQ(picture(turned, 2, 2, CullMode::kFront), "\n..\na.\n");
}

// The same rules hold for triangles too large for the small path.
TEST(Triangle, LargeTrianglesFollowTheSameRules) {
  TriangleSoup soup;
  const float far = 30000;
  soup.add({2.5f, -far}, {2.5f, far}, {far, 0});
  EXPECT_EQ(picture(soup, 4, 2), "\n..aa\n..aa\n");
  EXPECT_EQ(picture(soup, 4, 2, CullMode::kFront), "\n....\n....\n");
  TriangleSoup left;
  left.add({2.5f, -far}, {-far, 0}, {2.5f, far});
  EXPECT_EQ(picture(left, 4, 2), "\naa..\naa..\n");
}

TEST(Triangle, WithoutAreaCoversNothing) {
  TriangleSoup soup;
  soup.add({1.5f, 1.5f}, {1.5f, 1.5f}, {1.5f, 1.5f});
  soup.add({0, 0.5f}, {4, 0.5f}, {2, 0.5f});
  soup.add({0.5f, 0}, {2.5f, 2}, {3.5f, 3});
  soup.add({-30000, -30000}, {0, 0}, {30000, 30000});
  EXPECT_EQ(picture(soup, 4, 2), "\n....\n....\n");
}

TEST(Triangle, WithAnImpossibleVertexIsDropped) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, inf, -inf, 32769.0f, -32769.0f, 3e38f}) {
    for (int corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 2; ++axis) {
        TestVertex v[3] = {{0, 0}, {0, 4}, {4, 4}};
        (axis == 0 ? v[corner].x : v[corner].y) = bad;
        TriangleSoup soup;
        soup.add(v[0], v[1], v[2]);
        EXPECT_EQ(picture(soup, 2, 2), "\n..\n..\n") << bad;
      }
      if (std::isfinite(bad)) continue;
      TestVertex v[3] = {{0, 0}, {0, 4}, {4, 4}};
      v[corner].z = bad;
      TriangleSoup soup;
      soup.add(v[0], v[1], v[2]);
      EXPECT_EQ(picture(soup, 2, 2), "\n..\n..\n") << bad;
    }
  }
}

TEST(Triangle, UpToTheGuardBandIsDrawn) {
  const float g = DeviceVertex::kGuardBand;
  TriangleSoup soup;
  soup.add({-g, -g}, {-g, g}, {g, g});
  soup.add({-g, -g}, {g, g}, {g, -g});
  EXPECT_EQ(picture(soup, 3, 3), "\nbbb\nabb\naab\n");
}

}  // namespace
}  // namespace kinescope
