#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <polyclipping/clipper.hpp>
#include <random>

#include "engine/clip/orientation.h"
#include "engine/clip/sutherland_hodgman.h"
#include "engine/clip/weiler_atherton.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

using Vec = glm::dvec2;
__extension__ using Int128 = __int128;

double area_of(const Region& region) {
  double sum = 0;
  for (const Contour& contour : region) sum += signed_area(contour);
  return sum;
}

ClipperLib::Paths clipper_paths(const Region& region, double scale) {
  ClipperLib::Paths paths;
  for (const Contour& contour : region) {
    ClipperLib::Path path;
    for (const Vec& p : contour)
      path << ClipperLib::IntPoint(std::llround(p.x * scale), std::llround(p.y * scale));
    paths << path;
  }
  return paths;
}

/// Clipper's answer: Vatti's algorithm in whole numbers.
double clipper_area(const Region& subject, const Region& clip, ClipperLib::ClipType kind,
                    double scale) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(clipper_paths(subject, scale), ClipperLib::ptSubject, true);
  clipper.AddPaths(clipper_paths(clip, scale), ClipperLib::ptClip, true);
  ClipperLib::Paths out;
  clipper.Execute(kind, out);
  double area = 0;
  for (const auto& path : out) area += ClipperLib::Area(path);
  return area / scale / scale;
}

/// A star-shaped polygon of random radii about a centre: simple, and seldom convex.
Contour star(std::mt19937& random, int corners, Vec centre, double radius, double step) {
  std::uniform_real_distribution<double> u(0.15, 1.0);
  Contour contour;
  for (int i = 0; i < corners; ++i) {
    const double a = 2 * std::numbers::pi * i / corners, r = radius * u(random);
    const Vec p = centre + r * Vec(std::cos(a), std::sin(a));
    contour.emplace_back(std::round(p.x / step) * step, std::round(p.y / step) * step);
  }
  return contour;
}

Contour box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

TEST(Orientation, IsExactBesideALine) {
  // Points a rounding away from the line y = x.
  const Vec a(12, 12), b(24, 24);
  EXPECT_EQ(orientation(a, b, {0.5, 0.5}), 0);
  EXPECT_EQ(orientation(a, b, {0.5, std::nextafter(0.5, 1)}), 1);
  EXPECT_EQ(orientation(a, b, {0.5, std::nextafter(0.5, 0)}), -1);
  EXPECT_EQ(orientation({0, 0}, {0.1, 0.1}, {0.3, 0.3}), 0);
  EXPECT_EQ(orientation({1e-30, 0}, {1, 1}, {1 + 1e-15, 1}), -1);
}

TEST(Orientation, AgreesWithWholeNumbersOf128Bits) {
  std::mt19937_64 random(5);
  std::uniform_int_distribution<long long> u(-(1LL << 52), 1LL << 52), near(-2, 2);
  for (int i = 0; i < 100'000; ++i) {
    const long long ax = u(random), ay = u(random), dx = u(random) / 4, dy = u(random) / 4;
    const long long k = near(random);
    const long long p[6] = {
        ax, ay, ax + dx, ay + dy, ax + k * dx + near(random) / 2, ay + k * dy + near(random) / 2};
    const Int128 det = static_cast<Int128>(p[2] - p[0]) * (p[5] - p[1]) -
                       static_cast<Int128>(p[3] - p[1]) * (p[4] - p[0]);
    const auto at = [&](int j) {
      return Vec(static_cast<double>(p[j]), static_cast<double>(p[j + 1]));
    };
    if (std::abs(p[4]) > 1LL << 53 || std::abs(p[5]) > 1LL << 53) continue;
    if (std::abs(p[2]) > 1LL << 53 || std::abs(p[3]) > 1LL << 53) continue;
    ASSERT_EQ(orientation(at(0), at(2), at(4)), det > 0 ? 1 : det < 0 ? -1 : 0);
  }
}

