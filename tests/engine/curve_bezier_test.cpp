#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "engine/curves/bezier.h"
#include "engine/curves/continuity.h"
#include "engine/curves/convex_hull.h"
#include "engine/curves/cubic.h"
#include "tests/engine/random_points.h"

namespace kinescope {
namespace {

using Vec = glm::dvec2;
using Points = std::vector<Vec>;

Vec at(const Points& control, double t) { return bezier_point(std::span<const Vec>(control), t); }

void expect_near(const Vec& a, const Vec& b, double tolerance = 1e-12) {
  EXPECT_LE(glm::distance(a, b), tolerance) << a.x << ' ' << a.y << " is not " << b.x << ' ' << b.y;
}

double choose(int n, int k) {
  return std::round(std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1)));
}

// By definition: the sum of binomials times powers.
TEST(Bezier, EveryEvaluationAgreesWithTheDefinition) {
  std::mt19937 random(1);
  for (int degree = 0; degree <= 20; ++degree) {
    const Points p = random_points(random, static_cast<std::size_t>(degree) + 1);
    for (double t = 0; t <= 1.0; t += 0.0625) {
      Vec sum(0);
      for (int i = 0; i <= degree; ++i) {
        const double weight = choose(degree, i) * std::pow(t, i) * std::pow(1 - t, degree - i);
        sum += weight * p[static_cast<std::size_t>(i)];
        EXPECT_NEAR(bernstein(degree, t)[static_cast<std::size_t>(i)], weight, 1e-13);
      }
      expect_near(at(p, t), sum);
      expect_near(bezier_point_by_weights(std::span<const Vec>(p), t), sum);
    }
    EXPECT_EQ(at(p, 0), p.front());
    EXPECT_EQ(at(p, 1), p.back());
  }
}

TEST(Bezier, TheLadderHasEveryRung) {
  const Points p = {{0, 0}, {0, 8}, {8, 8}, {8, 0}};
  DeCasteljau<Vec> ladder(p, 0.5);
  int rungs = 1;
  while (ladder.next()) ++rungs;
  EXPECT_EQ(rungs, 4);
  EXPECT_EQ(ladder.rungs()[1], (Points{{0, 4}, {4, 8}, {8, 4}}));
  EXPECT_EQ(ladder.rungs()[2], (Points{{2, 6}, {6, 6}}));
  EXPECT_EQ(ladder.rungs()[3], (Points{{4, 6}}));
  const auto halves = bezier_split(std::span<const Vec>(p), 0.5);
  EXPECT_EQ(halves.before, (Points{{0, 0}, {0, 4}, {2, 6}, {4, 6}}));
  EXPECT_EQ(halves.after, (Points{{4, 6}, {6, 6}, {8, 4}, {8, 0}}));
}

TEST(Bezier, WorkedExamples) {
  // The inner weights of a cubic peak at 1/3 and 2/3 with 4/9.
  EXPECT_NEAR(bernstein(3, 1.0 / 3)[1], 4.0 / 9, 1e-15);
  EXPECT_NEAR(bernstein(3, 2.0 / 3)[2], 4.0 / 9, 1e-15);
  for (int i = 0; i <= 3000; ++i) {
    EXPECT_LE(bernstein(3, i / 3000.0)[1], 4.0 / 9 + 1e-15);
    EXPECT_LE(bernstein(3, i / 3000.0)[2], 4.0 / 9 + 1e-15);
  }
  // Three points make a parabola: here x = 2 t, y = 4 t (1 - t), so y = x (2 - x).
  const Points parabola = {{0, 0}, {1, 2}, {2, 0}};
  for (double t = 0; t <= 1; t += 0.125) {
    const Vec p = at(parabola, t);
    EXPECT_EQ(p.y, p.x * (2 - p.x));
  }
  // Points on a line give a straight segment.
  const Points line = {{0, 1}, {4, 9}, {1, 3}, {3, 7}};
  for (double t = 0; t <= 1; t += 0.125) EXPECT_EQ(at(line, t).y, 2 * at(line, t).x + 1);
}

