// Films in a real window, on an X server without a screen.
#include <fstream>

#include "window_testing.h"

namespace kinescope {
namespace {

/// Seconds of plain colour, one picture a second: red, green, blue.
std::string colours_y4m() {
  std::string film = "YUV4MPEG2 W16 H12 F1:1 C444\n";
  const int planes[3][3] = {{81, 90, 240}, {145, 54, 34}, {41, 240, 110}};
  for (const auto& colour : planes) {
    film += "FRAME\n";
    for (const int value : colour) film += std::string(16 * 12, static_cast<char>(value));
  }
  return film;
}

/// 'r', 'g' or 'b', whichever the middle of the screen shows.
char hue(const Image<Srgb8>& shot) {
  if (shot.empty()) return ' ';
  const Srgb8 c = shot.at(320, 200);
  if (c.r > 100 && c.g < 100 && c.b < 100) return 'r';
  if (c.g > 100 && c.r < 100 && c.b < 100) return 'g';
  return c.b > 100 && c.r < 100 && c.g < 100 ? 'b' : ' ';
}

class FilmWindow : public ProgramWindow {
 protected:
  std::string film() {
    const std::string path = folder_ / "colours.y4m";
    test::write_text(path, colours_y4m());
    return path;
  }
  bool shows(char wanted) {
    return until([&](const auto& shot) { return hue(shot) == wanted; });
  }
  long lines_said() const {
    const std::string text = said();
    return std::count(text.begin(), text.end(), '\n');
  }
  std::string said() const { return test::read_text(folder_ / "said.txt"); }
};

TEST_F(FilmWindow, PlaysAFileAndAnswersKeys) {
  start({"display", film()});
  ASSERT_TRUE(shows('r')) << said();
  EXPECT_TRUE(shows('g'));
  key("space");
  ASSERT_TRUE(stands_still());
  EXPECT_EQ(hue(shot_), 'g');
  const Image<Srgb8> paused = shot_;
  key("question");
  EXPECT_TRUE(until([&](const auto& shot) { return changed(shot, paused) > 0.05; })) << "no help";
  key("question");
  key("s");
  EXPECT_TRUE(until([&](const auto&) {
    return std::filesystem::exists(folder_ / "kinescope-display-0001.png");
  }));
  key("space");
  EXPECT_TRUE(shows('b'));
  EXPECT_FALSE(program_->wait(0.5)) << "it left at the film's end";
  key("Escape");
  EXPECT_EQ(program_->wait(kPatience), 0) << said();
  EXPECT_EQ(said(), "");
}

TEST_F(FilmWindow, SlowsTimeDown) {
  start({"display", film()});
  ASSERT_TRUE(shows('r')) << said();
  for (int i = 0; i < 9; ++i) key("bracketleft");  // a thousandth
  const char at_first = hue(display_->screenshot());
  std::this_thread::sleep_for(std::chrono::seconds(2));
  EXPECT_FALSE(program_->wait(0));
  // A refresh lasts 17 s now: a part of the screen is lit.
  shot_ = display_->screenshot();
  EXPECT_LT(mean_code(shot_), 60);
  for (int i = 0; i < 9; ++i) key("bracketright");
  EXPECT_TRUE(shows(at_first == 'b' ? 'b' : at_first == 'g' ? 'b' : 'g'));
  key("Escape");
  EXPECT_EQ(program_->wait(kPatience), 0) << said();
}

TEST_F(FilmWindow, AnswersKeysThoughStandardInputStalls) {
  const std::string stalled = "exec " KINESCOPE_BIN_DIR
                              "/kinescope display - --size 640x480 < <(cat " +
                              film() + "; exec sleep 30)";
  start_line({"bash", "-c", stalled});
  ASSERT_TRUE(shows('g')) << said();
  key("Escape");
  EXPECT_EQ(program_->wait(5), 0) << said();
}

TEST_F(FilmWindow, PlaysRawVideoFromAPipe) {
  const std::string raw = folder_ / "film.rgb";
  std::string bytes;
  for (int i = 0; i < 16 * 12; ++i) bytes += std::string("\x00\x00\xff", 3);
  test::write_text(raw, bytes);
  start_line({"bash", "-c",
              "exec " KINESCOPE_BIN_DIR
              "/kinescope display - --raw rgb24:16x12@25 --size 640x480 < <(cat " +
                  raw + ")"});
  EXPECT_TRUE(shows('b')) << said();
  key("Escape");
  EXPECT_EQ(program_->wait(kPatience), 0) << said();
}

TEST_F(FilmWindow, AFilmThatEndsWithinAFrameIsNamed) {
  const std::string path = film();
  const std::string whole = test::read_text(path);
  test::write_text(path, whole.substr(0, whole.size() - 100));
  start({"display", path});
  EXPECT_EQ(program_->wait(kPatience), 3);
  EXPECT_NE(said().find("colours.y4m"), std::string::npos) << said();
  EXPECT_EQ(lines_said(), 1);
}

TEST_F(FilmWindow, HasNoRateButItsMonitors) {
  start({"display", film(), "--fps", "24"});
  EXPECT_EQ(program_->wait(kPatience), 2);
  EXPECT_NE(said().find("--fps"), std::string::npos) << said();
  EXPECT_EQ(lines_said(), 1) << said();
}

TEST_F(FilmWindow, SaysWhereTheMonitorIsTooSlowForSlices) {
  start({"display", "pattern:smpte-bars", "--shutter", "1/4000"});
  ASSERT_TRUE(shown());
  key("Escape");
  EXPECT_EQ(program_->wait(kPatience), 0) << said();
  EXPECT_NE(said().find("kinescope: slices of 0.00025 s do not fit this monitor's "),
            std::string::npos)
      << said();
  EXPECT_EQ(lines_said(), 1) << said();
}

}  // namespace
}  // namespace kinescope