TEST(SutherlandHodgman, ShowsItsFourStages) {
  const Contour diamond = {{5, -3}, {13, 5}, {5, 13}, {-3, 5}};
  SutherlandHodgman clip({{0, 0}, {10, 10}}, diamond);
  EXPECT_EQ(clip.stages(), 4);
  EXPECT_EQ(clip.side(0), (Segment2{{0, 10}, {0, 0}}));
  const std::size_t corners[] = {5, 6, 7, 8};
  for (int stage = 0; stage < 4; ++stage) {
    ASSERT_TRUE(clip.next());
    EXPECT_EQ(clip.stage(), stage + 1);
    EXPECT_EQ(clip.polygon().size(), corners[stage]);
  }
  EXPECT_FALSE(clip.next());
  EXPECT_EQ(signed_area(clip.polygon()), 128 - 4 * 9);
}

TEST(SutherlandHodgman, AgreesWithClipperOnConcavePolygons) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Contour polygon = star(random, 3 + i % 20, {0, 0}, 20, 1.0 / 64);
    const std::vector<Vec> got = clip_polygon({{-7, -6}, {8, 9}}, polygon);
    for (const Vec& p : got) {
      EXPECT_TRUE(ClipWindow({{-7, -6}, {8, 9}}).contains(p));
    }
    const double want =
        clipper_area({polygon}, {box(-7, -6, 8, 9)}, ClipperLib::ctIntersection, 1e6);
    ASSERT_NEAR(std::abs(signed_area(got)), want, 1e-3);
  }
}

TEST(SutherlandHodgman, ClipsToAnyConvexPolygon) {
  std::mt19937 random(2);
  Contour hexagon;
  for (int k = 0; k < 6; ++k) {
    const double a = k * std::numbers::pi / 3;
    hexagon.emplace_back(10 * std::cos(a), 10 * std::sin(a));
  }
  for (int i = 0; i < 500; ++i) {
    const Contour polygon = star(random, 3 + i % 15, {3, -2}, 18, 1.0 / 64);
    const double want = clipper_area({polygon}, {hexagon}, ClipperLib::ctIntersection, 1e7);
    ASSERT_NEAR(signed_area(clip_polygon(hexagon, polygon)), want, 1e-4);
    const Contour turned(hexagon.rbegin(), hexagon.rend());
    ASSERT_EQ(clip_polygon(turned, polygon).empty(), want == 0);
  }
}

TEST(SutherlandHodgman, TellsWhatAClipperDoesWithEachEdge) {
  std::mt19937 random(5);
  const ClipWindow window{{-2, -1}, {3, 2}};
  int entering = 0, leaving = 0;
  for (int i = 0; i < 100; ++i) {
    const Contour subject = star(random, 3 + i % 9, {i % 5 - 2.0, 0}, 4, i % 2 ? 0.5 : 0.01);
    SutherlandHodgman clip(window, subject);
    while (clip.stage() < clip.stages()) {
      const int k = clip.stage();
      const auto inside = [&](const Vec& p) {
        return k == 0 ? p.x >= -2 : k == 1 ? p.x <= 3 : k == 2 ? p.y >= -1 : p.y <= 2;
      };
      const auto edges = clip.edges(k, clip.polygon());
      std::size_t handed_on = 0;
      for (const ClippedEdge& e : edges) {
        handed_on += static_cast<std::size_t>(e.handed_on);
        EXPECT_EQ(e.what == EdgeCase::kInside || e.what == EdgeCase::kLeaving, inside(e.from));
        EXPECT_EQ(e.what == EdgeCase::kInside || e.what == EdgeCase::kEntering, inside(e.to));
        entering += e.what == EdgeCase::kEntering;
        leaving += e.what == EdgeCase::kLeaving;
      }
      clip.next();
      EXPECT_EQ(clip.polygon().size(), handed_on < 3 ? 0 : handed_on);
    }
  }
  EXPECT_EQ(entering, leaving);
  EXPECT_GT(entering, 100);
}

