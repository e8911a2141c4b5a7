// Ellipses and general conics against whole-number definitions and points of the curve.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "raster/base/error.h"
#include "raster/scan/arc.h"
#include "raster/scan/conic_scan.h"
#include "raster/scan/conic_tracer.h"
#include "raster/scan/dda_ellipse.h"
#include "raster/scan/midpoint_ellipse.h"
#include "tests/raster/ascii.h"
#include "tests/raster/pixel_set.h"

namespace kinescope {
namespace {

using testing::AsciiCanvas;
using testing::PixelSet;

constexpr PixelRect kWindow{-60, -60, 60, 60};

/// s^2 (b^2 x^2 + a^2 y^2 - a^2 b^2) of coordinates s times as large.
std::int64_t scaled_f(std::int64_t a, std::int64_t b, std::int64_t s, std::int64_t x,
                      std::int64_t y) {
  return b * b * x * x + a * a * y * y - s * s * a * a * b * b;
}

/// Whether the curve crosses the pixel's column or row within h quarters of a pixel of its centre.
bool near_ellipse(std::int64_t a, std::int64_t b, std::int64_t x, std::int64_t y, std::int64_t h) {
  const auto f = [&](std::int64_t u, std::int64_t v) { return scaled_f(a, b, 4, u, v); };
  const bool column = (4 * y - h < 0 || f(4 * x, 4 * y - h) <= 0) && f(4 * x, 4 * y + h) >= 0;
  const bool row = (4 * x - h < 0 || f(4 * x - h, 4 * y) <= 0) && f(4 * x + h, 4 * y) >= 0;
  return column || row;
}

TEST(ScanEllipse, MidpointPixelsAreNearestInColumnOrRow) {
  for (int a = 0; a <= 40; ++a) {
    for (int b = 0; b <= 40; ++b) {
      PixelSet quadrant;
      int further = 0;
      for (MidpointEllipse e({a, b}); e.next();) {
        const std::int64_t x = e.at().x, y = e.at().y;
        quadrant(e.at().x, e.at().y);
        if (near_ellipse(a, b, x, y, 2)) continue;
        // Where the regions meet one pixel may lie further off, or where a tip turns within one.
        ++further;
        const bool sharp = b * b < a || a * a < b;
        ASSERT_TRUE(near_ellipse(a, b, x, y, sharp ? 6 : 3))
            << a << ' ' << b << ": " << x << ' ' << y;
      }
      ASSERT_LE(further, 1) << a << ' ' << b;
      ASSERT_EQ(quadrant.order().front(), std::pair(0, b));
      ASSERT_EQ(quadrant.order().back(), std::pair(a, 0));
      ASSERT_TRUE(quadrant.is_chain(false)) << a << ' ' << b;
      ASSERT_EQ(quadrant.twice(), 0);
      PixelSet whole;
      midpoint_ellipse({-7, 2}, {a, b}, whole);
      ASSERT_EQ(whole.twice(), 0) << a << ' ' << b;
    }
  }
}

// Stepped, the decision variable stays what its definition says, at the largest radii too.
TEST(ScanEllipse, DecisionIsTheMidpointsValue) {
  for (const glm::ivec2 radii : {glm::ivec2(8, 6), {6, 8}, {30, 4}, {1, 9}, {200, 199}}) {
    const std::int64_t a = radii.x, b = radii.y;
    MidpointEllipse e(radii);
    while (e.next() && e.at().y > 0) {
      const std::int64_t x = e.at().x, y = e.at().y;
      const std::int64_t expected = e.steep() ? scaled_f(a, b, 2, 2 * x + 1, 2 * y - 2)
                                              : scaled_f(a, b, 2, 2 * x + 2, 2 * y - 1);
      ASSERT_EQ(e.decision(), expected) << a << ' ' << b << ": " << x << ' ' << y;
    }
  }
  constexpr int kLargest = kLargestRadius;
  glm::ivec2 last{0};
  for (MidpointEllipse e({kLargest, kLargest}); e.next();) last = e.at();
  EXPECT_EQ(last, glm::ivec2(kLargest, 0));
}

TEST(ScanEllipse, TextbooksEightBySix) {
  PixelSet quadrant;
  for (MidpointEllipse e({8, 6}); e.next();) quadrant(e.at().x, e.at().y);
  EXPECT_EQ(
      quadrant.order(),
      (std::vector<std::pair<int, int>>{
          {0, 6}, {1, 6}, {2, 6}, {3, 6}, {4, 5}, {5, 5}, {6, 4}, {7, 3}, {8, 2}, {8, 1}, {8, 0}}));
}

TEST(ScanEllipse, DdaStaysBesideTheCurveAndCloses) {
  for (int a = 0; a <= 60; a += 6) {
    for (int b = 0; b <= 60; b += 7) {
      PixelSet pixels;
      dda_ellipse({0, 0}, {a, b}, pixels);
      ASSERT_TRUE(pixels.is_chain(true)) << a << ' ' << b;
      for (const auto& [x, y] : pixels.set()) {
        double nearest = 1e9;
        for (int i = 0; i < 1000; ++i) {
          const double t = i * 2 * std::numbers::pi / 1000;
          nearest = std::min(nearest, std::hypot(x - a * std::cos(t), y - b * std::sin(t)));
        }
        ASSERT_LE(nearest, 0.97) << a << ' ' << b << ": " << x << ' ' << y;
      }
    }
  }
}

TEST(ScanEllipse, BadRadii) {
  const auto fail = [](int, int) { FAIL(); };
  midpoint_ellipse({0, 0}, {-1, 5}, fail);
  midpoint_ellipse({0, 0}, {5, -1}, fail);
  dda_ellipse({0, 0}, {-3, 2}, fail);
  ellipse_arc({0, 0}, {5, -1}, 0, 9, fail);
  EXPECT_THROW(midpoint_ellipse({0, 0}, {1 << 30, 5}, fail), Error);
  EXPECT_THROW(dda_ellipse({0, 0}, {5, 1 << 30}, fail), Error);
}

TEST(ScanEllipse, ArcsAreTheSectorsPixels) {
  PixelSet upper, whole;
  midpoint_ellipse({0, 0}, {20, 9}, whole);
  ellipse_arc({0, 0}, {20, 9}, 0, std::numbers::pi, upper);
  for (const auto& [x, y] : whole.set()) EXPECT_EQ(upper.set().count({x, y}), y >= 0 ? 1u : 0u);
}

TEST(ScanConic, KindsAndGradients) {
  EXPECT_EQ((Conic{1, 0, 1, 0, 0, -25}.kind()), ConicKind::kCircle);
  EXPECT_EQ((Conic{1, 1, 1, 0, 0, -25}.kind()), ConicKind::kEllipse);
  EXPECT_EQ((Conic{1, 2, 1, 3, 0, -25}.kind()), ConicKind::kParabola);
  EXPECT_EQ((Conic{0, 1, 0, 0, 0, -25}.kind()), ConicKind::kHyperbola);
  EXPECT_EQ((Conic{0, 0, 0, 2, 3, -25}.kind()), ConicKind::kLine);
  const Conic k{2, 3, 5, 7, 11, 13};
  EXPECT_EQ(k(2, -1), 8 - 6 + 5 + 14 - 11 + 13);
  EXPECT_EQ(k.gradient(2, -1), glm::dvec2(2 * 2 * 2 - 3 + 7, 3 * 2 - 10 + 11));
  EXPECT_EQ(k.discriminant(), 9 - 40);
}

TEST(ScanConic, CircleIsTheMidpointCircle) {
  for (int r = 1; r < 60; ++r) {
    PixelSet circle, scan, traced;
    midpoint_circle({0, 0}, r, circle);
    const Conic conic{1, 0, 1, 0, 0, -double(r) * r};
    conic_scan(conic, kWindow, scan);
    trace_conic(conic, kWindow, {r, 0}, traced);
    ASSERT_EQ(scan.set(), circle.set()) << r;
    ASSERT_EQ(scan.twice(), 0) << r;
    ASSERT_EQ(traced.set(), circle.set()) << r;
    ASSERT_EQ(traced.twice(), 0) << r;
    ASSERT_TRUE(traced.is_chain(true)) << r;
  }
}

/// Pixels lie within half a pixel of the curve along an axis, and the curve within a pixel of them.
template <typename Curve>
void expect_along(const Conic& conic, Curve&& curve, double from, double to) {
  PixelSet scan;
  conic_scan(conic, kWindow, scan);
  EXPECT_EQ(scan.twice(), 0);
  ASSERT_FALSE(scan.set().empty());
  std::vector<glm::dvec2> points;
  constexpr int kPoints = 40000;
  for (int i = 0; i <= kPoints; ++i) points.push_back(curve(from + (to - from) * i / kPoints));
  for (const auto& [x, y] : scan.set()) {
    double nearest = 1e9;
    for (const glm::dvec2 p : points) nearest = std::min(nearest, std::hypot(p.x - x, p.y - y));
    EXPECT_LE(nearest, 0.51) << x << ' ' << y;
  }
  for (const glm::dvec2 p : points) {
    if (std::max(std::abs(p.x), std::abs(p.y)) > 58) continue;
    const int x = static_cast<int>(std::floor(p.x + 0.5)),
              y = static_cast<int>(std::floor(p.y + 0.5));
    bool near = false;
    for (int k = 0; k < 9; ++k) near |= scan.set().count({x + k % 3 - 1, y + k / 3 - 1}) > 0;
    EXPECT_TRUE(near) << p.x << ' ' << p.y;
  }
}

glm::dvec2 turned(glm::dvec2 p, double angle) {
  return {p.x * std::cos(angle) - p.y * std::sin(angle),
          p.x * std::sin(angle) + p.y * std::cos(angle)};
}

TEST(ScanConic, EllipsesParabolasAndHyperbolasTurned) {
  for (const double angle : {0.0, 0.4, std::numbers::pi / 2, 2.2}) {
    const glm::dvec2 at{3.25, -8.5};
    expect_along(
        Conic::ellipse(at, {40, 13}, angle),
        [&](double t) {
          return at + turned({40 * std::cos(t), 13 * std::sin(t)}, angle);
        },
        0, 2 * std::numbers::pi);
    expect_along(
        Conic::parabola(at, 3, angle),
        [&](double t) {
          return at + turned({t * t / 12, t}, angle);
        },
        -60, 60);
    expect_along(
        Conic::hyperbola(at, {9, 6}, angle),
        [&](double t) {
          const double side = t < 0 ? -1 : 1, u = std::abs(t) - 4;
          return at + turned({side * 9 * std::cosh(u), 6 * std::sinh(u)}, angle);
        },
        -8, 8);
  }
}

TEST(ScanConic, TracerFollowsOneBranchBothWays) {
  for (const double angle : {0.0, 0.4, 1.1, 2.2}) {
    for (const Conic& conic :
         {Conic::ellipse({1.5, 2.25}, {40, 23}, angle), Conic::parabola({-2, 3}, 6, angle),
          Conic::hyperbola({0.25, 1}, {12, 14}, angle)}) {
      PixelSet scan, traced;
      conic_scan(conic, kWindow, scan);
      const glm::ivec2 start{scan.order().front().first, scan.order().front().second};
      for (const bool backwards : {false, true}) {
        ConicTracer tracer(conic, kWindow, start, backwards);
        while (tracer.next()) traced(tracer.at().x, tracer.at().y);
        EXPECT_EQ(tracer.closed(), conic.kind() == ConicKind::kEllipse);
      }
      for (const auto& [x, y] : traced.set()) {
        // Half a pixel along an axis, where octants meet a little more.
        const glm::dvec2 g = conic.gradient(x, y);
        EXPECT_LE(std::abs(conic(x, y)), 0.56 * std::max(std::abs(g.x), std::abs(g.y)) + 1)
            << x << ' ' << y << " angle " << angle;
      }
      if (conic.kind() == ConicKind::kHyperbola) continue;  // the scan has both branches
      for (const auto& [x, y] : scan.set()) {
        bool near = false;
        for (int k = 0; k < 9; ++k) near |= traced.set().count({x + k % 3 - 1, y + k / 3 - 1}) > 0;
        EXPECT_TRUE(near) << x << ' ' << y << " angle " << angle;
      }
    }
  }
}

TEST(ScanConic, DegenerateAndBadOnes) {
  const auto fail = [](int, int) { FAIL(); };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  conic_scan({kNan, 0, 1, 0, 0, 1}, kWindow, fail);
  conic_scan({1, kInfinity, 1, 0, 0, 1}, kWindow, fail);
  conic_scan({1, 0, 1, 0, 0, 5}, kWindow, fail);  // x^2 + y^2 = -5
  conic_scan({0, 0, 0, 0, 0, 0}, kWindow, fail);  // everywhere, which is no curve
  conic_scan({1, 0, 1, 0, 0, -4}, {}, fail);      // no window
  conic_scan({1, 0, 1, 0, 0, -4}, {0, 0, std::numeric_limits<int>::max(), 4}, fail);
  PixelSet line, lines;
  conic_scan({0, 0, 0, 1, -2, 0}, {0, 0, 8, 8}, line);  // x = 2y
  EXPECT_EQ(line.set().size(), 8u);
  conic_scan({1, 0, -1, 0, 0, 0}, {-4, -4, 5, 5}, lines);  // x = y and x = -y
  EXPECT_EQ(lines.set().size(), 17u);
  EXPECT_EQ(lines.twice(), 0);
  int steps = 0;
  trace_conic({0, 0, 0, 0, 0, 0}, kWindow, {0, 0}, [&](int, int) { ++steps; });
  EXPECT_LE(steps, 1);
}

// The textbook's: df/dx = 2ax + by + d, df/dy = bx + 2cy + e; the sign of b^2 - 4ac tells the kind.
TEST(Conic, GradientAndKinds) {
  const Conic q{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(q.gradient(0.5, -2), glm::dvec2(2 * 0.5 + 2 * -2 + 4, 2 * 0.5 + 6 * -2 + 5));
  EXPECT_NEAR((q(0.5 + 1e-5, -2) - q(0.5 - 1e-5, -2)) / 2e-5, q.gradient(0.5, -2).x, 1e-8);
  const auto kind = [](const Conic& c) { return c.kind(); };
  EXPECT_EQ(kind({1, 0, 1, 0, 0, -4}), ConicKind::kCircle);
  EXPECT_EQ(kind({1, 0, 2, 0, 0, -4}), ConicKind::kEllipse);
  EXPECT_EQ(kind({1, 1, 1, 0, 0, -4}), ConicKind::kEllipse);
  EXPECT_EQ(kind({1, 2, 1, 3, 0, -4}), ConicKind::kParabola);
  EXPECT_EQ(kind({0, 1, 0, 0, 0, -4}), ConicKind::kHyperbola);
  EXPECT_EQ(kind({0, 0, 0, 1, 0, -4}), ConicKind::kLine);
  EXPECT_EQ(kind({0, 0, 0, 0, 0, -4}), ConicKind::kNone);
}

}  // namespace
}  // namespace kinescope
