#include "raster/path/svg_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>

namespace kinescope {
namespace {

/// The path in absolute commands, for comparison.
std::string text(const Path& path) {
  std::string out;
  const glm::vec2* p = path.points.data();
  const auto points = [&](int count) {
    for (int i = 0; i < count; ++i, ++p) {
      char part[64];
      std::snprintf(part, sizeof part, " %g,%g", static_cast<double>(p->x),
                    static_cast<double>(p->y));
      out += part;
    }
  };
  for (const Path::Verb verb : path.verbs) {
    constexpr int kPoints[] = {1, 1, 2, 3, 0};
    out += "MLQCZ"[static_cast<int>(verb)];
    points(kPoints[static_cast<int>(verb)]);
  }
  return out;
}

std::string parsed(std::string_view data) { return text(parse_svg_path(data)); }

TEST(SvgPath, ReadsEveryCommandAbsoluteAndRelative) {
  EXPECT_EQ(parsed("M1,2L3,4H5V6Z"), "M 1,2L 3,4L 5,4L 5,6Z");
  EXPECT_EQ(parsed("m1,2l3,4h5v6z"), "M 1,2L 4,6L 9,6L 9,12Z");
  EXPECT_EQ(parsed("M0 0C1 2 3 4 5 6"), "M 0,0C 1,2 3,4 5,6");
  EXPECT_EQ(parsed("M1 1c1 2 3 4 5 6"), "M 1,1C 2,3 4,5 6,7");
  EXPECT_EQ(parsed("M0 0Q1 2 3 4"), "M 0,0Q 1,2 3,4");
  EXPECT_EQ(parsed("M1 1q1 2 3 4"), "M 1,1Q 2,3 4,5");
}

TEST(SvgPath, SmoothCurvesMirrorTheHandleOfTheirOwnKind) {
  EXPECT_EQ(parsed("M0 0C1 2 3 4 5 6S9 9 8 8"), "M 0,0C 1,2 3,4 5,6C 7,8 9,9 8,8");
  EXPECT_EQ(parsed("M0 0S9 9 8 8"), "M 0,0C 0,0 9,9 8,8");
  EXPECT_EQ(parsed("M0 0Q1 2 3 4T8 8T0 0"), "M 0,0Q 1,2 3,4Q 5,6 8,8Q 11,10 0,0");
  EXPECT_EQ(parsed("M0 0C1 2 3 4 5 6T8 8"), "M 0,0C 1,2 3,4 5,6Q 5,6 8,8");
  EXPECT_EQ(parsed("M0 0Q1 2 3 4L3 3T8 8"), "M 0,0Q 1,2 3,4L 3,3Q 3,3 8,8");
}

TEST(SvgPath, NumbersMayTouch) {
  EXPECT_EQ(parsed("M1-2.5.5-.25"), "M 1,-2.5L 0.5,-0.25");
  EXPECT_EQ(parsed(" M\t1e1,+2E0 \n L 3e-1 , 4 "), "M 10,2L 0.3,4");
  EXPECT_EQ(text(parse_svg_path("M0 0a5 5 0 01 0 10")),
            text(parse_svg_path("M0 0a5,5,0,0,1,0,10")));
}

TEST(SvgPath, RepeatedGroupsRepeatTheCommand) {
  EXPECT_EQ(parsed("M1 1 2 2 3 3"), "M 1,1L 2,2L 3,3");
  EXPECT_EQ(parsed("m1 1 2 2 3 3"), "M 1,1L 3,3L 6,6");
  EXPECT_EQ(parsed("M0 0h1 2 3"), "M 0,0L 1,0L 3,0L 6,0");
}

TEST(SvgPath, ClosingReturnsToTheStart) {
  EXPECT_EQ(parsed("M1 1l4 0 0 4zl1 1"), "M 1,1L 5,1L 5,5ZM 1,1L 2,2");
  EXPECT_EQ(parsed("M1 1l4 0zm2 2l1 1"), "M 1,1L 5,1ZM 3,3L 4,4");
}

/// Points of the curves, each an eighth further.
std::vector<glm::vec2> samples(const Path& path) {
  std::vector<glm::vec2> out;
  glm::vec2 pen = path.points[0];
  for (std::size_t i = 1; i + 2 < path.points.size(); i += 3) {
    const glm::vec2 a = path.points[i], b = path.points[i + 1], to = path.points[i + 2];
    for (int k = 0; k <= 8; ++k) {
      const float t = static_cast<float>(k) / 8, s = 1 - t;
      out.push_back(s * s * s * pen + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * to);
    }
    pen = to;
  }
  return out;
}

TEST(SvgPath, ArcsLieOnTheirEllipse) {
  for (const int large : {0, 1}) {
    for (const int sweep : {0, 1}) {
      const std::string flags = std::to_string(large) + " " + std::to_string(sweep);
      const Path path = parse_svg_path("M10 0A10 10 0 " + flags + " 0 10");
      EXPECT_EQ(path.points.back(), glm::vec2(0, 10));
      // Of the two circles through both ends, one's centre is the origin.
      const glm::vec2 centre = large == sweep ? glm::vec2(10, 10) : glm::vec2(0, 0);
      float length = 0;
      const std::vector<glm::vec2> points = samples(path);
      for (const glm::vec2 p : points) EXPECT_NEAR(glm::length(p - centre), 10, 0.004);
      for (std::size_t i = 1; i < points.size(); ++i)
        length += glm::length(points[i] - points[i - 1]);
      EXPECT_NEAR(length, (large ? 1.5 : 0.5) * 3.14159 * 10, 0.15);
    }
  }
}

TEST(SvgPath, TurnedAndTooSmallArcs) {
  // An ellipse of 20 by 10, its longer axis at 30 degrees, from one end of it to the other.
  const glm::vec2 axis(std::cos(0.5235988f), std::sin(0.5235988f)), other(-axis.y, axis.x);
  const glm::vec2 end = 40.0f * axis;
  char data[99];
  for (const double radius : {20.0, 2.0}) {  // the second is enlarged until it reaches
    std::snprintf(data, sizeof data, "M0 0a%g %g 30 0 1 %.6f %.6f", radius, radius / 2,
                  static_cast<double>(end.x), static_cast<double>(end.y));
    for (const glm::vec2 p : samples(parse_svg_path(data))) {
      const glm::vec2 from_centre = p - 20.0f * axis;
      const float u = glm::dot(from_centre, axis) / 20, v = glm::dot(from_centre, other) / 10;
      EXPECT_NEAR(u * u + v * v, 1, 0.002) << data;
    }
  }
  EXPECT_EQ(parsed("M1 1A0 5 0 0 1 3 3"), "M 1,1L 3,3");
  EXPECT_EQ(parsed("M1 1A5 5 0 0 1 1 1L2 2"), "M 1,1L 2,2");
}

TEST(SvgPath, EndsAtTheFirstFault) {
  const auto fault_in = [](std::string_view data) {
    std::size_t fault = 0;
    parse_svg_path(data, &fault);
    return fault;
  };
  constexpr std::size_t kNone = std::string_view::npos;
  EXPECT_EQ(fault_in("M1 1L2 2"), kNone);
  EXPECT_EQ(fault_in(""), kNone);
  EXPECT_EQ(fault_in("L2 2"), 0u);
  EXPECT_EQ(fault_in("M1 1X2"), 5u);
  EXPECT_NE(fault_in("M1 1L2"), kNone);
  EXPECT_NE(fault_in("M1 1L2,,3"), kNone);
  EXPECT_NE(fault_in("M1 1A1 1 0 2 0 3 3"), kNone) << "a flag is 0 or 1";
  EXPECT_NE(fault_in("M1 1Lnan 3"), kNone);
  EXPECT_NE(fault_in("M1 1L1e99 3"), kNone);
  EXPECT_NE(fault_in("M1 1L+-1 3"), kNone);
  EXPECT_EQ(parsed("M1 1L2 2L3"), "M 1,1L 2,2") << "what came before stays";
}

TEST(SvgPath, AnyTextIsHarmless) {
  std::mt19937 random(1);
  const std::string_view letters =
      "MmLlHhVvCcSsQqTtAaZz.,-+eE\n\xff 0 1 2 3 4 5 6 7 8 9 0 1 0 1 0 1 0 1 0 1 0 1";
  std::size_t most = 0;
  for (int n = 0; n < 20000; ++n) {
    std::string data = "M0 0";
    for (int i = 0; i < 200; ++i) data += letters[random() % letters.size()];
    const Path path = parse_svg_path(data);
    std::size_t points = 0;
    constexpr std::size_t kPoints[] = {1, 1, 2, 3, 0};
    for (const Path::Verb verb : path.verbs) points += kPoints[static_cast<int>(verb)];
    ASSERT_EQ(points, path.points.size());
    most = std::max(most, path.verbs.size());
  }
  EXPECT_GT(most, 8u);
}

}  // namespace
}  // namespace kinescope
