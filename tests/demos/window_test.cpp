// The real program in a real window, on an X server without a screen.
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "demos/ui/theme.h"
#include "raster/image/codecs.h"
#include "tests/sanitized.h"
#include "window_testing.h"

namespace kinescope {
namespace {

TEST_F(ProgramWindow, ShowsTheTeapotAndAnswersKeys) {
  start({"demo", "teapot"});
  ASSERT_TRUE(shown());
  EXPECT_LT(mean_code(shot_), 120);
  // Copper in the middle, night in the corner.
  const Srgb8 middle = shot_.at(320, 260), corner = shot_.at(8, 8);
  EXPECT_GT(middle.r, middle.b + 40);
  EXPECT_LT(corner.r, 40);

  key("t");
  key("space");  // from here only keys change the picture
  ASSERT_TRUE(stands_still());
  const Image<Srgb8> paused = shot_;
  key("Tab");
  EXPECT_TRUE(until([&](const auto& shot) { return changed(shot, paused) > 0.01; })) << "no panel";
  key("Tab");
  EXPECT_TRUE(until([&](const auto& shot) { return changed(shot, paused) < 0.002; }));
  key("question");
  EXPECT_TRUE(until([&](const auto& shot) { return changed(shot, paused) > 0.05; })) << "no help";
  key("question");
  hold("w");  // however long it is held
  key("period");
  key("period");
  EXPECT_TRUE(until([&](const auto& shot) { return changed(shot, paused) > 0.05; }))
      << "no wireframe";
  key("s");
  EXPECT_FALSE(program_->wait(0.5)) << "it left too early";
  key("Escape");
  EXPECT_EQ(program_->wait(kPatience), 0);
  EXPECT_EQ(folder_.files(), (std::vector<std::string>{"kinescope-teapot-0001.png", "said.txt"}));
  EXPECT_EQ(test::read_text(folder_ / "said.txt"), "");
}

/// The most memory that a process has held so far, bytes.
std::size_t peak_memory(pid_t pid) {
  const std::string status = test::read_text("/proc/" + std::to_string(pid) + "/status");
  const std::size_t place = status.find("VmHWM:");
  return place == std::string::npos ? 0 : std::stoul(status.substr(place + 6)) * 1024;
}

TEST_F(ProgramWindow, EscapeLeavesFullScreenFirst) {
  start({"demo", "teapot"});
  ASSERT_TRUE(shown());
  key("F11");
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  key("Escape");
  EXPECT_FALSE(program_->wait(1)) << "Escape left more than full screen";
  ASSERT_TRUE(shown());
  key("Escape");
  EXPECT_EQ(program_->wait(kPatience), 0) << test::read_text(folder_ / "said.txt");
}

TEST_F(ProgramWindow, IsNoLargerThanTheScreen) {
  start({"demo", "lines"}, "1280x960");
  // The side panel reaches the screen's right and nearly its bottom.
  EXPECT_TRUE(until([](const auto& shot) {
    const auto is = [&](int x, int y, Srgb8 colour) {
      const Srgb8 p = shot.at(x, y);
      return std::abs(p.r - colour.r) + std::abs(p.g - colour.g) + std::abs(p.b - colour.b) < 6;
    };
    return shot.width() == 640 && is(636, 300, theme::kPanel) && is(600, 470, theme::kPanel) &&
           is(300, 430, theme::kBackground);
  })) << "part of the window is off the screen";
}

TEST_F(ProgramWindow, HoldsTheTeapotInLittleMemory) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer's own memory would be counted";
  display_.emplace(1280, 960);
  start({"demo", "teapot"}, "1280x960");
  ASSERT_TRUE(shown());
  std::this_thread::sleep_for(std::chrono::seconds(2));
  const std::size_t peak = peak_memory(program_->pid());
  EXPECT_GT(peak, 1'000'000u);
  EXPECT_LT(peak, 150'000'000u);
}

TEST_F(ProgramWindow, ShowsThePlotOfVector) {
  // A frame around the page.
  test::write_text(folder_ / "a.hpgl", "IN;SP1;PA0,0;PD4000,0,4000,3000,0,3000,0,0");
  start({"vector", "a.hpgl"});
  EXPECT_TRUE(until([](const auto& shot) {
    if (shot.width() != 640) return false;
    const auto lit_in_row = [&](int y) {
      int lit = 0;
      for (int x = 0; x < shot.width(); ++x) lit += shot.at(x, y).g > 100;
      return lit;
    };
    return lit_in_row(240) >= 2 && lit_in_row(240) < 20 &&
           std::max(lit_in_row(12), lit_in_row(13)) > 500;
  })) << "no frame";
}

/// A pseudo-terminal that a program printed the name of.
class Line {
 public:
  explicit Line(const std::string& name) : fd_(open(name.c_str(), O_RDWR | O_NOCTTY)) {}
  ~Line() { close(fd_); }
  bool send(const std::string& bytes) const {
    return write(fd_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  }
  std::string receive(std::size_t count) const {
    std::string bytes;
    pollfd ready{fd_, POLLIN, 0};
    char c = 0;
    while (bytes.size() < count && poll(&ready, 1, 10'000) > 0 && read(fd_, &c, 1) == 1) bytes += c;
    return bytes;
  }

 private:
  int fd_;
};

TEST_F(ProgramWindow, ATerminalShowsPagesCopiesAndACrosshair) {
  start_line(
      {"bash", "-c", "exec " KINESCOPE_BIN_DIR "/kinescope vector --pty --size 640x480 > name"});
  std::string name;
  ASSERT_TRUE(until([&](const auto& shot) {
    name = test::read_text(folder_ / "name");
    return name.ends_with('\n') && mean_code(shot) > 8;
  }));
  name.pop_back();
  // A line across the middle, then a page that has as many strokes: a line down the middle.
  const auto lit = [&](int x, int y) {
    int most = 0;
    for (int i = -4; i <= 4; ++i) {
      most = std::max({most, int{shot_.at(x + i, y).g}, int{shot_.at(x, y + i).g}});
    }
    return most > 130;
  };
  std::optional<Line> line(name);
  ASSERT_TRUE(line->send("\x1d,f @,f?_"));
  ASSERT_TRUE(until([&](const auto&) { return lit(160, 240) && lit(500, 240); }));
  ASSERT_TRUE(line->send("\x1b\x0c\x1d `0@8`0@"));
  ASSERT_TRUE(until([&](const auto&) { return lit(320, 100) && !lit(160, 240); }));
  EXPECT_FALSE(lit(500, 240));

  const std::string asked = folder_ / "kinescope-hard-copy-0001.png",
                    pressed = folder_ / "kinescope-hard-copy-0002.png";
  const auto written = [&](const std::string& file) {
    return until([&](const auto&) { return std::filesystem::exists(file); });
  };
  ASSERT_TRUE(line->send("\x1b\x17"));
  ASSERT_TRUE(written(asked));
  key("h");
  ASSERT_TRUE(written(pressed));
  const Image<Srgb8> paper = read_image_file(asked);
  EXPECT_LT(paper.at(320, 100).g, 100);
  EXPECT_GT(paper.at(160, 240).g, 200);
  EXPECT_EQ(changed(paper, read_image_file(pressed)), 0);

  // A key belongs to the crosshair: s saves nothing, Escape does not leave.
  ASSERT_TRUE(line->send("\x1b\x1a"));
  ASSERT_TRUE(until([&](const auto& shot) { return mean_code(shot) > 8; }));
  for (const char* const sent : {"s", "Escape"}) {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    key(sent);
    const std::string answer = line->receive(6);
    ASSERT_EQ(answer.size(), 6u);
    EXPECT_EQ(answer[0], *sent == 's' ? 's' : '\x1b');
    ASSERT_TRUE(line->send("\x1b\x1a"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "kinescope-vector-0001.png"));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  key("Return");
  EXPECT_EQ(line->receive(6).substr(0, 1), "\r");
  key("p");
  EXPECT_TRUE(until([&](const auto&) { return !lit(320, 100); }));

  // The next user is a plotter's.
  line.reset();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  ASSERT_TRUE(Line(name).send("IN;SP1;PA0,0;PD4000,0,4000,3000,0,3000,0,0;"));
  EXPECT_TRUE(until([&](const auto&) { return lit(12, 240) && lit(320, 12); }));
  key("Escape");
  EXPECT_EQ(program_->wait(kPatience), 0) << test::read_text(folder_ / "said.txt");
}

TEST_F(ProgramWindow, ShowsThePictureOfDisplay) {
  start({"display", "pattern:ebu-bars"});
  ASSERT_TRUE(shown());
  const auto like = [](Srgb8 c, bool r, bool g, bool b) {
    return (c.r > 100) == r && (c.g > 100) == g && (c.b > 100) == b;
  };
  EXPECT_TRUE(until([&](const auto& shot) {
    return shot.width() == 640 && like(shot.at(120, 300), true, true, false) &&
           like(shot.at(280, 300), false, true, false) &&
           like(shot.at(600, 300), false, false, false);
  }));
  key("Escape");
  EXPECT_EQ(program_->wait(kPatience), 0) << test::read_text(folder_ / "said.txt");
}

TEST_F(ProgramWindow, GalleryFindsAndStartsADemoAndEscapeReturns) {
  start({});
  ASSERT_TRUE(shown());
  const Image<Srgb8> all = display_->screenshot();
  key("a r e a s");
  ASSERT_TRUE(until([&](const auto& shot) { return changed(shot, all) > 0.05; }));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const Image<Srgb8> gallery = display_->screenshot();
  key("Return");
  ASSERT_TRUE(until([&](const auto& shot) { return changed(shot, gallery) > 0.2; }));
  key("Escape");
  ASSERT_TRUE(until([&](const auto& shot) { return changed(shot, gallery) < 0.2; }));
  EXPECT_FALSE(program_->wait(0.2)) << "Escape left the gallery too";
  key("Escape");  // ends the search
  EXPECT_FALSE(program_->wait(0.2));
  key("Escape");
  EXPECT_EQ(program_->wait(kPatience), 0) << test::read_text(folder_ / "said.txt");
}

}  // namespace
}  // namespace kinescope