TEST(Bezier, PartsSlopesAndElevationAreTheSameCurve) {
  std::mt19937 random(2);
  for (std::size_t n = 1; n <= 9; ++n) {
    const Points p = random_points(random, n);
    const std::span<const Vec> control(p);
    const Points part = bezier_part(control, 0.25, 0.75), more = bezier_elevated(control);
    const Points slope = bezier_derivative(control);
    for (double t = 0.125; t < 1; t += 0.125) {
      expect_near(at(part, t), at(p, 0.25 + 0.5 * t));
      expect_near(at(more, t), at(p, t));
      expect_near(at(slope, t), (at(p, t + 1e-6) - at(p, t - 1e-6)) / 2e-6, 1e-6);
    }
  }
}

TEST(Bezier, ChordsStayWithinTheTolerance) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    const Points p = random_points(random, 4);
    Points chain = {p[0]};
    bezier_chords(std::span<const Vec>(p), 0.01, [&](const Vec& a, const Vec& b) {
      EXPECT_EQ(a, chain.back());
      chain.push_back(b);
    });
    EXPECT_EQ(chain.back(), p[3]);
    for (double t = 0; t <= 1; t += 0.01) {
      const Vec q = at(p, t);
      double nearest = 1e9;
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        const Vec d = chain[k + 1] - chain[k];
        const double s = std::clamp(glm::dot(q - chain[k], d) / glm::dot(d, d), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(q, chain[k] + s * d));
      }
      EXPECT_LE(nearest, 0.0142);
    }
  }
  int chords = 0;
  const Points bad = {{0, 0}, {NAN, INFINITY}, {1e300, 0}, {1, 1}};
  bezier_chords(std::span<const Vec>(bad), 0.0, [&](const Vec&, const Vec&) { ++chords; });
  EXPECT_LE(chords, 1 << 16);
}

TEST(Bezier, StaysInItsHullAndIsAxisIndependent) {
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const Points p = random_points(random, 3 + static_cast<std::size_t>(i % 6));
    const Points hull = convex_hull(p);
    const double c = std::cos(i), s = std::sin(i);
    const auto turn = [&](const Vec& v) { return Vec(c * v.x - s * v.y + i, s * v.x + c * v.y); };
    Points turned(p);
    for (Vec& v : turned) v = turn(v);
    for (double t = 0; t <= 1; t += 0.03125) {
      EXPECT_TRUE(t == 0 || t == 1 || hull_contains(hull, at(p, t)));
      expect_near(at(turned, t), turn(at(p, t)), 1e-11);
    }
  }
}

TEST(Bezier, DiminishesVariation) {
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const Points p = random_points(random, 6), line = random_points(random, 2);
    Points curve;
    for (int k = 0; k <= 400; ++k) curve.push_back(at(p, k / 400.0));
    EXPECT_LE(line_crossings(curve, line[0], line[1]), line_crossings(p, line[0], line[1]));
  }
}

TEST(ConvexHull, ByDefinition) {
  std::mt19937 random(6);
  std::uniform_int_distribution<int> u(0, 8);
  for (int i = 0; i < 300; ++i) {
    Points p;
    for (int k = 0; k < 1 + i % 20; ++k) p.emplace_back(u(random), u(random));
    const Points hull = convex_hull(p);
    for (const Vec& v : p) EXPECT_TRUE(hull_contains(hull, v));
    for (const Vec& corner : hull) {
      EXPECT_NE(std::find(p.begin(), p.end(), corner), p.end());
      Points rest(hull);
      std::erase(rest, corner);
      EXPECT_FALSE(hull_contains(rest, corner));  // none is idle
    }
  }
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_EQ(convex_hull(Points{{NAN, 0}, {1, 1}, {1, 1}}), (Points{{1, 1}}));
  EXPECT_EQ(convex_hull(Points{{0, 0}, {1, 1}, {2, 2}, {3, 3}}).size(), 2u);
  EXPECT_FALSE(hull_contains({}, {0, 0}));
}

