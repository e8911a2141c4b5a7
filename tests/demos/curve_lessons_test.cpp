// Lessons of curves and fractals, used as a user would, beside what is known of their figures.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "lesson_user.h"

namespace kinescope {
namespace {

const Track& track(const LessonUser& user, std::size_t index) {
  return user.lesson().course().tracks.at(index);
}
glm::dvec2 point(const Track& track, std::size_t step) {
  return {track.values(step).at(1), track.values(step).at(2)};
}
double apart(const Track& a, const Track& b) {
  double most = 0;
  for (std::size_t i = 0; i < std::min(a.steps(), b.steps()); ++i) {
    most = std::max(most, glm::distance(point(a, i), point(b, i)));
  }
  return most;
}
bool tells(const LessonUser& user, const std::string& what) {
  for (const std::string& remark : user.lesson().course().remarks) {
    if (remark.find(what) != std::string::npos) return true;
  }
  return false;
}
/// The number at the end of a remark's beginning.
double told(const LessonUser& user, const std::string& before) {
  for (const std::string& remark : user.lesson().course().remarks) {
    const std::size_t at = remark.find(before);
    if (at != std::string::npos) return std::stod(remark.substr(at + before.size()));
  }
  ADD_FAILURE() << "nothing told of " << before;
  return NAN;
}

TEST(CurveLessons, ADraggedPointMovesTheCardinalSplineNearIt) {
  LessonUser user("splines");
  const Track cardinal = track(user, 1), natural = track(user, 2);
  EXPECT_TRUE(tells(user, "cardinal: C1")) << "and no more";
  EXPECT_TRUE(tells(user, "natural cubic: C2"));
  user.drag(user.share(0.1, 0.7), {20.5, 20.5});  // p0
  const Track &after = track(user, 1), &everywhere = track(user, 2);
  EXPECT_EQ(point(after, 0), glm::dvec2(20.5, 20.5));
  // p0 shapes the two pieces up to p2, of 40 steps each; no other.
  EXPECT_NE(point(after, 60), point(cardinal, 60));
  EXPECT_EQ(point(after, 100), point(cardinal, 100));
  EXPECT_NE(point(everywhere, 100), point(natural, 100));
  for (std::size_t piece = 0; piece <= 4; ++piece) {  // all pass the points
    EXPECT_LT(glm::distance(point(track(user, 0), 40 * piece), point(after, 40 * piece)), 1e-9);
    EXPECT_LT(glm::distance(point(everywhere, 40 * piece), point(after, 40 * piece)), 1e-9);
  }
}

TEST(CurveLessons, ASlopesTipGoesAlongWithItsPoint) {
  LessonUser user("splines");
  const Track unmoved = track(user, 0);
  const glm::dvec2 way(15, 9);
  for (const std::size_t i : {0u, 1u, 2u, 3u, 4u}) {
    const glm::dvec2 at = point(unmoved, 40 * i);
    user.drag(at, at + way);
  }
  // All points moved alike, to a pixel, and their slopes with them: so did the curve. Slopes left
  // behind would bend it by 7 pixels.
  for (std::size_t i = 0; i < unmoved.steps(); ++i) {
    EXPECT_LT(glm::distance(point(track(user, 0), i), point(unmoved, i) + way), 2) << i;
  }
}

TEST(CurveLessons, GivenKnotsAreThoseTyped) {
  LessonUser user("b-splines");
  user.pass({key_down("k"), key_down("k")});
  EXPECT_TRUE(tells(user, "knots 0 0 0 0 1 1 4 4 4 4"));
  EXPECT_TRUE(tells(user, "2 Bezier pieces of degree 3"));
  user.type(6, " 5");
  EXPECT_NE(user.lesson().fault().find("10"), std::string::npos) << user.lesson().fault();
  LessonUser falls("b-splines");
  falls.pass({key_down("k"), key_down("k")});
  falls.pass({key_down("1")});  // of order 3 there must be nine
  EXPECT_NE(falls.lesson().fault(), "");
}

TEST(CurveLessons, TensionOneMakesCardinalPiecesStraight) {
  LessonUser user("splines");
  for (int i = 0; i < 10; ++i) user.pass({key_down("2")});
  const Track& cardinal = track(user, 1);
  const glm::dvec2 a = point(cardinal, 40), b = point(cardinal, 80), middle = point(cardinal, 60);
  EXPECT_LT(glm::distance(middle, 0.5 * (a + b)), 1e-9);
}

TEST(CurveLessons, AJointIsAsSmoothAsItIsKept) {
  LessonUser user("continuity");
  EXPECT_TRUE(tells(user, "the joint: G1"));
  EXPECT_GT(told(user, "first derivative's step "), 1);
  user.pass({key_down("k")});
  EXPECT_TRUE(tells(user, "the joint: C1"));
  EXPECT_GT(told(user, "second derivative's step "), 1);
  user.pass({key_down("k")});
  EXPECT_TRUE(tells(user, "the joint: C2"));
  // Of C2 the curvatures are one: on the last step of a piece and on the first of the other.
  const Track& bend = track(user, 3);
  EXPECT_NEAR(bend.values(60)[1], bend.values(61)[1], 1e-9);
  user.pass({key_down("k")});
  EXPECT_TRUE(tells(user, "the joint: no continuity"));
  user.drag(user.share(0.55, 0.5), user.share(0.5, 0.45));
  EXPECT_TRUE(tells(user, "the joint: C0")) << "dragged together";
}

TEST(CurveLessons, ANurbsCircleIsRoundAndAPlainSplineIsNot) {
  LessonUser user("nurbs");
  user.pass({key_down("3")});
  EXPECT_LT(told(user, "furthest off the circle: "), 1e-11);
  const glm::dvec2 centre = user.share(0.5, 0.5);
  const double radius = glm::distance(user.share(0.85, 0.5), centre);
  double off_plain = 0;
  for (std::size_t i = 0; i < track(user, 0).steps(); ++i) {
    off_plain =
        std::max(off_plain, std::abs(glm::distance(point(track(user, 0), i), centre) - radius));
    EXPECT_NEAR(glm::distance(point(track(user, 1), i), centre), radius, 1e-9);
  }
  EXPECT_GT(off_plain, 1);
}

// For the quadratic with weights 1, w, 1 over a triangle: tau1^2 = 4 w^2 tau0 tau2 in barycentric
// coordinates.
TEST(CurveLessons, AConicArcObeysItsEquation) {
  LessonUser user("nurbs");
  user.pass({key_down("2")});
  EXPECT_TRUE(tells(user, "a parabola"));
  user.type(5 + 2, "0.5");  // six handles, then w1, w2
  EXPECT_TRUE(tells(user, "an ellipse"));
  const glm::dvec2 a = user.share(0.12, 0.7), b = user.share(0.5, 0.5), c = user.share(0.88, 0.7);
  const auto area = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  for (std::size_t i = 0; i < track(user, 1).steps(); ++i) {
    const glm::dvec2 p = point(track(user, 1), i);
    const double whole = area(a, b, c);
    const double t0 = area(p, b, c) / whole, t1 = area(a, p, c) / whole, t2 = area(a, b, p) / whole;
    EXPECT_NEAR(t1 * t1, 4 * 0.25 * t0 * t2, 1e-9);
  }
  user.type(5 + 2, "-1");
  EXPECT_NE(user.lesson().fault().find("weights"), std::string::npos);
}

TEST(CurveLessons, ATurnedPolynomialIsAnotherCurve) {
  LessonUser user("curve-properties");
  EXPECT_LT(apart(track(user, 1), track(user, 2)), 1e-9);
  EXPECT_LE(told(user, "and of the curve: "), told(user, "polygon by the line: "));
  user.pass({key_down("3")});
  EXPECT_GT(apart(track(user, 1), track(user, 2)), 1);
  EXPECT_TRUE(tells(user, "leaves the hull"));
  user.drag(user.share(0.1, 0.5), user.share(0.2, 0.7));
  EXPECT_NE(user.lesson().fault().find("one above another"), std::string::npos);
}

TEST(CurveLessons, ABezierCurveHasTheDegreeOfItsPoints) {
  LessonUser user("bezier");
  const Track cubic = track(user, 0);
  user.pass({key_down("4")});
  const std::array points = {user.share(0.1, 0.8), user.share(0.2, 0.15), user.share(0.75, 0.1),
                             user.share(0.9, 0.75), user.share(0.6, 0.9)};
  const Track& quartic = track(user, 0);
  for (std::size_t i = 0; i < quartic.steps(); i += 25) {
    const double t = quartic.values(i)[0], s = 1 - t;
    const glm::dvec2 sum = s * s * s * s * points[0] + 4 * s * s * s * t * points[1] +
                           6 * s * s * t * t * points[2] + 4 * s * t * t * t * points[3] +
                           t * t * t * t * points[4];
    EXPECT_LT(glm::distance(point(quartic, i), sum), 1e-9) << t;
  }
  EXPECT_GT(apart(cubic, quartic), 1);
  user.pass({key_down("c")});
  // Two polygons of four legs, which meet at the point of the curve at t = 0.4.
  const std::vector<Guide>& legs = user.lesson().course().guides;
  ASSERT_EQ(legs.size(), 8u);
  EXPECT_EQ(legs[3].to, legs[4].from);
  EXPECT_LT(glm::distance(legs[3].to, point(track(user, 0), 80)), 1e-9);
}

TEST(FractalLessons, TheChaosGameLeavesTheMiddleOfItsTriangleEmpty) {
  LessonUser user("iterated-functions");
  const glm::dvec2 corner(40.5, 20.5);
  user.drag(user.share(0.5, 0.08), corner);
  const glm::dvec2 b = user.share(0.1, 0.9), c = user.share(0.9, 0.9);
  const auto area = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  std::map<double, int> maps;
  for (std::size_t i = 0; i < track(user, 0).steps(); ++i) {
    const glm::dvec2 p(track(user, 0).values(i)[0], track(user, 0).values(i)[1]);
    const double whole = area(corner, b, c);
    const double most =
        std::max({area(p, b, c) / whole, area(corner, p, c) / whole, area(corner, b, p) / whole});
    ASSERT_GE(most, 0.5 - 1e-9) << "in one of three halves";
    ++maps[track(user, 0).values(i)[2]];
  }
  ASSERT_EQ(maps.size(), 3u);
  for (const auto& [map, count] : maps) EXPECT_NEAR(count, 4000, 250) << map;  // 5 deviations
}

TEST(FractalLessons, GasketsHaveTheirPieces) {
  LessonUser user("gaskets");
  EXPECT_EQ(track(user, 0).steps(), 81u);
  EXPECT_TRUE(tells(user, "0.3164"));  // (3/4)^4
  user.pass({key_down("y")});
  EXPECT_EQ(track(user, 0).steps(), 4096u);
  user.pass({key_down("y")});
  EXPECT_EQ(track(user, 0).steps(), 256u);
  user.pass({key_down("y")});
  EXPECT_EQ(track(user, 0).steps(), 31u);  // all five rows
  EXPECT_TRUE(tells(user, "0.631"));
}

TEST(FractalLessons, AStraightGeneratorLeavesTheInitiator) {
  LessonUser user("generator-curves");
  EXPECT_EQ(track(user, 1).steps(), 256u);
  for (int i = 0; i < 2; ++i) user.pass({key_down("i")});
  EXPECT_EQ(track(user, 1).steps(), 1024u);  // of four sides
  const glm::dvec2 low = user.share(0.5, 0.8);
  user.drag(user.share(0.5, 0.345), low);
  EXPECT_NEAR(told(user, "lines, "), 1, 1e-3);
  EXPECT_NEAR(told(user, "dimension "), 1, 1e-3);
  for (int i = 0; i < 3; ++i) user.pass({key_down("2")});
  EXPECT_NE(user.lesson().fault().find("lines are more than"), std::string::npos);
}

TEST(FractalLessons, MidpointsStayOnceMade) {
  LessonUser user("plasma");
  const Track& heights = track(user, 0);
  ASSERT_GT(heights.steps(), 4u);
  const double side = std::sqrt(double(heights.marks(0).size()));
  EXPECT_EQ(heights.values(heights.steps() - 1)[1], side * side) << "all made";
  EXPECT_EQ(heights.values(0)[1], 4);
  // The corners keep their colour from the first step to the last.
  const auto first = heights.marks(0), last = heights.marks(heights.steps() - 1);
  for (const std::size_t i :
       {std::size_t{0}, static_cast<std::size_t>(side) - 1, last.size() - 1}) {
    EXPECT_EQ(first[i].colour, last[i].colour) << i;
  }
}

TEST(FractalLessons, AParticleIsAwayAsTheRootOfItsSteps) {
  double squares = 0;
  LessonUser user("brownian");
  for (int run = 0; run < 20; ++run) {
    const Track& path = track(user, 0);
    const std::vector<double>& end = path.values(path.steps() - 1);
    squares += end[1] * end[1] / (end[2] * end[2]) / 20;
    user.pass({key_down("6")});
  }
  EXPECT_NEAR(squares, 1, 0.7);  // exponential, each: three deviations of the mean
}

TEST(FractalLessons, EachParticleTouchesAnEarlierOne) {
  LessonUser user("aggregation");
  std::set<std::pair<int, int>> there;
  for (const Mark& mark : track(user, 0).all_marks()) {
    const bool touches = there.empty() || there.count({mark.x - 1, mark.y}) +
                                                  there.count({mark.x + 1, mark.y}) +
                                                  there.count({mark.x, mark.y - 1}) +
                                                  there.count({mark.x, mark.y + 1}) >
                                              0;
    ASSERT_TRUE(touches) << mark.x << ", " << mark.y;
    ASSERT_TRUE(there.insert({mark.x, mark.y}).second);
  }
  const double dimension = told(user, "dimension ");
  EXPECT_GT(dimension, 1.4);
  EXPECT_LT(dimension, 1.95);
}

TEST(FractalLessons, ShorterRulersFindALongerCoast) {
  LessonUser user("coastline");
  double before = told(user, "the coast is ");
  for (int i = 0; i < 4; ++i) {
    user.pass({key_down("2")});
    const double longer = told(user, "the coast is ");
    EXPECT_GT(longer, before);
    before = longer;
  }
  EXPECT_NEAR(told(user, "by all sizes: "), std::log(4) / std::log(3), 0.05);
  // Every foot is a ruler from the last.
  const Track& dividers = track(user, 2);
  const double ruler = told(user, "rulers of ");
  for (std::size_t i = 1; i + 1 < dividers.steps(); ++i) {
    const auto &a = dividers.values(i - 1), &b = dividers.values(i);
    EXPECT_NEAR(std::hypot(a[0] - b[0], a[1] - b[1]), ruler, 0.01);
  }
  user.pass({key_down("x")});
  EXPECT_EQ(double(track(user, 2).steps()), told(user, "pixels: "));
  EXPECT_NEAR(told(user, "by all sizes: "), std::log(4) / std::log(3), 0.1);
}

TEST(FractalLessons, MapsAloneLeadBackToThePicture) {
  LessonUser user("fractal-compression");
  const Track& decoded = track(user, 1);
  const std::size_t last = decoded.steps() - 1;
  EXPECT_LT(decoded.values(last)[1], 0.01) << "settled";
  EXPECT_GT(decoded.values(last)[2], decoded.values(0)[2] + 8) << "dB";
  const Image<Srgb8>& picture = user.lesson().course().papers.at(0);
  double squares = 0;
  for (const Mark& mark : decoded.marks(last)) {
    const double off = (mark.colour.r - picture.at(mark.x, mark.y).r) / 255.0;
    squares += off * off / double(decoded.marks(last).size());
  }
  EXPECT_NEAR(-10 * std::log10(squares), decoded.values(last)[2], 0.2);
}

TEST(FractalLessons, KochsCurveMagnifiedIsTheSame) {
  LessonUser user("self-similarity");
  const auto white = [&](std::size_t step) {
    std::set<std::pair<int, int>> pixels;
    for (const Mark& mark : track(user, 1).marks(step)) {
      if (mark.colour == theme::kText) pixels.insert({mark.x, mark.y});
    }
    return pixels;
  };
  const auto first = white(0);
  ASSERT_GT(first.size(), 300u);
  // Thirds are rounded: a pixel or two may fall to the neighbour.
  for (std::size_t step = 1; step < 9; ++step) {
    std::size_t differ = 0;
    for (const auto& pixel : white(step)) differ += first.count(pixel) == 0;
    EXPECT_LT(differ, first.size() / 100) << step;
  }
}

}  // namespace
}  // namespace kinescope
