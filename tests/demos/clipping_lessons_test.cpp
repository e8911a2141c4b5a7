// Lessons of clipping and of viewing, used as a user would, beside definitions written out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "lesson_user.h"

namespace kinescope {
namespace {

using Points = std::vector<glm::dvec2>;

/// How far a point lies from a polygon's edges, and whether it is inside by the even-odd rule.
struct Standing {
  double distance = 1e300;
  bool inside = false;
};
Standing standing(const Points& polygon, glm::dvec2 p) {
  Standing s;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()], d = b - a;
    const double t = std::clamp(glm::dot(p - a, d) / glm::dot(d, d), 0.0, 1.0);
    s.distance = std::min(s.distance, glm::distance(p, a + t * d));
    if ((a.y > p.y) != (b.y > p.y)) s.inside ^= p.x < a.x + (p.y - a.y) / d.y * d.x;
  }
  return s;
}

Image<Srgb8> painted(const LessonUser& user, std::size_t shown, int pane) {
  const World world = user.lesson().world();
  Image<Srgb8> paper(world.columns(), world.rows(), {0, 0, 0, 255});
  user.lesson().course().painter(shown, pane, paper);
  return paper;
}

bool lit(const Image<Srgb8>& paper, int x, int y) {
  return !(paper.at(x, y) == Srgb8{0, 0, 0, 255});
}

const Points kComb = {{0.1, 0.9}, {0.1, 0.2},  {0.3, 0.2}, {0.35, 0.8}, {0.45, 0.8},
                      {0.5, 0.2}, {0.65, 0.2}, {0.7, 0.8}, {0.9, 0.25}, {0.9, 0.9}};

TEST(ClippingLessons, BothPolygonClippersFillWhatLiesInBoth) {
  LessonUser user("polygon-clipping");
  const glm::dvec2 corner = user.share(0.2, 0.7), other(60.5, 40.5);
  user.drag(user.share(0.8, 0.4), other);
  Points comb;
  for (const glm::dvec2& p : kComb) comb.push_back(user.share(p.x, p.y));
  const Points window = {corner, {other.x, corner.y}, other, {corner.x, other.y}};
  for (const int pane : {0, 1}) {
    const Image<Srgb8> paper = painted(user, 1000, pane);
    int inside = 0;
    for (int y = 0; y < paper.height(); ++y) {
      for (int x = 0; x < paper.width(); ++x) {
        const glm::dvec2 middle(x + 0.5, y + 0.5);
        const Standing a = standing(comb, middle), b = standing(window, middle);
        if (std::min(a.distance, b.distance) < 1e-6) continue;
        EXPECT_EQ(lit(paper, x, y), a.inside && b.inside) << x << ',' << y << " of " << pane;
        inside += a.inside && b.inside;
      }
    }
    EXPECT_GT(inside, 300);
  }
}

TEST(ClippingLessons, OnlyDegenerateEdgesTellTheClippersApart) {
  LessonUser user("polygon-clipping");
  const auto& tracks = user.lesson().course().tracks;
  const auto degenerate = only_in(tracks[0], tracks[1]);
  EXPECT_TRUE(only_in(tracks[1], tracks[0]).empty());
  ASSERT_GT(degenerate.size(), 5u);
  const int lower = static_cast<int>(user.share(0.2, 0.7).y);
  for (const Mark& mark : degenerate) EXPECT_EQ(mark.y, lower) << mark.x;
  // A window that holds all of the comb leaves it as it is, both ways.
  LessonUser wide("polygon-clipping");
  wide.drag(wide.share(0.2, 0.7), {1.5, 118.5});
  wide.drag(wide.share(0.8, 0.4), {78.5, 1.5});
  const auto& whole = wide.lesson().course().tracks;
  EXPECT_TRUE(only_in(whole[0], whole[1]).empty());
  EXPECT_TRUE(only_in(whole[1], whole[0]).empty());
  EXPECT_EQ(wide.lesson().course().remarks.at(0), "1 piece beside 1 polygon of 10 corners");
}

