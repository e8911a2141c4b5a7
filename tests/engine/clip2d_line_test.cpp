#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "engine/clip/cohen_sutherland.h"
#include "engine/clip/liang_barsky.h"
#include "engine/clip/midpoint_subdivision.h"

namespace kinescope {
namespace {

using Vec = glm::dvec2;
using Clip = std::optional<Segment2>;

Clip by_midpoint(const ClipWindow& window, const Segment2& line) {
  return clip_midpoint_subdivision(window, line);
}

constexpr std::array kClippers = {clip_cohen_sutherland, clip_liang_barsky, by_midpoint};

TEST(Clip2D, RegionCodesAsPrinted) {
  const ClipWindow window{{-1, -1}, {1, 1}};
  const int codes[3][3] = {
      {0b1001, 0b1000, 0b1010}, {0b0001, 0b0000, 0b0010}, {0b0101, 0b0100, 0b0110}};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      EXPECT_EQ(outcode(window, Vec(2 * column - 2, 2 - 2 * row)), codes[row][column]);
    }
  }
  EXPECT_EQ(outcode(window, {1, -1}), 0);  // a corner of the window is inside
}

TEST(Clip2D, PointsInside) {
  const std::array<Vec, 5> points = {Vec(0, 0), {1, 1}, {1.001, 0}, {NAN, 0}, {0, -2}};
  std::vector<Vec> kept;
  clip_points({{-1, -1}, {1, 1}}, points, [&](const Vec& p) { kept.push_back(p); });
  EXPECT_EQ(kept, (std::vector<Vec>{{0, 0}, {1, 1}}));
}

/// A fraction of whole numbers.
struct Fraction {
  long long over, under;  // under > 0
  bool operator<(const Fraction& o) const { return over * o.under < o.over * under; }
};

struct Exact {
  Fraction enter{0, 1}, leave{1, 1};
  bool inside = true, touches = false;
};

/// By definition, in whole numbers: each side's inequality along the line.
Exact exact_clip(int side, const std::array<int, 4>& line) {
  Exact e;
  const int d[2] = {line[2] - line[0], line[3] - line[1]};
  for (int axis = 0; axis < 2; ++axis) {
    for (const int sign : {-1, 1}) {
      const long long p = sign * d[axis], q = side - sign * line[static_cast<std::size_t>(axis)];
      if (p == 0 && q < 0) e.inside = false;
      if (p == 0) continue;
      const Fraction at = p > 0 ? Fraction{q, p} : Fraction{-q, -p};
      if (p < 0 && e.enter < at) e.enter = at;
      if (p > 0 && at < e.leave) e.leave = at;
    }
  }
  if (e.leave < e.enter) e.inside = false;
  e.touches = !(e.leave < e.enter) && !(e.enter < e.leave);
  return e;
}

TEST(Clip2D, EveryClipperAgreesWithExactFractions) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> u(-25, 25);
  int kept = 0, touching = 0;
  for (int i = 0; i < 200'000; ++i) {
    const std::array<int, 4> line = {u(random), u(random), u(random), u(random)};
    const Vec a(line[0], line[1]), d(line[2] - line[0], line[3] - line[1]);
    const Exact want = exact_clip(10, line);
    kept += want.inside;
    // A line that only touches a corner is at the mercy of rounding.
    if (want.inside && want.touches && d != Vec(0, 0)) {
      ++touching;
      continue;
    }
    for (const auto& clip : kClippers) {
      const Clip got = clip({{-10, -10}, {10, 10}}, {a, a + d});
      ASSERT_EQ(got.has_value(), want.inside) << a.x << ' ' << a.y << ' ' << d.x << ' ' << d.y;
      if (!got) continue;
      const auto at = [&](const Fraction& f) {
        return a + d * (static_cast<double>(f.over) / static_cast<double>(f.under));
      };
      const Vec from = at(want.enter) - got->from, to = at(want.leave) - got->to;
      ASSERT_LE(std::max({std::abs(from.x), std::abs(from.y), std::abs(to.x), std::abs(to.y)}),
                2e-13);
    }
  }
  EXPECT_GT(kept, 50'000);
  EXPECT_LT(touching, kept / 20);
}

