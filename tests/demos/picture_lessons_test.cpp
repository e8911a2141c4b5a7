// Lessons of displays, pictures and characters, used as a user would, beside the library itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "demos/ui/theme.h"
#include "lesson_user.h"
#include "raster/characters/bitmap_font.h"
#include "raster/image/bit_depth.h"

namespace kinescope {
namespace {

bool told(const Lesson& lesson, const std::string& words) {
  const auto& remarks = lesson.course().remarks;
  return std::any_of(remarks.begin(), remarks.end(), [&](const std::string& remark) {
    return remark.find(words) != std::string::npos;
  });
}

std::set<std::pair<int, int>> pixels(const Track& track) {
  std::set<std::pair<int, int>> result;
  for (const Mark& mark : track.all_marks()) result.insert({mark.x, mark.y});
  return result;
}

/// The only pane's picture once all steps are done.
Image<Srgb8> finished(const Lesson& lesson, std::size_t track = 0) {
  const Course& course = lesson.course();
  Image<Srgb8> picture = course.papers.at(0);
  if (track < course.tracks.size()) course.tracks[track].draw(1u << 30, picture);
  return picture;
}

std::size_t count(const Image<Srgb8>& picture, Srgb8 colour) {
  return static_cast<std::size_t>(
      std::count(picture.pixels().begin(), picture.pixels().end(), colour));
}

InputEvent typed(const std::string& words) {
  InputEvent event;
  event.kind = InputKind::kText;
  event.key = words;
  return event;
}

TEST(PictureLessons, BadInputIsToldInThePanel) {
  struct Bad {
    const char* demo;
    int field;
    const char *typed, *told;
  };
  for (const Bad& bad : {Bad{"coordinates", 1, "0", "spacing"},
                         {"coordinates", 2, "100000", "rays"},
                         {"samples", 1, "25", "bits: from 1 to 24"},
                         {"samples", 2, "0", "times"},
                         {"cad-part", 4, "30", "hole"},
                         {"cad-part", 3, "200", "thickness"},
                         {"cad-part", 0, "-1", "above 0"},
                         {"paint", 0, "1000", "width"},
                         {"enhancement", 0, "-2", "amount"},
                         {"charts", 0, "1e308", "finite"}}) {
    LessonUser user(bad.demo);
    user.type(bad.field, bad.typed);
    EXPECT_NE(user.lesson().fault().find(bad.told), std::string::npos)
        << bad.demo << " told \"" << user.lesson().fault() << "\" of " << bad.typed;
    user.pass({});
  }
}

TEST(PictureLessons, APointsPolarCoordinatesAreToldAndBack) {
  LessonUser user("coordinates");
  user.type(0, "-3, 4");
  EXPECT_TRUE(told(user.lesson(), "= 5.000"));
  EXPECT_TRUE(told(user.lesson(), "126.87 degrees"));
  EXPECT_TRUE(told(user.lesson(), "r cos a = -3.000, r sin a = 4.000"));
}

TEST(PictureLessons, APixmapsBitsAndItsFrameBufferAreTold) {
  LessonUser user("samples");
  user.type(1, "16");
  const World world = user.lesson().world();
  const int across = world.columns(), down = world.rows();
  EXPECT_TRUE(told(user.lesson(), "65536 colours (5-6-5)"));
  EXPECT_TRUE(told(user.lesson(), std::to_string(2 * across * down) + " bytes"));
  std::set<int> greens;
  for (const Mark& mark : user.lesson().course().tracks[1].all_marks()) {
    EXPECT_EQ(mark.colour, with_bit_depth(mark.colour, 16));
    greens.insert(mark.colour.g);
  }
  EXPECT_GT(greens.size(), 8u);
  for (const Mark& mark : user.lesson().course().tracks[0].all_marks()) {
    EXPECT_TRUE(mark.colour.g == 0 || mark.colour.g == 255);
  }
}

TEST(PictureLessons, APieRefusesWhatBarsShow) {
  LessonUser user("charts");
  EXPECT_EQ(user.lesson().course().tracks[0].steps(), 5u);
  user.type(1, "-10");
  EXPECT_EQ(user.lesson().fault(), "");
  user.pass({key_down("3")});
  EXPECT_NE(user.lesson().fault().find("negative"), std::string::npos);
  user.type(1, "55");
  EXPECT_EQ(user.lesson().fault(), "");
  EXPECT_NEAR(user.lesson().course().tracks[0].values(1)[1], 100 * 55.0 / 230, 1e-9);
}

TEST(PictureLessons, PaintStaysAndIsTakenBack) {
  LessonUser user("paint");
  const Image<Srgb8> before = finished(user.lesson());
  const auto changed = [&] {
    const Image<Srgb8> now = finished(user.lesson());
    std::set<std::pair<int, int>> places;
    for (int y = 0; y < now.height(); ++y) {
      for (int x = 0; x < now.width(); ++x) {
        if (now.at(x, y) != before.at(x, y)) places.insert({x, y});
      }
    }
    return places;
  };
  user.type(0, "5");
  user.drag({20.5, 30.5}, {60.5, 30.5});
  std::set<std::pair<int, int>> stroke = changed();
  EXPECT_TRUE(stroke.contains({40, 30}) && stroke.contains({20, 32}) && stroke.contains({60, 28}));
  EXPECT_NEAR(static_cast<double>(stroke.size()), 41 * 5 + 16, 12);
  for (const auto& [x, y] : stroke) EXPECT_TRUE(x >= 18 && x <= 62 && y >= 28 && y <= 32);
  user.pass({key_down("u")});
  EXPECT_TRUE(changed().empty());
  // A box is seen while it is stretched, and stays when the button is let go.
  user.pass({key_down("5")});
  user.drag({20.5, 20.5}, {50.5, 40.5});
  stroke = changed();
  EXPECT_TRUE(stroke.contains({20, 30}) && stroke.contains({35, 40}) && !stroke.contains({35, 30}));
  // The fill stays within it, of the colour that the right button picked from the house.
  InputEvent pick = user.mouse(InputKind::kMouseDown, {160.5, 130.5});
  pick.button = MouseButton::kRight;
  user.pass({pick, key_down("3")});
  user.pass({user.mouse(InputKind::kMouseDown, {35.5, 30.5}),
             user.mouse(InputKind::kMouseUp, {35.5, 30.5})});
  EXPECT_EQ(finished(user.lesson()).at(35, 30), before.at(160, 130));
  EXPECT_EQ(finished(user.lesson()).at(60, 30), before.at(60, 30));
  user.pass({key_down("PageDown")});
  EXPECT_EQ(user.lesson().fault(), "") << "another resolution";
}

TEST(PictureLessons, AnOutlineByExclusiveOrLeavesNoTrace) {
  LessonUser user("windows");
  const Image<Srgb8> before = finished(user.lesson());
  const Srgb8 title = before.at(270, 35);
  user.pass({user.mouse(InputKind::kMouseDown, {260.5, 36.5})});
  user.pass({user.mouse(InputKind::kMouseMove, {200.5, 90.5})});
  const std::set<std::pair<int, int>> once = pixels(user.lesson().course().tracks[0]);
  user.pass({user.mouse(InputKind::kMouseMove, {120.5, 150.5})});
  user.pass({user.mouse(InputKind::kMouseMove, {200.5, 90.5})});
  EXPECT_EQ(pixels(user.lesson().course().tracks[0]), once);
  user.pass({user.mouse(InputKind::kMouseUp, {200.5, 90.5})});
  const Image<Srgb8> after = finished(user.lesson());
  EXPECT_EQ(count(after, title), count(before, title));
  EXPECT_EQ(after.at(210, 89), title) << "the window has moved with the mouse";
}

TEST(PictureLessons, AMenuPopsUpAndOpensAndClosesWindows) {
  LessonUser user("windows");
  const std::size_t windows = user.lesson().course().tracks[0].steps();
  const auto choose = [&](glm::dvec2 at, int row) {
    InputEvent event = user.mouse(InputKind::kMouseDown, at);
    event.button = MouseButton::kRight;
    user.pass({event});
    EXPECT_EQ(user.lesson().course().tracks[0].note(user.lesson().course().tracks[0].steps() - 1),
              "the menu; what it hides was saved");
    user.pass({user.mouse(InputKind::kMouseDown, at + glm::dvec2(8, 8 + 14 * row))});
    return user.lesson().course().tracks[0].steps();
  };
  EXPECT_EQ(choose({100.5, 60.5}, 2), windows + 1) << "a new one";
  EXPECT_EQ(choose({40.5, 60.5}, 3), windows) << "the editor is closed";
  EXPECT_EQ(choose({5.5, 200.5}, 3), windows) << "on the desk there is none to close";
}

TEST(PictureLessons, ANegativeIsItsPicturesAndTheMedianTakesSpecksAway) {
  LessonUser user("enhancement");
  for (int i = 0; i < 3; ++i) user.pass({key_down("o")});
  ASSERT_EQ(user.lesson().course().tracks[1].name(), "negative");
  for (const Mark& mark : user.lesson().course().tracks[1].all_marks()) {
    ASSERT_EQ(mark.colour.r, 255 - user.lesson().course().papers[0].at(mark.x, mark.y).r);
  }
  user.pass({key_down("x")});
  for (int i = 0; i < 7; ++i) user.pass({key_down("o")});
  ASSERT_EQ(user.lesson().course().tracks[1].name(), "median");
  const Image<Srgb8>& spoiled = user.lesson().course().papers[0];
  const std::size_t specks = count(spoiled, {0, 0, 0, 255}) + count(spoiled, {255, 255, 255, 255});
  EXPECT_GT(specks, spoiled.pixels().size() / 50);
  std::size_t left = 0;
  for (const Mark& mark : user.lesson().course().tracks[1].all_marks()) {
    left += mark.colour.r == 0 || mark.colour.r == 255;
  }
  EXPECT_LT(left, specks / 20);
}

TEST(PictureLessons, APaletteHasAsManyColoursAsAsked) {
  LessonUser user("dithering");
  user.pass({key_down("i")});
  for (const int colours : {4, 256}) {
    user.type(1, std::to_string(colours));
    const Course& course = user.lesson().course();
    ASSERT_EQ(course.tracks.size(), 4u) << user.lesson().fault();
    // The photograph holds few more than 256 of the colours that the cut tells apart.
    EXPECT_LE(course.tracks[1].steps(), static_cast<std::size_t>(colours));
    EXPECT_GT(static_cast<double>(course.tracks[1].steps()), 0.9 * colours);
    for (const std::size_t track : {2u, 3u}) {
      std::set<int> seen;
      for (const Mark& m : course.tracks[track].all_marks()) {
        seen.insert(m.colour.r << 16 | m.colour.g << 8 | m.colour.b);
      }
      EXPECT_LE(seen.size(), static_cast<std::size_t>(colours));
      EXPECT_GT(seen.size(), static_cast<std::size_t>(colours) / 2);
    }
  }
  user.type(1, "1");
  EXPECT_NE(user.lesson().fault().find("colours: from 2 to 256"), std::string::npos);
}

TEST(PictureLessons, TextIsTakenAsItIsTyped) {
  LessonUser user("characters");
  user.pass({key_down("1")});
  const auto field = user.lesson().place_of_control(Lesson::field_of(2));
  ASSERT_TRUE(field);
  user.pass({mouse_event(InputKind::kMouseDown, static_cast<int>(field->x),
                         static_cast<int>(field->y), MouseButton::kLeft),
             mouse_event(InputKind::kMouseUp, static_cast<int>(field->x),
                         static_cast<int>(field->y), MouseButton::kLeft)});
  user.pass({key_down("Backspace")});
  EXPECT_NE(user.lesson().fault().find("no text"), std::string::npos);
  user.pass({typed("H"), typed("i")});
  ASSERT_TRUE(user.lesson().typing());
  const glm::ivec2 pen(glm::round(glm::dvec2(0.25, 0.75) * user.size()));
  std::set<std::pair<int, int>> expected;
  BitmapFont::fixed().draw("Hi", pen, [&](int x, int y) { expected.insert({x, y}); });
  EXPECT_EQ(pixels(user.lesson().course().tracks[0]), expected);
  EXPECT_TRUE(user.lesson().course().remarks.empty());
  user.pass({typed("\u6f22"), key_down("Return")});
  EXPECT_FALSE(user.lesson().typing());
  for (const char* font : {"1", "2", "3"}) {
    user.pass({key_down(font)});
    EXPECT_TRUE(told(user.lesson(), "lacks 1 of the characters")) << font;
  }
}

TEST(PictureLessons, TheFillsStackIsShownTopFirst) {
  LessonUser user("seed-fill");
  const Track& track = user.lesson().course().tracks[0];
  const std::string note = track.note(0);
  EXPECT_NE(note.find("stack, next first:\n  row"), std::string::npos) << note;
  EXPECT_EQ(track.note(track.steps() - 1).find("stack, next first"), 0u);
  user.pass({key_down("3")});
  EXPECT_NE(user.lesson().course().tracks[0].note(2).find("calls, innermost first:\n  fill("),
            std::string::npos);
}

// The course's worked example: (4, 0) turned by 90 degrees about (-1, 1).
TEST(PictureLessons, ATypedPointTurnsAboutATypedPivot) {
  LessonUser user("transformations");
  user.type(0, "4, 0");
  user.type(3, "-1, 1");
  for (int i = 0; i < 8; ++i) user.pass({key_down("2")});  // eighths of half a right angle
  const Track& track = user.lesson().course().tracks.at(0);
  EXPECT_EQ(track.values(0), (std::vector<double>{4, 0}));
  EXPECT_EQ(track.values(track.steps() - 1), (std::vector<double>{0, 6}));
}

TEST(PictureLessons, EveryReflectionAndShearHasItsMatrix) {
  LessonUser user("transformations");
  std::set<std::string> seen;
  for (int i = 0; i < 12; ++i) {
    const auto& remarks = user.lesson().course().remarks;
    seen.insert(remarks[0] + remarks[1]);
    user.pass({key_down("y")});
  }
  // About a pivot in the origin the chains are the matrices themselves.
  for (const char* matrix : {"[   1.000    0.000    0.000 ][   0.000    1.000    0.000 ]",
                             "[  -1.000    0.000    0.000 ][   0.000   -1.000    0.000 ]",
                             "[   0.000    1.000    0.000 ][   1.000    0.000    0.000 ]",
                             "[  -1.000    0.000    0.000 ][   0.000    1.000    0.000 ]",
                             "[   1.000    0.000    0.000 ][   0.000   -1.000    0.000 ]"}) {
    const auto like = [&](std::string text) {
      for (std::size_t at; (at = text.find("-0.000")) != std::string::npos;) {
        text.replace(at, 6, " 0.000");
      }
      return text == matrix;
    };
    EXPECT_TRUE(std::any_of(seen.begin(), seen.end(), like)) << matrix;
  }
}

}  // namespace
}  // namespace kinescope