TEST(Continuity, TellsTheClassesApart) {
  const Points a = {{0, 0}, {1, 2}, {3, 2}, {4, 0}};
  const auto joint = [&](const Points& b) {
    return measure_joint(bezier_end(std::span<const Vec>(a), true),
                         bezier_end(std::span<const Vec>(b), false));
  };
  EXPECT_EQ(joint({{4, 1}, {5, 5}, {6, 6}, {7, 0}}).continuity, Continuity::kNone);
  EXPECT_EQ(joint({{4, 1}, {5, 5}, {6, 6}, {7, 0}}).gap, 1);
  const auto c0 = joint({{4, 0}, {6, 1}, {6, 6}, {7, 0}});
  EXPECT_EQ(c0.continuity, Continuity::kC0);
  EXPECT_NEAR(c0.turn_rad, std::acos(-1.0) / 2, 1e-15);
  EXPECT_EQ(joint({{4, 0}, {6, -4}, {6, 6}, {7, 0}}).continuity, Continuity::kG1);
  EXPECT_EQ(joint({{4, 0}, {5, -2}, {6, 6}, {7, 0}}).continuity, Continuity::kC1);
  // Cut from one curve, with the parameter's stretch taken into account, all derivatives agree.
  const auto halves = bezier_split(std::span<const Vec>(a), 0.25);
  const auto cut = measure_joint(bezier_end(std::span<const Vec>(halves.before), true, 0.25),
                                 bezier_end(std::span<const Vec>(halves.after), false, 0.75));
  EXPECT_EQ(cut.continuity, Continuity::kC2);
  // A curve that stands still has no direction.
  EXPECT_EQ(joint({{4, 0}, {4, 0}, {4, 0}, {4, 0}}).continuity, Continuity::kC0);
  EXPECT_EQ(joint({{NAN, 0}, {4, 0}, {4, 0}, {4, 0}}).continuity, Continuity::kNone);
}

TEST(Curvature, IsTheTouchingCirclesOfAParabola) {
  const std::vector<Vec> parabola = {{-1, 1}, {0, -1}, {1, 1}};  // y = x^2, x = 2t - 1
  for (const double t : {0.0, 0.3, 0.5, 1.0}) {
    const CurveEnd<Vec> at = bezier_at(std::span<const Vec>(parabola), t);
    const double x = 2 * t - 1;
    EXPECT_NEAR(at.point.y, x * x, 1e-12);
    EXPECT_NEAR(curvature(at), 2 / std::pow(1 + 4 * x * x, 1.5), 1e-12);
  }
  EXPECT_EQ(curvature(CurveEnd<Vec>{{0, 0}, {0, 0}, {1, 1}}), 0) << "where it stands still";
}

TEST(Cubic, WeightsSumToOneAndAgree) {
  blending_functions(cubic_bezier_weights, 64, [](double t, const CubicWeights& w) {
    const std::vector<double> b = bernstein(3, t);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(w[i], b[i], 1e-15);
  });
  blending_functions(cubic_b_spline_weights, 64, [](double, const CubicWeights& w) {
    EXPECT_NEAR(w[0] + w[1] + w[2] + w[3], 1, 1e-15);
    for (const double weight : w) EXPECT_GE(weight, -1e-17);
  });
  int places = 0;
  blending_functions([](double t) { return catmull_rom_weights(t); }, 64,
                     [&](double, const CubicWeights& w) {
                       EXPECT_NEAR(w[0] + w[1] + w[2] + w[3], 1, 1e-15);
                       ++places;
                     });
  EXPECT_EQ(places, 65);
}

}  // namespace
}  // namespace kinescope