TEST(ClippingLessons, CornersAreAddedAndTakenAway) {
  LessonUser user("polygon-clipping");
  for (int i = 0; i < 7; ++i) user.pass({key_down("Backspace")});
  EXPECT_EQ(user.lesson().fault(), "");
  // A triangle a, b, c: its clipped area is convex, so both clippers draw the same.
  EXPECT_TRUE(only_in(user.lesson().course().tracks[0], user.lesson().course().tracks[1]).empty());
  for (int i = 0; i < 9; ++i) user.pass({key_down("Backspace")});
  EXPECT_NE(user.lesson().fault().find("fewer than three corners"), std::string::npos);
  const std::array<glm::dvec2, 3> added = {{{20.5, 50.5}, {75.5, 50.5}, {40.5, 80.5}}};
  for (const glm::dvec2& p : added) {
    InputEvent press = user.mouse(InputKind::kMouseDown, p);
    press.button = MouseButton::kRight;
    user.pass({press});
  }
  EXPECT_EQ(user.lesson().fault(), "");
  EXPECT_GT(user.lesson().course().tracks[1].steps(), 3u);
}

TEST(ClippingLessons, AConcaveClipPolygonIsWeilerAndAthertonsAlone) {
  LessonUser user("polygon-clipping");
  user.pass({key_down("3")});
  const Course& course = user.lesson().course();
  EXPECT_NE(course.remarks.at(0).find("not convex"), std::string::npos);
  EXPECT_EQ(course.tracks[0].steps(), 0u);
  EXPECT_GT(course.tracks[1].steps(), 10u);
}

TEST(ClippingLessons, CharactersAreKeptWhoseCellsAreInside) {
  LessonUser user("text-clipping");
  const double low = user.share(0.18, 0.3).x, high = user.share(0.82, 0.7).x;
  const auto count = [&](auto&& kept) {
    const Track& track = user.lesson().course().tracks.at(0);
    int n = 0;
    for (std::size_t i = 0; i < track.steps(); ++i) {
      if (i == 4) continue;                               // a space has no pieces
      const std::vector<double>& cell = track.values(i);  // from, to, pieces
      EXPECT_EQ(cell[2] > 0, kept(cell[0], cell[1])) << i;
      n += cell[2] > 0;
    }
    return n;
  };
  user.pass({key_down("2")});
  EXPECT_EQ(count([&](double a, double b) { return a >= low && b <= high; }), 4);
  user.pass({key_down("1")});
  EXPECT_EQ(count([](double, double) { return false; }), 0);
  user.type(3, "20");  // now the whole string fits
  user.drag(user.share(0.07, 0.58), {40.5, 70.5});
  EXPECT_EQ(count([](double, double) { return true; }), 6);
}

TEST(ClippingLessons, CurvesAreWhiteInsideAndRedOutside) {
  for (const char* curve : {"1", "2"}) {
    LessonUser user("curve-clipping");
    user.pass({key_down(curve)});
    const glm::dvec2 a = user.share(0.3, 0.75), b = user.share(0.75, 0.25);
    const Points window = {a, {b.x, a.y}, b, {a.x, b.y}};
    Image<Srgb8> paper(static_cast<int>(user.size().x), static_cast<int>(user.size().y));
    const Track& track = user.lesson().course().tracks.at(0);
    track.draw(track.steps(), paper);
    int white = 0, red = 0;
    for (int y = 0; y < paper.height(); ++y) {
      for (int x = 0; x < paper.width(); ++x) {
        const Standing s = standing(window, {x + 0.5, y + 0.5});
        if (s.distance < 1.5) continue;
        const Srgb8 colour = paper.at(x, y);
        if (!(colour == theme::kText || colour == theme::kRed)) continue;
        EXPECT_EQ(colour == theme::kText, s.inside) << x << ',' << y;
        (s.inside ? white : red) += 1;
      }
    }
    EXPECT_GT(white, 20) << curve;
    EXPECT_GT(red, 20) << curve;
  }
}