TEST(SutherlandHodgman, BadInput) {
  const ClipWindow window{{0, 0}, {1, 1}};
  EXPECT_TRUE(clip_polygon(window, Contour{}).empty());
  EXPECT_TRUE(clip_polygon(window, Contour{{0.5, 0.5}}).empty());
  EXPECT_TRUE(clip_polygon(window, Contour{{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(clip_polygon(window, Contour{{0, 0}, {1, NAN}, {1, 1}}).empty());
  EXPECT_EQ(clip_polygon(window, Contour{{0, 0}, {0, 0}, {1, 1}, {1, 1}, {0, 1}}).size(), 5u);
  EXPECT_THROW(clip_polygon(Contour{{0, 0}, {4, 0}, {1, 1}, {0, 4}}, box(0, 0, 1, 1)), Error);
  EXPECT_THROW(clip_polygon(Contour{{0, 0}, {1, 1}, {2, 2}}, box(0, 0, 1, 1)), Error);
  EXPECT_THROW(clip_polygon(Contour{}, box(0, 0, 1, 1)), Error);
  Contour many;
  for (int i = 0; i < 1'000'000; ++i)
    many.emplace_back(std::cos(i * 6.28e-6), std::sin(i * 6.28e-6));
  EXPECT_NEAR(signed_area(clip_polygon(ClipWindow{{0, 0}, {2, 2}}, many)), std::numbers::pi / 4,
              1e-3);
}

TEST(WeilerAtherton, CutsAConcavePolygonIntoPieces) {
  // A comb of three teeth: Sutherland and Hodgman would join them along the window's side.
  const Contour comb = {{0, 0}, {7, 0}, {7, 5}, {6, 5}, {6, 1}, {4, 1},
                        {4, 5}, {3, 5}, {3, 1}, {1, 1}, {1, 5}, {0, 5}};
  const Region pieces = clip_weiler_atherton({comb}, {box(-1, 3, 8, 9)});
  ASSERT_EQ(pieces.size(), 3u);
  for (const Contour& piece : pieces) {
    EXPECT_EQ(piece.size(), 4u);
    EXPECT_EQ(signed_area(piece), 2);
  }
  const Region rest = clip_weiler_atherton({comb}, {box(-1, 3, 8, 9)}, Keep::kOutside);
  EXPECT_EQ(rest.size(), 1u);
  EXPECT_EQ(area_of(rest), signed_area(comb) - 6);
}

TEST(WeilerAtherton, AgreesWithClipper) {
  std::mt19937 random(4);
  for (int i = 0; i < 2000; ++i) {
    const Region a = {star(random, 3 + i % 30, {0, 0}, 20, 1.0 / 1024)};
    const Region b = {star(random, 3 + i % 23, {5, 3}, 17, 1.0 / 1024)};
    ASSERT_NEAR(area_of(clip_weiler_atherton(a, b)),
                clipper_area(a, b, ClipperLib::ctIntersection, 1e6), 2e-4);
    ASSERT_NEAR(area_of(clip_weiler_atherton(a, b, Keep::kOutside)),
                clipper_area(a, b, ClipperLib::ctDifference, 1e6), 2e-4);
  }
}

// Corners of a coarse grid: coincident corners, corners on edges and edges along edges everywhere.
TEST(WeilerAtherton, AgreesWithClipperWhereCornersCoincide) {
  std::mt19937 random(6);
  int compared = 0;
  for (int i = 0; i < 4000; ++i) {
    const Region a = {star(random, 4 + i % 7, {0, 0}, 5, 1)};
    const Region b = {star(random, 4 + i % 5, {1, 0}, 5, 1)};
    try {
      const double in = area_of(clip_weiler_atherton(a, b));
      const double out = area_of(clip_weiler_atherton(a, b, Keep::kOutside));
      ASSERT_NEAR(in + out, area_of(oriented(a)), 1e-9);
      // Rounded to the grid a star may touch itself, and then means something else to each.
      if (std::abs(area_of(oriented(a)) - clipper_area(a, {}, ClipperLib::ctUnion, 1e6)) > 1e-6 ||
          std::abs(area_of(oriented(b)) - clipper_area(b, {}, ClipperLib::ctUnion, 1e6)) > 1e-6) {
        continue;
      }
      ASSERT_NEAR(in, clipper_area(a, b, ClipperLib::ctIntersection, 1e6), 1e-4);
      ++compared;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(compared, 3000);
}

TEST(WeilerAtherton, KnowsHoles) {
  const Region ring = {box(0, 0, 10, 10), box(3, 3, 7, 7)};
  EXPECT_EQ(area_of(clip_weiler_atherton(ring, {box(5, -1, 20, 11)})), 50 - 8);
  EXPECT_EQ(area_of(clip_weiler_atherton(ring, {box(4, 4, 6, 6)})), 0);
  EXPECT_EQ(area_of(clip_weiler_atherton(ring, {box(-1, -1, 11, 11)})), 84);
  EXPECT_EQ(area_of(clip_weiler_atherton({box(-1, -1, 11, 11)}, ring)), 84);
  EXPECT_EQ(area_of(clip_weiler_atherton({box(1, 1, 2, 2)}, ring, Keep::kOutside)), 0);
  // A hole made by clipping: the outer contour and a clockwise one.
  const Region outside =
      clip_weiler_atherton({box(0, 0, 10, 10)}, {box(2, 2, 4, 4)}, Keep::kOutside);
  ASSERT_EQ(outside.size(), 2u);
  EXPECT_EQ(area_of(outside), 96);
  EXPECT_LT(signed_area(outside[1]), 0);
}

TEST(WeilerAtherton, TheSamePolygonTwice) {
  std::mt19937 random(9);
  for (int i = 3; i < 40; ++i) {
    const Region a = {star(random, i, {1, 2}, 9, 1.0 / 256)};
    EXPECT_NEAR(area_of(clip_weiler_atherton(a, a)), area_of(a), 1e-9);
    EXPECT_NEAR(area_of(clip_weiler_atherton(a, a, Keep::kOutside)), 0, 1e-9);
  }
}

TEST(WeilerAtherton, StepsEndWhereTheFunctionEnds) {
  WeilerAtherton clip({box(0, 0, 4, 4)}, {box(2, 2, 6, 6)});
  EXPECT_EQ(clip.crossings().crossings.size(), 2u);
  int steps = 0;
  while (clip.next()) ASSERT_LT(++steps, 20);
  ASSERT_EQ(clip.pieces.size(), 1u);
  EXPECT_EQ(signed_area(clip.pieces[0]), 4);
}

TEST(WeilerAtherton, BadInput) {
  EXPECT_TRUE(clip_weiler_atherton({}, {}).empty());
  EXPECT_TRUE(clip_weiler_atherton({{}}, {{{1, 1}}}).empty());
  EXPECT_TRUE(clip_weiler_atherton({{{0, 0}, {1, 1}}}, {box(0, 0, 1, 1)}).empty());
  EXPECT_TRUE(clip_weiler_atherton({box(0, 0, 1, 1)}, {}).empty());
  EXPECT_EQ(clip_weiler_atherton({box(0, 0, 1, 1)}, {}, Keep::kOutside).size(), 1u);
  EXPECT_THROW(clip_weiler_atherton({{{0, 0}, {NAN, 1}, {1, 1}}}, {box(0, 0, 1, 1)}), Error);
  // Bow ties and random scribbles end, with an answer or an error.
  std::mt19937 random(8);
  std::uniform_int_distribution<int> u(0, 9);
  for (int i = 0; i < 3000; ++i) {
    Region a(1), b(1);
    for (int k = 0; k < 3 + i % 9; ++k) a[0].emplace_back(u(random), u(random));
    for (int k = 0; k < 3 + i % 7; ++k) b[0].emplace_back(u(random), u(random));
    try {
      WeilerAtherton clip(a, b);
      int steps = 0;
      while (clip.next()) ASSERT_LT(++steps, 10'000);
    } catch (const Error&) {
    }
  }
}

}  // namespace
}  // namespace kinescope
