// Lessons of transformations, and practicals, used as a user would, beside formulas written out.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/transform/transform3d.h"
#include "lesson_user.h"

namespace kinescope {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

const std::vector<double>& last_values(const LessonUser& user, std::size_t track = 0) {
  const Track& t = user.lesson().course().tracks.at(track);
  return t.values(t.steps() - 1);
}

void expect_end(const LessonUser& user, glm::dvec3 want, std::size_t track = 0) {
  const std::vector<double>& end = last_values(user, track);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(end[std::size_t(i) + 1], want[i], 1e-9) << i;
}

TEST(TransformationLessons, SevenMatricesTurnAboutAnyAxis) {
  LessonUser user("transformations-3d");
  user.type(0, "75");
  user.type(1, "1");
  user.type(2, "-2");
  user.type(3, "0.5");
  const Track& track = user.lesson().course().tracks.at(0);
  EXPECT_EQ(track.steps(), 71u);
  // The ridge's part along the axis stays, the rest turns: by cross products.
  const glm::dvec3 through(0.8, 0.6, 0.4), axis = glm::normalize(glm::dvec3(1, -2, 0.5));
  const glm::dvec3 p = glm::dvec3(0, 1.75, 0.75) - through, along = glm::dot(p, axis) * axis;
  const glm::dvec3 turned =
      along + std::cos(75 * kDegree) * (p - along) + std::sin(75 * kDegree) * glm::cross(axis, p);
  expect_end(user, through + turned);
  user.pass({key_down("g")});  // an axis through the origin needs five
  EXPECT_EQ(user.lesson().course().tracks.at(0).steps(), 51u);
}

TEST(TransformationLessons, OtherKindsEndWhereTheirFormulasSay) {
  LessonUser user("transformations-3d");
  const glm::dvec3 p(0, 1.75, 0.75);
  user.type(1, "0.5");
  user.type(2, "2");
  user.type(3, "-1");
  const glm::dvec3 n(0.5, 2, -1);
  const auto next = [&] { user.pass({key_down("y")}); };
  next();  // shear
  expect_end(user, {0.5 * p.y + 2 * p.z, p.y - p.z, p.z});
  next();  // in a plane: to the other side, as far
  const glm::dvec3 off = p - glm::dvec3(0.8, 0.6, 0.4);
  expect_end(user, p - 2 * glm::dot(off, n) / glm::dot(n, n) * n);
  EXPECT_NE(user.lesson().course().remarks.at(0).find("mirror"), std::string::npos);
  next();  // about a line
  expect_end(user, p - 2.0 * (off - glm::dot(off, n) / glm::dot(n, n) * n));
  next();
  expect_end(user, p + n);
  next();
  expect_end(user, p * n);
  next();
  expect_end(user, {p.x, std::cos(120 * kDegree) * p.y - std::sin(120 * kDegree) * p.z,
                    std::sin(120 * kDegree) * p.y + std::cos(120 * kDegree) * p.z});
}

TEST(TransformationLessons, TheOrderMattersUnlessBothTurnAboutOneAxis) {
  LessonUser user("transformations-3d");
  user.pass({key_down("o")});
  const auto apart = [&] {
    const auto& tracks = user.lesson().course().tracks;
    return only_in(tracks[0], tracks[1]).size();
  };
  EXPECT_GT(apart(), 100u);
  user.type(1, "0");
  user.type(2, "0");
  user.pass({key_down("g")});  // now it is the z axis
  EXPECT_EQ(apart(), 0u);
}

TEST(TransformationLessons, AMappedNormalIsSquareToTheMappedPoints) {
  LessonUser user("planes-and-normals");
  user.type(0, "-1");
  user.type(1, "0.75");
  user.type(2, "1.5");
  const auto expect_square = [&](const glm::dmat4& map) {
    const glm::dvec3 a = apply(map, {-1.2, -1, 1}), b = apply(map, {1.2, 0.75, 1}),
                     c = apply(map, {0, 1.5, -1.4});
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    const std::vector<double>& end = last_values(user);
    EXPECT_NEAR(std::abs(glm::dot(normal, glm::dvec3(end[1], end[2], end[3]))), 1, 1e-12);
    return end[4];
  };
  EXPECT_GT(expect_square(scaling({1.6, 0.5, 1})), 5);
  user.pass({key_down("y")});
  EXPECT_GT(expect_square(shear({.a = 1.2})), 5);
  user.pass({key_down("y")});
  EXPECT_NEAR(expect_square(rotation_about_deg({{}, {1, 1, 0}}, 60)), 0, 1e-5);
}

TEST(Practicals, FigureIsTurnedThenMovedOrMovedThenTurned) {
  LessonUser user("practical-5");
  user.type(3, "90");
  // One unit of the plane is an eighth of the pane's smaller side; the corner is one to the right.
  const double unit = std::min(user.size().x, user.size().y) / 8;
  const glm::dvec2 a = glm::floor(user.size() / 2.0 + glm::dvec2(unit, 0));
  user.type(0, fmt::format("{}, {}", a.x, a.y));
  const glm::dvec2 off = (a + 0.5 - user.size() / 2.0) / unit;
  const glm::dvec2 p(off.x, -off.y);
  const std::vector<double> turned = last_values(user);
  EXPECT_NEAR(turned[1], -p.y + 1.5, 1e-9);
  EXPECT_NEAR(turned[2], p.x + 0.75, 1e-9);
  expect_end(user, {0.75 + 1.5, 1.75 + 0.75, 1.5}, 1);     // in space, about y
  for (int i = 0; i < 5; ++i) user.pass({key_down("1")});  // now it is moved first
  user.pass({key_down("2")});
  EXPECT_NEAR(last_values(user)[1], -(p.y + 0.75), 1e-9);
  EXPECT_NEAR(last_values(user)[2], p.x + 1.5, 1e-9);
}

TEST(Practicals, UnitSquareIsSheared) {
  LessonUser user("practical-6");
  EXPECT_NEAR(last_values(user)[1], 1.75, 1e-12);
  EXPECT_NEAR(last_values(user)[2], 1 + 0.5 * 1.75, 1e-12);
  EXPECT_EQ(user.lesson().course().remarks.at(0), "area 1");
  user.pass({key_down("2")});
  EXPECT_NEAR(last_values(user)[1], 1 + 0.75 * 1.5, 1e-12);
  EXPECT_NEAR(last_values(user)[2], 1.5, 1e-12);
  user.pass({key_down("3")});
  EXPECT_EQ(user.lesson().course().remarks.at(0), "area 0.625");
  // Dragged to the left by one side of the square.
  const double side = 0.5 * std::min(user.size().x, user.size().y) / 2.6;
  user.drag({100.5, 60.5}, {std::round(100.5 - side), 60.5});
  EXPECT_NEAR(last_values(user)[1], 1 - 0.25, 0.051);
  EXPECT_NEAR(last_values(user)[2], 1.5, 1e-12);
}

TEST(Practicals, HandsPointWhereTheTimeSays) {
  LessonUser user("practical-11");
  user.pass({key_down("Up"), key_down("Right")});  // 11:09
  const Track& track = user.lesson().course().tracks.at(0);
  const std::vector<double> later = track.values(60 * 60 + 29);  // an hour and half a minute
  EXPECT_EQ(later, (std::vector<double>{12, 9, 30, 0.5 * 9.5, 6 * 9.5}));
  Image<Srgb8> paper(static_cast<int>(user.size().x), static_cast<int>(user.size().y));
  user.lesson().course().painter(60 * 60 + 30, 0, paper);
  const auto at = [&](double degrees, double share) {
    const glm::dvec2 way(std::sin(degrees * kDegree), -std::cos(degrees * kDegree));
    const glm::dvec2 p = user.size() / 2.0 + 0.46 * share * user.size().y * way;
    return paper.at(static_cast<int>(p.x), static_cast<int>(p.y));
  };
  EXPECT_EQ(at(4.75, 0.4), theme::kAccent);
  EXPECT_EQ(at(57, 0.7), theme::kText);
  EXPECT_EQ(at(180, 0.7), theme::kRed);
  EXPECT_NE(at(120, 0.6), theme::kText);
  // The minute hand is dragged to the right.
  const glm::dvec2 middle = glm::floor(user.size() / 2.0);
  user.drag(middle + glm::dvec2(20.5, -15.5), middle + glm::dvec2(40.5, 0.5));
  EXPECT_EQ(user.lesson().course().tracks.at(0).values(0)[1], 15);
}

TEST(Practicals, SunStandsHighestAtNoon) {
  LessonUser user("practical-11");
  user.pass({key_down("2"), key_down("k")});
  const Track& track = user.lesson().course().tracks.at(0);
  double highest = 0, at = 0;
  for (std::size_t i = 0; i < track.steps(); ++i) {
    const std::vector<double>& v = track.values(i);
    if (v[3] > highest) highest = v[3], at = v[0] + v[1] / 60;
    if (v[0] == 18 && v[1] == 0) {
      EXPECT_NEAR(v[3], 0, 1e-9);
    }
  }
  EXPECT_EQ(highest, 60);
  EXPECT_EQ(at, 12);
}

/// Where a point is that runs to and fro between two walls: by unfolding the room.
double folded(double at, double low, double high) {
  const double room = high - low,
               way = std::fmod(std::fmod(at - low, 2 * room) + 2 * room, 2 * room);
  return way <= room ? low + way : low + 2 * room - way;
}

TEST(Practicals, BallBouncesAsAMirrorSaysAndIsNeverLost) {
  LessonUser user("practical-12");
  user.drag(user.share(0.45, 0.25), user.share(0.8, 0.6));
  const Track& track = user.lesson().course().tracks.at(0);
  const glm::dvec2 low = user.share(0.1, 0.1) + 6.0, high = user.share(0.9, 0.9) - 6.0;
  const glm::dvec2 ball = user.share(0.3, 0.4), v = 0.06 * (user.share(0.8, 0.6) - ball);
  for (std::size_t i = 0; i < track.steps(); ++i) {
    const double steps = static_cast<double>(i) + 1;
    ASSERT_NEAR(track.values(i)[0], folded(ball.x + steps * v.x, low.x, high.x), 1e-6) << i;
    ASSERT_NEAR(track.values(i)[1], folded(ball.y + steps * v.y, low.y, high.y), 1e-6) << i;
  }
  user.pass({key_down("g")});
  user.type(5, "0.5");
  const Track& fallen = user.lesson().course().tracks.at(0);
  for (std::size_t i = 0; i < fallen.steps(); ++i) {
    ASSERT_TRUE(fallen.values(i)[1] >= low.y && fallen.values(i)[1] <= high.y);
  }
  EXPECT_NEAR(last_values(user)[1], high.y, 0.2);  // at rest on the floor
  user.pass({key_down("End")});
  user.pass({});
  EXPECT_LT(user.lesson().shown(), 10u);  // thrown again
}

TEST(TransformationLessons, BadInputIsToldAndKeepsRunning) {
  struct Bad {
    const char* demo;
    int field;
    const char *typed, *told;
  };
  for (const Bad& bad : {Bad{"polygon-clipping", 2, "9999999, 3", "within 100000"},
                         {"text-clipping", 3, "0", "from 1 to 400"},
                         {"curve-clipping", 2, "999999999, 3", "lies beyond"},
                         {"window-to-viewport", 1, "16, 96", "width and a height"},
                         {"viewing-steps", 4, "0", "a width, a height and a depth"},

                         {"view-confusion", 0, "1e9", "within 1000"},
                         {"planes-and-normals", 0, "1e400", "no finite number"},
                         {"practical-5", 0, "999999999, 3", "lies beyond"},
                         {"practical-6", 0, "1e6", "from -100 to 100"},
                         {"practical-11", 1, "75", "from 0 to 59"},
                         {"practical-12", 4, "80", "too large"}}) {
    LessonUser user(bad.demo);
    user.type(bad.field, bad.typed);
    EXPECT_NE(user.lesson().fault().find(bad.told), std::string::npos)
        << bad.demo << " told \"" << user.lesson().fault() << "\" of " << bad.typed;
    user.pass({});
  }
  LessonUser user("transformations-3d");
  for (const int field : {1, 2, 3}) user.type(field, "0");
  EXPECT_NE(user.lesson().fault().find("direction"), std::string::npos);
}

}  // namespace
}  // namespace kinescope