TEST(ClippingLessons, AWindowGoesOntoAViewport) {
  LessonUser user("window-to-viewport");
  user.type(0, "10, 100");
  user.type(1, "50, 20");
  user.type(2, "5, 90");
  user.type(3, "65, 30");
  const Track &world = user.lesson().course().tracks.at(0),
              &view = user.lesson().course().tracks[1];
  ASSERT_GT(world.steps(), 60u);
  for (std::size_t i = 0; i < world.steps(); ++i) {
    EXPECT_NEAR(view.values(i)[0], 5 + 1.5 * (world.values(i)[0] - 10), 1e-9);
    EXPECT_NEAR(view.values(i)[1], 90 + 0.75 * (world.values(i)[1] - 100), 1e-9);
  }
  for (const Mark& mark : view.all_marks()) {
    EXPECT_TRUE(mark.x >= 5 && mark.x <= 65 && mark.y >= 30 && mark.y <= 90);
  }
  const double first = world.values(0)[0];
  user.pass({key_down("k")});  // the window is half as wide as high: so is the viewport
  const Track& kept = user.lesson().course().tracks.at(1);
  EXPECT_NEAR(kept.values(0)[0], 5 + 0.75 * (first - 10), 1e-9);
}

TEST(ClippingLessons, TheViewingStepsEndWhereAPinholeCameraDoes) {
  LessonUser user("viewing-steps");
  user.type(2, "20");    // up, degrees
  user.type(3, "2.5");   // distance
  user.type(5, "0.75");  // aside
  const glm::dvec3 look_at(0.4, 0.8, -0.6);
  const auto about_y = [](double deg, glm::dvec3 p) {
    const double s = std::sin(deg * std::numbers::pi / 180),
                 c = std::cos(deg * std::numbers::pi / 180);
    return glm::dvec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
  };
  const glm::dvec3 eye = about_y(30, {0, 2.6, 7.5}) + look_at;
  const glm::dvec3 forward = glm::normalize(look_at - eye);
  const glm::dvec3 level = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
  const glm::dvec3 upright = glm::cross(level, forward);
  // Up turned about the line of sight.
  const double s = std::sin(std::numbers::pi / 9), c = std::cos(std::numbers::pi / 9);
  const glm::dvec3 right = c * level - s * upright, up = c * upright + s * level;
  const glm::dvec3 ridge = about_y(20, {0, 1.75, 0.75}) + glm::dvec3(-0.9, 0, 0) - eye;
  const double depth = glm::dot(ridge, forward);
  const glm::dvec2 on_window =
      2.5 / depth * glm::dvec2(glm::dot(ridge, right), glm::dot(ridge, up));
  const Track& track = user.lesson().course().tracks.at(0);
  const std::vector<double>& end = track.values(track.steps() - 1);
  EXPECT_NEAR(end[1], on_window.x - 0.75, 1e-5);
  EXPECT_NEAR(end[2], on_window.y / 0.75, 1e-5);
  // Before the division, w is the depth.
  EXPECT_NEAR(track.values(track.steps() - 3)[4], depth, 1e-5);
  // All of the picture lies within the viewport.
  const Image<Srgb8> picture = painted(user, track.steps(), 1);
  const glm::dvec2 a = user.share(0.1, 0.75), b = user.share(0.9, 0.3);
  int inside = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (!lit(picture, x, y)) continue;
      EXPECT_TRUE(x + 0.5 >= a.x && x + 0.5 <= b.x && y + 0.5 <= a.y && y + 0.5 >= b.y);
      ++inside;
    }
  }
  EXPECT_GT(inside, 200);
}

