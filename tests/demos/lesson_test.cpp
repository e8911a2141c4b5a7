// Lessons used as a user would use them: dragged, typed, stepped; compared by value.
#include <gtest/gtest.h>

#include <set>

#include "demo_testing.h"
#include "demos/input_script.h"
#include "demos/lesson/lesson.h"
#include "demos/ui/text_field.h"
#include "raster/base/error.h"
#include "raster/line.h"

namespace kinescope {
namespace {

using Pixels = std::set<std::pair<int, int>>;

/// A lesson and what is done to it, an event a refresh.
class Pupil {
 public:
  explicit Pupil(const std::string& name, int width = 320, int height = 240)
      : player_(find_demo(name), small_setup(width, height), 0) {
    pass(1);
  }
  const Lesson& lesson() const { return dynamic_cast<const Lesson&>(player_.demo()); }
  void pass(int refreshes) {
    for (int i = 0; i < refreshes; ++i) player_.forward(player_.demo().refresh().period());
  }
  void give(InputEvent event) {
    player_.forward(player_.demo().refresh().period(), {std::move(event)});
  }
  void key(const std::string& name) { give(key_down(name)); }
  void mouse(InputKind kind, glm::vec2 at, MouseButton button) {
    give(mouse_event(kind, static_cast<int>(at.x), static_cast<int>(at.y), button));
  }
  glm::vec2 place(int x, int y, int pane = 0) const {
    return lesson().place_of(glm::dvec2(x, y) + 0.5, pane);
  }
  void drag(glm::vec2 from, glm::vec2 to, MouseButton button = MouseButton::kLeft) {
    mouse(InputKind::kMouseDown, from, button);
    mouse(InputKind::kMouseMove, (from + to) / 2.0f, button);
    mouse(InputKind::kMouseMove, to, button);
    mouse(InputKind::kMouseUp, to, button);
  }
  void click(glm::vec2 at, MouseButton button = MouseButton::kLeft) {
    mouse(InputKind::kMouseDown, at, button);
    mouse(InputKind::kMouseUp, at, button);
  }
  void type(int field, const std::string& text) {
    type_only(field, text);
    key("Return");
  }
  void type_only(int field, const std::string& text) {
    const auto place = lesson().place_of_control(Lesson::field_of(field));
    ASSERT_TRUE(place.has_value());
    click(*place);
    ASSERT_TRUE(lesson().typing());
    InputEvent event;
    event.kind = InputKind::kText;
    event.key = text;
    give(event);
  }
  Pixels pixels(std::size_t track = 0) const {
    Pixels pixels;
    for (const Mark& mark : lesson().course().tracks.at(track).all_marks()) {
      pixels.insert({mark.x, mark.y});
    }
    return pixels;
  }

