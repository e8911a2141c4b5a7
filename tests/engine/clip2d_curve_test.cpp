#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/clip/clip_curve.h"
#include "engine/clip/clip_text.h"
#include "engine/clip/outcode.h"
#include "engine/curves/bezier.h"

namespace kinescope {
namespace {

using Vec = glm::dvec2;

/// Whether a sampled curve is inside just where the parts say, but for a sliver at their ends.
template <typename Point>
void expect_parts(const ClipWindow& window, const std::vector<CurvePart>& parts, double end,
                  Point&& point) {
  constexpr int kSamples = 2000;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = end * i / kSamples;
    bool kept = false, near = false;
    for (const CurvePart& part : parts) {
      for (const double u : {t, t + end}) {
        kept |= u >= part.from && u <= part.to;
        near |= std::abs(u - part.from) < 1e-9 || std::abs(u - part.to) < 1e-9;
      }
    }
    const Vec p = point(t);
    if (near) continue;
    // A curve that runs along a side is there to rounding only.
    const ClipWindow wide{window.min - 1e-12, window.max + 1e-12};
    const ClipWindow narrow{window.min + 1e-12, window.max - 1e-12};
    if (wide.contains(p) != narrow.contains(p)) continue;
    ASSERT_EQ(kept, window.contains(p)) << t;
  }
}

TEST(Clip2D, EllipsesBySampling) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-6, 6), r(0.1, 8);
  const ClipWindow window{{-3, -2}, {4, 3}};
  for (int i = 0; i < 300; ++i) {
    ClippedEllipse e;
    e.centre = {u(random), u(random)};
    e.radii = {r(random), r(random)};
    const auto parts = clip_ellipse(window, e);
    for (const CurvePart& part : parts) EXPECT_LT(part.from, part.to);
    expect_parts(window, parts, 2 * std::numbers::pi,
                 [&](double a) { return e.centre + e.radii * Vec(std::cos(a), std::sin(a)); });
  }
}

TEST(Clip2D, EllipsesAtTheEdges) {
  const ClipWindow window{{-1, -1}, {1, 1}};
  // Touches all four sides from inside: whole.
  ASSERT_EQ(clip_ellipse(window, {}).size(), 1u);
  EXPECT_NEAR(clip_ellipse(window, {})[0].to - clip_ellipse(window, {})[0].from,
              2 * std::numbers::pi, 1e-15);
  EXPECT_EQ(clip_ellipse(window, {{0, 0}, {1.2, 1.2}}).size(), 4u);
  EXPECT_TRUE(clip_ellipse(window, {{0, 0}, {2, 2}}).empty());
  EXPECT_TRUE(clip_ellipse(window, {{0, 0}, {-1, 1}}).empty());
  EXPECT_TRUE(clip_ellipse(window, {{0, 0}, {0, 1}}).empty());
  EXPECT_TRUE(clip_ellipse(window, {{NAN, 0}, {1, 1}}).empty());
  EXPECT_TRUE(clip_ellipse(window, {{0, 0}, {INFINITY, 1}}).empty());
}

TEST(Clip2D, StretchesKeptAreThoseThatThePartsHold) {
  constexpr double kPeriod = 10;
  const std::vector<CurvePart> parts = {{1, 2}, {2.5, 6.25}, {9, 10.5}};  // the last goes round
  double kept = 0;
  for (int i = 0; i < 20; ++i) {
    double last = 0.5 * i;
    for_each_kept(parts, {0.5 * i, 0.5 * (i + 1)}, kPeriod, [&](const CurvePart& part) {
      EXPECT_GE(part.from, last);
      EXPECT_LE(part.to, 0.5 * (i + 1));
      const double t = 0.5 * (part.from + part.to);
      EXPECT_TRUE(t < 0.5 || (t > 1 && t < 2) || (t > 2.5 && t < 6.25) || t > 9) << t;
      kept += part.to - part.from;
      last = part.to;
    });
  }
  EXPECT_NEAR(kept, 1 + 3.75 + 1.5, 1e-12);
}