TEST(ClippingLessons, UpIsAVectorThatAnAngleTurns) {
  LessonUser user("viewing-steps");
  const auto told = [&](const std::string& up) {
    return user.lesson().course().remarks.at(0) == "up (" + up + ") in the world";
  };
  EXPECT_TRUE(told("0.000, 1.000, 0.000"));
  // Once the line of sight lies along -z, up lies along y.
  const Track& track = user.lesson().course().tracks.at(0);
  EXPECT_NE(track.note(23).find("up is now 0.000 "), std::string::npos) << track.note(23);
  EXPECT_NE(track.note(0).find("up is now 0.000 1.000 0.000"), std::string::npos);
  // Its tip is drawn, and moves when the vector is turned.
  const auto tip = [&] {
    for (const Label& label : user.lesson().course().overlay(0).labels) {
      if (label.words == "up") return label.at;
    }
    return glm::dvec2(NAN);
  };
  const glm::dvec2 upright = tip();
  user.type(2, "90");
  EXPECT_FALSE(told("0.000, 1.000, 0.000"));
  EXPECT_GT(glm::distance(tip(), upright), 1);
  EXPECT_EQ(user.lesson().fault(), "");
  LessonUser wrong("viewing-steps");
  wrong.type(6, " 0");
  EXPECT_NE(wrong.lesson().fault(), "") << "four numbers";
}

TEST(ClippingLessons, LookingRoundKeepsTheStep) {
  LessonUser user("viewing-steps");
  user.pass({key_down("End")});
  user.pass({key_down("b")});
  const std::size_t shown = user.lesson().shown();
  ASSERT_GT(shown, 40u);
  const Image<Srgb8> before = painted(user, shown, 0);
  user.drag({30, 30}, {60, 40});  // no handle is there
  user.pass({key_down("Right")});
  user.pass({});
  EXPECT_EQ(user.lesson().shown(), shown);
  EXPECT_NE(hash_picture(painted(user, shown, 0)), hash_picture(before));
  EXPECT_EQ(hash_picture(painted(user, shown, 1)),
            hash_picture(Image<Srgb8>(before.width(), before.height(), {0, 0, 0, 255})));
}

TEST(ClippingLessons, WhatLiesBehindTheEyeIsTurnedRoundUntilItIsClipped) {
  LessonUser user("view-confusion");
  const auto ridge_and_floor = [&] {
    const Track &space = user.lesson().course().tracks.at(0),
                &picture = user.lesson().course().tracks[1];
    glm::dvec2 rows(0);
    for (std::size_t i = 0; i < space.steps(); ++i) {
      if (space.values(i)[1] == 1.75 - 0.8) rows.x = picture.values(i)[1];
      if (space.values(i)[1] == -0.8) rows.y = picture.values(i)[1];
    }
    return rows;
  };
  EXPECT_GT(ridge_and_floor().x, ridge_and_floor().y);  // rows count downwards: upside down
  EXPECT_FALSE(user.lesson().course().tracks[1].all_marks().empty());
  user.pass({key_down("c")});
  EXPECT_TRUE(user.lesson().course().tracks[1].all_marks().empty());
  user.type(0, "-5");
  EXPECT_LT(ridge_and_floor().x, ridge_and_floor().y);
  EXPECT_FALSE(user.lesson().course().tracks[1].all_marks().empty());
}

TEST(ClippingLessons, TwoWireCubesHaveOnePictureUntilLinesAreHidden) {
  LessonUser user("view-confusion");
  user.pass({key_down("3")});
  const auto apart = [&] {
    const auto& tracks = user.lesson().course().tracks;
    return only_in(tracks[0], tracks[1]).size() + only_in(tracks[1], tracks[0]).size();
  };
  EXPECT_EQ(apart(), 0u);
  user.pass({key_down("c")});
  EXPECT_GT(apart(), 100u);
}

}  // namespace
}  // namespace kinescope