 private:
  Player player_;
};

Pixels line(int x0, int y0, int x1, int y1) {
  Pixels pixels;
  bresenham(x0, y0, x1, y1, [&](int x, int y) { pixels.insert({x, y}); });
  return pixels;
}

TEST(Lesson, ADraggedEndGivesTheLibrarysLine) {
  Pupil pupil("lines");
  const Mark first = pupil.lesson().course().tracks[0].all_marks().front();
  pupil.drag(pupil.place(first.x, first.y), pupil.place(3, 20));
  const Mark last = pupil.lesson().course().tracks[0].all_marks().back();
  EXPECT_EQ(pupil.pixels(0), line(3, 20, last.x, last.y));
  EXPECT_EQ(pupil.pixels(1), pupil.pixels(0));
}

TEST(Lesson, TypedEndsGiveTheLibrarysLine) {
  Pupil pupil("practical-1");
  pupil.type(0, "1, 2");
  pupil.type(1, "14 9");
  EXPECT_EQ(pupil.pixels(0), line(1, 2, 14, 9));
  EXPECT_FALSE(pupil.lesson().typing());
}

TEST(Lesson, WhatWasTypedIsTakenWhenTheMouseGoesElsewhere) {
  Pupil pupil("practical-1");
  pupil.type(0, "1, 2");
  pupil.type_only(1, "14 9");
  pupil.click(pupil.place(2, 12));
  EXPECT_EQ(pupil.pixels(0), line(1, 2, 14, 9));
  EXPECT_FALSE(pupil.lesson().typing());
}

TEST(Lesson, TheMiddleIsTheOriginOfPractical3) {
  Pupil pupil("practical-3");
  pupil.type(0, "0, 0");
  pupil.type(1, "5, 3");  // to the right and upwards
  const World world = pupil.lesson().world();
  const int x = world.columns() / 2, y = world.rows() / 2;
  EXPECT_EQ(pupil.pixels(), line(x, y, x + 5, y - 3));
}

TEST(Lesson, KeysTypedIntoAFieldTurnNothing) {
  Pupil pupil("lines");
  pupil.click(*pupil.lesson().place_of_control(Lesson::field_of(0)));
  pupil.key("1");  // else the method
  EXPECT_EQ(pupil.lesson().course().tracks.size(), 2u);
  pupil.key("Escape");
  pupil.key("1");
  EXPECT_EQ(pupil.lesson().course().tracks.size(), 1u);
}

TEST(Lesson, StepsGoForwardAndBack) {
  Pupil pupil("lines");
  pupil.key("End");
  const std::size_t all = pupil.lesson().course().tracks[0].steps();
  EXPECT_EQ(pupil.lesson().shown(), all);
  pupil.key("b");
  EXPECT_EQ(pupil.lesson().shown(), all - 1);
  pupil.pass(30);  // stepping by hand holds it
  EXPECT_EQ(pupil.lesson().shown(), all - 1);
  pupil.key("n");
  EXPECT_EQ(pupil.lesson().shown(), all);
  pupil.key("Home");
  EXPECT_EQ(pupil.lesson().shown(), 0u);
  pupil.key("b");
  EXPECT_EQ(pupil.lesson().shown(), 0u);
}

TEST(Lesson, BadInputIsToldAndKeepsRunning) {
  struct Bad {
    std::string demo;
    int field;
    std::string typed, told;
  };
  for (const Bad& bad : {Bad{"lines", 0, "nan, 3", "no finite number"},
                         {"lines", 0, "seven", "is not a number"},
                         {"lines", 0, "4", "2 numbers belong here, not 1"},
                         {"lines", 0, "9999999999, 3", "beyond a billion"},
                         {"circles", 1, "300000", "radius"},
                         {"circles", 1, "-3", "not negative"},
                         {"conics", 1, "-3", "not negative"},
                         {"seed-fill", 0, "-5, 900", "outside"},
                         {"dithering", 0, "1", "from 2 to 256"},
                         {"antialiasing", 1, "1e300", "from 1 to 1000"},
                         {"characters", 1, "0", "from 1 to 400"}}) {
    Pupil pupil(bad.demo);
    pupil.type(bad.field, bad.typed);
    EXPECT_NE(pupil.lesson().fault().find(bad.told), std::string::npos)
        << bad.demo << " told \"" << pupil.lesson().fault() << "\" of " << bad.typed;
    pupil.pass(2);
  }
}

TEST(Lesson, ALineWithoutLengthIsOnePixelAndSaysSo) {
  Pupil pupil("lines");
  pupil.type(0, "4, 4");
  pupil.type(1, "4, 4");
  EXPECT_EQ(pupil.pixels(), (Pixels{{4, 4}}));
  EXPECT_NE(pupil.lesson().course().remarks[0].find("no length"), std::string::npos);
}

TEST(Lesson, ALineTooLongToWatchIsRefused) {
  Pupil pupil("lines");
  pupil.type(1, "300000, 4");
  EXPECT_NE(pupil.lesson().fault().find("steps"), std::string::npos);
}

TEST(Lesson, CircleOfRadius10IsTheBooks) {
  Pupil pupil("practical-2");
  pupil.type(1, "10");
  const std::vector<std::pair<double, double>> book = {{0, 10}, {1, 10}, {2, 10}, {3, 10},
                                                       {4, 9},  {5, 9},  {6, 8},  {7, 7}};
  const Track& track = pupil.lesson().course().tracks[0];
  ASSERT_EQ(track.steps(), book.size());
  for (std::size_t i = 0; i < book.size(); ++i) {
    EXPECT_EQ(std::pair(track.values(i)[0], track.values(i)[1]), book[i]);
  }
}

TEST(Lesson, RubberBandStretchesMovesAndStays) {
  Pupil pupil("practical-4");
  pupil.drag(pupil.place(2, 1), pupil.place(20, 5));
  EXPECT_EQ(pupil.pixels(), line(2, 1, 20, 5));
  pupil.key("Right");
  pupil.key("Down");
  EXPECT_EQ(pupil.pixels(), line(3, 2, 21, 6));
  pupil.click(pupil.place(10, 10), MouseButton::kRight);
  pupil.drag(pupil.place(2, 20), pupil.place(30, 25));
  EXPECT_EQ(pupil.pixels(), line(2, 20, 30, 25));
  for (const auto& [x, y] : line(3, 2, 21, 6)) {
    EXPECT_EQ(pupil.lesson().course().papers[0].at(x, y), theme::kText) << x << "," << y;
  }
}

TEST(Lesson, PolygonWithoutCornersAsksForThem) {
  Pupil pupil("practical-8");
  pupil.key("c");
  EXPECT_NE(pupil.lesson().fault().find("no corners"), std::string::npos);
  for (const auto& [x, y] : {std::pair(2, 2), {20, 2}, {20, 12}, {2, 12}}) {
    pupil.click(pupil.place(x, y));
  }
  // From corner to corner between the middles of pixels: the upper and the left edge are in.
  EXPECT_EQ(pupil.pixels().size(), 18u * 10u);
  EXPECT_TRUE(pupil.lesson().fault().empty());
}

TEST(Lesson, RecursiveFillOverflowsAndIsStoppedByPaint) {
  Pupil pupil("seed-fill");
  const std::size_t whole = pupil.pixels().size();
  pupil.key("3");
  EXPECT_LT(pupil.pixels().size(), whole);
  EXPECT_NE(pupil.lesson().course().remarks[0].find("overflowed"), std::string::npos);
}

TEST(TextField, EditsWholeCharacters) {
  TextField field;
  field.set("a\u00e9");
  field.answer(key_down("Left"));
  EXPECT_EQ(field.caret, 1u);
  field.answer(key_down("Delete"));
  EXPECT_EQ(field.text, "a");
  field.answer(key_down("Backspace"));
  field.answer(key_down("Backspace"));
  EXPECT_EQ(field.text, "");
  EXPECT_FALSE(field.answer(key_down("F1")));
}

TEST(TextField, ReadsNumbersAsTheyAreTyped) {
  EXPECT_EQ(typed_numbers("(3, -4.5)", 2), (std::vector<double>{3, -4.5}));
  EXPECT_THROW(typed_numbers("1e999", 1), Error);
  EXPECT_THROW(typed_numbers("inf", 1), Error);
  EXPECT_THROW(typed_numbers("", 1), Error);
}

}  // namespace
}  // namespace kinescope