TEST(Clip2D, ABoxTellsOfWhatIsInIt) {
  const ClipWindow window{{0, 0}, {4, 4}};
  const auto place = [&](Vec low, Vec high) { return place_of_box(window, {low, high}); };
  EXPECT_EQ(place({0, 0}, {4, 4}), BoxPlace::kInside);
  EXPECT_EQ(place({1, 1}, {2, 5}), BoxPlace::kAcross);
  EXPECT_EQ(place({-2, 1}, {-0.5, 2}), BoxPlace::kBeyondSide);
  EXPECT_EQ(place({1, 4.5}, {9, 6}), BoxPlace::kBeyondSide);
  EXPECT_EQ(place({-2, -3}, {-1, 9}), BoxPlace::kBeyondSide);
  EXPECT_EQ(place({-2, -3}, {9, 9}), BoxPlace::kAcross);
}

TEST(Clip2D, BezierCurvesBySampling) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> u(-9, 9);
  const ClipWindow window{{-3, -2}, {4, 3}};
  int cut = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<Vec> control(static_cast<std::size_t>(2 + i % 5));
    for (Vec& p : control) p = {u(random), u(random)};
    const auto parts = clip_bezier(window, control);
    cut += static_cast<int>(parts.size());
    expect_parts(window, parts, 1.0,
                 [&](double t) { return bezier_point(std::span<const Vec>(control), t); });
  }
  EXPECT_GT(cut, 100);
}

TEST(Clip2D, BezierCurvesAtTheEdges) {
  const ClipWindow window{{0, 0}, {4, 4}};
  const auto clip = [&](std::vector<Vec> control) { return clip_bezier(window, control); };
  ASSERT_EQ(clip({{-4, 4}, {8, 4}}).size(), 1u);  // along a side
  EXPECT_NEAR(clip({{-4, 4}, {8, 4}})[0].from, 1.0 / 3, 1e-12);
  EXPECT_NEAR(clip({{-4, 4}, {8, 4}})[0].to, 2.0 / 3, 1e-12);
  EXPECT_TRUE(clip({}).empty());
  EXPECT_TRUE(clip({{NAN, 1}, {2, 2}}).empty());
  ASSERT_EQ(clip({{1, 1}}).size(), 1u);
  EXPECT_TRUE(clip({{1, 5}, {2, 9}, {3, 5}}).empty());
  // Touches the top side from outside at t = 1/2.
  const auto touching = clip({{0, 8}, {2, 0}, {4, 8}});
  EXPECT_LE(touching.size(), 1u);
}

PlacedGlyph letter(double x) {
  PlacedGlyph glyph{{{x, 0}, {x + 2, 3}}, {}, {}};
  glyph.outlines = {{{x, 0}, {x + 2, 0}, {x + 2, 3}, {x, 3}},
                    {{x + 0.5, 1}, {x + 0.5, 2}, {x + 1.5, 2}, {x + 1.5, 1}}};
  glyph.strokes = {{{x, 0}, {x + 2, 3}}};
  return glyph;
}

std::vector<PlacedGlyph> clipped(const ClipWindow& window, TextClipping way) {
  const std::vector<PlacedGlyph> string = {letter(0), letter(3), letter(6)};
  std::vector<PlacedGlyph> kept;
  clip_text(window, string, way, [&](const PlacedGlyph& glyph) { kept.push_back(glyph); });
  return kept;
}

TEST(ClipText, AllOrNoneOfTheString) {
  EXPECT_EQ(clipped({{0, 0}, {8, 3}}, TextClipping::kWholeString).size(), 3u);
  EXPECT_EQ(clipped({{0, 0}, {7.9, 3}}, TextClipping::kWholeString).size(), 0u);
}

TEST(ClipText, AllOrNoneOfEachCharacter) {
  EXPECT_EQ(clipped({{1, 0}, {8, 3}}, TextClipping::kWholeCharacters).size(), 2u);
  EXPECT_EQ(clipped({{1, 0}, {7, 3}}, TextClipping::kWholeCharacters)[0].cell.min.x, 3);
}

TEST(ClipText, ByComponent) {
  const auto kept = clipped({{1, 0}, {6.25, 3}}, TextClipping::kComponents);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(signed_area(kept[0].outlines[0]), 3);
  EXPECT_EQ(signed_area(kept[0].outlines[1]), -0.5);
  EXPECT_EQ(kept[0].strokes[0], (Segment2{{1, 1.5}, {2, 3}}));
  EXPECT_EQ(kept[1].outlines[0].size(), 4u);
  EXPECT_EQ(kept[2].outlines.size(), 1u);  // its counter lies outside
  EXPECT_EQ(clipped({{2.2, 0}, {2.8, 3}}, TextClipping::kComponents).size(), 0u);
}

}  // namespace
}  // namespace kinescope