TEST(Clip2D, SidesAreInside) {
  const ClipWindow window{{0, 0}, {4, 3}};
  for (const auto& clip : kClippers) {
    EXPECT_EQ(clip(window, {{0, 3}, {4, 3}}), (Segment2{{0, 3}, {4, 3}}));
    EXPECT_EQ(clip(window, {{-2, 3}, {9, 3}}), (Segment2{{0, 3}, {4, 3}}));
    EXPECT_EQ(clip(window, {{4, 3}, {4, 3}}), (Segment2{{4, 3}, {4, 3}}));  // no length
    EXPECT_EQ(clip(window, {{2, -2}, {2, 8}}), (Segment2{{2, 0}, {2, 3}}));
    EXPECT_FALSE(clip(window, {{5, 5}, {5, 5}}));
    EXPECT_FALSE(clip(window, {{-1, 4}, {5, 4}}));
  }
}

TEST(Clip2D, BadInputIsDropped) {
  const ClipWindow window{{-1, -1}, {1, 1}};
  const ClipWindow turned{{1, 1}, {-1, -1}}, nowhere{{NAN, 0}, {1, 1}};
  for (const auto& clip : kClippers) {
    EXPECT_FALSE(clip(window, {{NAN, 0}, {0, 0}}));
    EXPECT_FALSE(clip(window, {{0, 0}, {0, INFINITY}}));
    EXPECT_FALSE(clip(turned, {{-3, 0}, {3, 0.5}}));
    clip(nowhere, {{-3, 0}, {3, 0.5}});  // whatever it is, it ends
    const double huge = std::numeric_limits<double>::max();
    clip(window, {{-huge, -huge}, {huge, huge}});
    clip(window, {{-huge, huge}, {huge, -1}});
  }
}

TEST(CohenSutherland, ShowsItsSteps) {
  CohenSutherland clip({{0, 0}, {10, 10}}, {{-5, -5}, {20, 15}});
  EXPECT_EQ(clip.from_code, kOutBelow | kOutLeft);
  EXPECT_EQ(clip.to_code, kOutAbove | kOutRight);
  EXPECT_TRUE(clip.next());
  EXPECT_EQ(clip.side, kOutBelow);
  EXPECT_TRUE(clip.moved_from);
  EXPECT_EQ(clip.segment.from, Vec(1.25, 0));
  EXPECT_EQ(clip.from_code, 0);
  EXPECT_TRUE(clip.next());
  EXPECT_EQ(clip.side, kOutAbove);
  EXPECT_FALSE(clip.moved_from);
  EXPECT_EQ(clip.segment.to, Vec(13.75, 10));
  EXPECT_EQ(clip.to_code, kOutRight);
  EXPECT_TRUE(clip.next());
  EXPECT_EQ(clip.segment.to, Vec(10, 7));
  EXPECT_EQ(clip.state, ClipState::kRunning);
  EXPECT_FALSE(clip.next());
  EXPECT_EQ(clip.state, ClipState::kAccepted);
}

TEST(LiangBarsky, ShowsItsParameters) {
  LiangBarsky clip({{0, 0}, {10, 10}}, {{-5, -5}, {20, 15}});
  EXPECT_TRUE(clip.next());
  EXPECT_EQ(clip.p, -25);
  EXPECT_EQ(clip.q, -5);
  EXPECT_EQ(clip.enter, 0.2);
  EXPECT_TRUE(clip.next());
  EXPECT_EQ(clip.leave, 0.6);
  EXPECT_TRUE(clip.next());
  EXPECT_EQ(clip.enter, 0.25);
  EXPECT_TRUE(clip.next());
  EXPECT_EQ(clip.side, 3);
  EXPECT_FALSE(clip.next());
  EXPECT_EQ(clip.segment(), (Segment2{{1.25, 0}, {10, 7}}));
}

TEST(MidpointSubdivision, StopsAtAPixel) {
  MidpointSubdivision clip({{0, 0}, {64, 64}}, {{-100, 20}, {200, 30}}, 1.0);
  while (clip.next()) EXPECT_LE(clip.halvings, 20);
  ASSERT_EQ(clip.state, ClipState::kAccepted);
  EXPECT_NEAR(clip.segment.from.x, 0, 1.5);
  EXPECT_NEAR(clip.segment.to.x, 64, 1.5);
  EXPECT_GE(clip.halvings, 16);  // two ends, 2^8 pixels
}

}  // namespace
}  // namespace kinescope
