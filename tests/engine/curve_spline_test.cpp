#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "engine/curves/b_spline.h"
#include "engine/curves/bezier.h"
#include "engine/curves/continuity.h"
#include "engine/curves/convex_hull.h"
#include "engine/curves/interpolating.h"
#include "engine/curves/nurbs.h"
#include "raster/base/error.h"
#include "tests/engine/random_points.h"

namespace kinescope {
namespace {

using Vec = glm::dvec2;
using Points = std::vector<Vec>;

void expect_near(const Vec& a, const Vec& b, double tolerance = 1e-12) {
  EXPECT_LE(glm::distance(a, b), tolerance) << a.x << ' ' << a.y << " is not " << b.x << ' ' << b.y;
}

Continuity worst_joint(const std::vector<CubicPiece<Vec>>& pieces) {
  return weakest_joint(std::span<const CubicPiece<Vec>>(pieces));
}

TEST(Interpolating, PassesThroughEveryPointAsSmoothlyAsItSays) {
  std::mt19937 random(1);
  for (std::size_t n = 2; n < 12; ++n) {
    const Points p = random_points(random, n), slopes = random_points(random, n);
    const auto hermite = hermite_pieces<Vec>(p, slopes), rom = catmull_rom_pieces<Vec>(p),
               natural = natural_cubic_pieces<Vec>(p);
    for (const auto& pieces : {hermite, rom, natural}) {
      ASSERT_EQ(pieces.size(), n - 1);
      for (std::size_t i = 0; i + 1 < n; ++i) {
        EXPECT_EQ(pieces[i].front(), p[i]);
        EXPECT_EQ(pieces[i].back(), p[i + 1]);
      }
    }
    if (n < 3) continue;
    EXPECT_EQ(worst_joint(hermite), Continuity::kC1);
    EXPECT_EQ(worst_joint(rom),
              n == 3 ? Continuity::kC2 : Continuity::kC1);  // by chance of the ends
    EXPECT_EQ(worst_joint(natural), Continuity::kC2);
    expect_near(bezier_end(std::span<const Vec>(natural.front()), false).second, {0, 0}, 1e-10);
    expect_near(bezier_end(std::span<const Vec>(natural.back()), true).second, {0, 0}, 1e-10);
  }
}

TEST(Interpolating, PiecesAgreeWithTheWeights) {
  std::mt19937 random(2);
  const Points p = random_points(random, 4), m = random_points(random, 2);
  for (const double tension : {0.0, 0.5, 1.0}) {
    const CubicPiece<Vec> middle = catmull_rom_pieces<Vec>(p, tension)[1];
    for (double t = 0; t <= 1; t += 0.125) {
      expect_near(bezier_point(std::span<const Vec>(middle), t),
                  blend(catmull_rom_weights(t, tension), p[0], p[1], p[2], p[3]));
    }
  }
  const auto piece = bezier_from_hermite(p[0], p[1], m[0], m[1]);
  expect_near(bezier_point(std::span<const Vec>(piece), 0.3),
              blend(hermite_weights(0.3), p[0], p[1], m[0], m[1]));
}

TEST(Interpolating, LocalAgainstGlobalControl) {
  std::mt19937 random(3);
  Points p = random_points(random, 12);
  const auto rom = catmull_rom_pieces<Vec>(p), natural = natural_cubic_pieces<Vec>(p);
  p[5] += Vec(1, 1);
  const auto rom2 = catmull_rom_pieces<Vec>(p), natural2 = natural_cubic_pieces<Vec>(p);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(rom[i] == rom2[i], i < 3 || i > 6) << i;
    EXPECT_NE(natural[i], natural2[i]);
  }
}

TEST(Interpolating, FewPoints) {
  EXPECT_TRUE(catmull_rom_pieces<Vec>(Points{}).empty());
  EXPECT_TRUE(natural_cubic_pieces<Vec>(Points{{1, 1}}).empty());
  const auto line = natural_cubic_pieces<Vec>(Points{{0, 0}, {3, 6}});
  ASSERT_EQ(line.size(), 1u);
  expect_near(line[0][1], {1, 2});
  for (const auto& piece : natural_cubic_pieces<Vec>(Points{{0, 0}, {NAN, 6}, {1, 1}})) {
    EXPECT_TRUE(std::isnan(piece[1].x));  // and nothing worse
  }
}

std::vector<double> some_knots(std::mt19937& random, int order, int controls) {
  std::uniform_int_distribution<int> step(0, 2);
  std::vector<double> knots = {0};
  while (knots.size() < static_cast<std::size_t>(order + controls)) {
    double next = knots.back() + step(random);
    // No knot more than order - 1 times, so that the curve holds together.
    if (order > 1 && std::count(knots.begin(), knots.end(), next) >= order - 1) next += 1;
    if (order == 1) next = knots.back() + 1;
    knots.push_back(next);
  }
  return knots;
}

BSpline<Vec> some_spline(std::mt19937& random, int order, int controls, int kind) {
  BSpline<Vec> s{order, random_points(random, static_cast<std::size_t>(controls)), {}};
  s.knots = kind == 0   ? uniform_knots(order, controls)
            : kind == 1 ? open_knots(order, controls)
                        : some_knots(random, order, controls);
  return s;
}

// de Boor's ladder against the sum of Cox and de Boor's basis functions, which share no code.
TEST(BSpline, TheLadderAgreesWithTheBasis) {
  std::mt19937 random(4);
  for (int order = 1; order <= 7; ++order) {
    for (int kind = 0; kind < 3; ++kind) {
      for (int more = 0; more < 6; ++more) {
        const BSpline<Vec> s = some_spline(random, order, order + more, kind);
        for (int k = 0; k <= 40; ++k) {
          const double t = s.first() + (s.last() - s.first()) * k / 40.0;
          if (k == 40 && kind != 1) continue;  // there the last basis function belongs to beyond
          Vec sum(0);
          double total = 0;
          for (int i = 0; i < s.controls(); ++i) {
            const double w = b_spline_basis(i, order, s.knots, t);
            EXPECT_GE(w, 0);
            sum += w * s.control[static_cast<std::size_t>(i)];
            total += w;
          }
          EXPECT_NEAR(total, 1, 1e-14);
          expect_near(b_spline_point(s, t), sum);
        }
      }
    }
  }
}

TEST(BSpline, OpenKnotsWithoutInnerOnesAreABezierCurve) {
  std::mt19937 random(5);
  for (int n = 1; n <= 8; ++n) {
    const BSpline<Vec> s = some_spline(random, n, n, 1);
    for (double t = 0; t <= 1; t += 0.125) {
      expect_near(b_spline_point(s, t), bezier_point(std::span<const Vec>(s.control), t));
    }
  }
}

TEST(BSpline, UniformCubicHasTheTextbooksWeights) {
  std::mt19937 random(6);
  const BSpline<Vec> s = some_spline(random, 4, 4, 0);
  for (double t = 0; t <= 1; t += 0.125) {
    const auto& p = s.control;
    expect_near(b_spline_point(s, 3 + t), blend(cubic_b_spline_weights(t), p[0], p[1], p[2], p[3]));
  }
}

TEST(BSpline, KnotsGoInAndThePiecesComeOutUnchanged) {
  std::mt19937 random(7);
  for (int order = 2; order <= 6; ++order) {
    for (int kind = 0; kind < 3; ++kind) {
      const BSpline<Vec> s = some_spline(random, order, order + 4, kind);
      const double middle = s.first() + 0.3 * (s.last() - s.first());
      const BSpline<Vec> more = with_knot(s, middle);
      EXPECT_EQ(more.control.size(), s.control.size() + 1);
      for (int k = 0; k < 40; ++k) {
        const double t = s.first() + (s.last() - s.first()) * k / 40.0;
        expect_near(b_spline_point(more, t), b_spline_point(s, t));
      }
      double reached = s.first();
      for (const auto& piece : bezier_pieces(s)) {
        EXPECT_EQ(piece.from, reached);
        reached = piece.to;
        ASSERT_EQ(piece.control.size(), static_cast<std::size_t>(order));
        for (double u = 0.0625; u < 1; u += 0.125) {
          expect_near(bezier_point(std::span<const Vec>(piece.control), u),
                      b_spline_point(s, piece.from + u * (piece.to - piece.from)), 1e-10);
        }
      }
      EXPECT_EQ(reached, s.last());
    }
  }
}

TEST(BSpline, CubicPiecesMeetWithC2AndLessAtRepeatedKnots) {
  std::mt19937 random(8);
  BSpline<Vec> s{4, random_points(random, 7), {0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3}};
  const auto pieces = bezier_pieces(s);
  ASSERT_EQ(pieces.size(), 3u);
  const auto joint = [&](std::size_t i) {
    return measure_joint(bezier_end(std::span<const Vec>(pieces[i].control), true),
                         bezier_end(std::span<const Vec>(pieces[i + 1].control), false));
  };
  EXPECT_EQ(joint(0).continuity, Continuity::kC2);
  EXPECT_EQ(joint(1).continuity, Continuity::kC1);
}

TEST(BSpline, OneControlPointMovesOnlyItsNeighbourhood) {
  std::mt19937 random(9);
  BSpline<Vec> s = some_spline(random, 4, 12, 0);
  const BSpline<Vec> before = s;
  s.control[5] += Vec(3, 3);
  for (double t = s.first(); t < s.last(); t += 0.25) {
    EXPECT_EQ(b_spline_point(s, t) == b_spline_point(before, t), t <= 5 || t >= 9) << t;
  }
}

TEST(BSpline, BadInputIsRefused) {
  const auto refuse = [](int order, std::size_t controls, std::vector<double> knots) {
    EXPECT_THROW(b_spline_point(BSpline<Vec>{order, Points(controls), knots}, 0.5), Error);
    EXPECT_THROW(bezier_pieces(BSpline<Vec>{order, Points(controls), knots}), Error);
  };
  refuse(0, 3, {0, 1, 2});
  refuse(-3, 3, {});
  refuse(4, 3, {0, 1, 2, 3, 4, 5, 6});
  refuse(2, 3, {0, 1, 2, 3});
  refuse(2, 3, {0, 1, 0.5, 3, 4});
  refuse(2, 3, {0, 1, NAN, 3, 4});
  refuse(2, 3, {1, 1, 1, 1, 1});
  const BSpline<Vec> s{2, {{0, 0}, {1, 1}}, {0, 0, 1, 1}};
  EXPECT_EQ(b_spline_point(s, -5), Vec(0, 0));  // held to the range
  EXPECT_EQ(b_spline_point(s, 9), Vec(1, 1));
  b_spline_point(s, NAN);  // and ends
}

TEST(Nurbs, CircleIsRound) {
  const NurbsCurve circle = nurbs_circle({3, -2}, 5);
  for (int k = 0; k <= 1000; ++k) {
    EXPECT_NEAR(glm::distance(nurbs_point(circle, k / 1000.0), Vec(3, -2)), 5, 4e-15 * 5);
  }
  expect_near(nurbs_point(circle, 0.25), {3, 3});
  expect_near(nurbs_point(circle, 0.125), Vec(3, -2) + 5 / std::numbers::sqrt2 * Vec(1, 1));
}

TEST(Nurbs, SharesAddUpToTheCurve) {
  const std::array<glm::dvec2, 5> control = {{{0, 0}, {1, 3}, {4, 4}, {6, 1}, {7, 2}}};
  const std::array weights = {1.0, 4.0, 0.25, 2.0, 1.0};
  const NurbsCurve curve = nurbs_curve(4, control, weights, open_knots(4, 5));
  for (int k = 0; k <= 50; ++k) {
    const std::vector<double> shares = rational_basis(curve, k / 50.0);
    ASSERT_EQ(shares.size(), control.size());
    double sum = 0;
    glm::dvec2 p(0);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      EXPECT_GE(shares[i], 0);
      sum += shares[i];
      p += shares[i] * control[i];
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(glm::distance(p, nurbs_point(curve, k / 50.0)), 0, 1e-12);
  }
  NurbsCurve weightless = curve;
  for (glm::dvec3& p : weightless.control) p = glm::dvec3(0);
  EXPECT_TRUE(rational_basis(weightless, 0.5).empty());
}

TEST(Nurbs, MiddleWeightTellsTheConic) {
  // Between (-1, 0) and (1, 0) with the control point at (0, 1): x^2 w^2 + ... in closed form,
  // 4 w^2 a c = b^2 for barycentric a, b, c.
  for (const double w : {0.3, 1.0, 3.0}) {
    const NurbsCurve arc = conic_arc({-1, 0}, {0, 1}, {1, 0}, w);
    for (double t = 0; t <= 1; t += 0.0625) {
      const Vec p = nurbs_point(arc, t);
      const double b = p.y, c = (1 - b + p.x) / 2, a = 1 - b - c;
      EXPECT_NEAR(4 * w * w * a * c, b * b, 1e-14);
    }
  }
  EXPECT_THROW(conic_arc({0, 0}, {1, 1}, {2, 0}, 0), Error);
  EXPECT_THROW(conic_arc({0, 0}, {1, 1}, {2, 0}, NAN), Error);
}

}  // namespace
}  // namespace kinescope
