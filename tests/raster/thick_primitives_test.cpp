// Lines and points as triangles: continuous, closed at joints, as wide as they were asked to be.
#include "raster/thick_primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "raster/rasterizer.h"

namespace kinescope {
namespace {

void shade_one(const Batch& batch, LinearRgba* out) {
  std::fill_n(out, batch.size, LinearRgba{1, 1, 1, 1});
}

class Sheet {
 public:
  Sheet(int width, int height)
      : workers_(1), rasterizer_(workers_), target_(width, height, 1, ColourFormat::kLinearFloat) {}

  void draw(const ThickPrimitives& lines, ShadeFunction shade = shade_one) {
    const DrawCall call = lines.draw_call(shade);
    rasterizer_.draw(target_, {&call, 1});
  }
  const LinearRgba& at(int x, int y) const {
    return std::get<Image<LinearRgba>>(target_.colour).at(x, y);
  }
  bool lit(int x, int y) const {
    return x >= 0 && y >= 0 && x < target_.width && y < target_.height && at(x, y).r > 0;
  }
  int count() const {
    int n = 0;
    for (int y = 0; y < target_.height; ++y) {
      for (int x = 0; x < target_.width; ++x) n += lit(x, y);
    }
    return n;
  }
  std::string picture() const {
    std::string out = "\n";
    for (int y = 0; y < target_.height; ++y) {
      for (int x = 0; x < target_.width; ++x) out += lit(x, y) ? '#' : '.';
      out += '\n';
    }
    return out;
  }

 private:
  Workers workers_;
  Rasterizer rasterizer_;
  RenderTarget target_;
};

TEST(ThickPrimitives, LevelAndUprightLinesAreExactlyAsWideAsAsked) {
  ThickPrimitives lines;
  lines.add_line({2.5f, 1.5f}, {5.5f, 1.5f}, 1);
  lines.add_line({8.5f, 1.5f}, {8.5f, 4.5f}, 1);
  lines.add_line({2, 4}, {5, 4}, 2);
  Sheet sheet(11, 7);
  sheet.draw(lines);
  EXPECT_EQ(sheet.picture(), R"(
...........
..####..#..
........#..
.#####..#..
.#####..#..
...........
...........
)");
}

/// At one sample every column (or row, if steep) between the ends has a pixel, and neighbours
/// touch.
TEST(ThickPrimitives, LinesOfOnePixelAreContinuousInEveryDirection) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(3, 117);
  Sheet sheet(120, 120);
  for (int i = 0; i < 400; ++i) {
    DeviceVertex a{place(random), place(random)}, b{place(random), place(random)};
    if (i % 4 == 0) b.y_px = a.y_px + (b.x_px - a.x_px) * 1e-3f * static_cast<float>(i % 9);
    if (i % 4 == 1) b.x_px = a.x_px + 0.004f;
    ThickPrimitives lines;
    lines.add_line(a, b, i % 2 == 0 ? 1.0f : 0.0f);
    sheet.draw(lines);
    const bool steep = std::abs(b.y_px - a.y_px) > std::abs(b.x_px - a.x_px);
    const float lo = steep ? std::min(a.y_px, b.y_px) : std::min(a.x_px, b.x_px);
    const float hi = steep ? std::max(a.y_px, b.y_px) : std::max(a.x_px, b.x_px);
    int last = -1;
    for (int k = static_cast<int>(std::ceil(lo - 0.5f)); k <= std::floor(hi - 0.5f); ++k) {
      int found = -1;
      for (int m = 0; m < 120 && found < 0; ++m) {
        const bool on = steep ? sheet.lit(m, k) : sheet.lit(k, m);
        if (on && (last < 0 || std::abs(m - last) <= 2)) found = m;
      }
      ASSERT_GE(found, 0) << "line " << i << " broken at " << k;
      last = found;
    }
  }
}

TEST(ThickPrimitives, JointsAreClosedAtAnyAngle) {
  Sheet sheet(60, 60);
  for (int degrees = 5; degrees < 360; degrees += 5) {
    const double t = degrees * std::numbers::pi / 180;
    const DeviceVertex joint{30.3f, 29.8f};
    ThickPrimitives lines;
    lines.add_line({4, 30}, joint, 8);
    lines.add_line(
        joint,
        {static_cast<float>(30 + 24 * std::cos(t)), static_cast<float>(30 + 24 * std::sin(t))}, 8);
    sheet.draw(lines);
    // A disc as wide as the lines lies whole within their joint.
    for (int y = 26; y < 34; ++y) {
      for (int x = 26; x < 35; ++x) {
        if (std::hypot(x + 0.5 - 30.3, y + 0.5 - 29.8) < 3.9) {
          ASSERT_TRUE(sheet.lit(x, y)) << degrees << " degrees at " << x << "," << y;
        }
      }
    }
  }
}

TEST(ThickPrimitives, PointsAreSquares) {
  ThickPrimitives points;
  points.add_point({2.5f, 2.5f}, 3);
  points.add_point({7.2f, 2.7f}, 1);
  points.add_point({9.9f, 3.1f}, 0);
  points.add_line({6.5f, 5.5f}, {6.5f, 5.5f}, 1);  // no length: a point
  Sheet sheet(12, 7);
  sheet.draw(points);
  EXPECT_EQ(sheet.picture(), R"(
............
.###........
.###...#....
.###.....#..
............
......#.....
............
)");
}

void show_attribute(const Batch& batch, LinearRgba* out) {
  for (int i = 0; i < batch.size; ++i) {
    out[i] = {batch.attribute[0][i], static_cast<float>(batch.primitive[i]), 0, 1};
  }
}

TEST(ThickPrimitives, CarryAttributesDepthAndTheirNumber) {
  ThickPrimitives lines(1);
  const float one[] = {1}, two[] = {2}, nine[] = {9};
  lines.add_line({0.5f, 2.5f, 0.5f}, {20.5f, 2.5f, 0.5f}, 3, one, two);
  lines.add_point({10.5f, 2.5f, 0.2f}, 1, nine);
  lines.add_point({15.5f, 2.5f, 0.8f}, 1, nine);
  Sheet sheet(21, 5);
  sheet.draw(lines, show_attribute);
  EXPECT_NEAR(sheet.at(5, 2).r, 1.26, 0.05);
  EXPECT_EQ(sheet.at(5, 2).g, 0.0f);
  EXPECT_EQ(sheet.at(10, 2).r, 9.0f);  // nearer than the line
  EXPECT_EQ(sheet.at(10, 2).g, 1.0f);
  EXPECT_EQ(sheet.at(15, 2).g, 0.0f);  // behind it
}

TEST(ThickPrimitives, ImpossibleEndsDrawNothingAndFarOnesReachTheEdge) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  ThickPrimitives lines;
  for (const float bad : {nan, inf, -inf, 40000.0f}) {
    lines.add_line({bad, 2}, {4, 4}, 1);
    lines.add_line({2, 2}, {4, bad}, 1);
    lines.add_point({2, bad}, 3);
  }
  Sheet sheet(16, 8);
  sheet.draw(lines);
  EXPECT_EQ(sheet.count(), 0);
  lines.clear();
  lines.add_line({-32768, 3.5f}, {32768, 3.5f}, 1);
  sheet.draw(lines);
  EXPECT_EQ(sheet.count(), 16);
}

}  // namespace
}  // namespace kinescope
