// The real program in a real window, on an X server without a screen.
#include <chrono>
#include <cstdlib>
#include <functional>
#include <thread>

#include "demo_testing.h"
#include "program_run.h"
#include "virtual_display.h"

namespace kinescope {
namespace {

using test::Child;
using test::VirtualDisplay;

constexpr double kPatience = 40;  // seconds, for a slow machine

double mean_code(const Image<Srgb8>& picture) {
  double sum = 0;
  for (const Srgb8 c : picture.pixels()) sum += c.r + c.g + c.b;
  return picture.empty() ? 0 : sum / (3.0 * static_cast<double>(picture.pixels().size()));
}

/// The share of pixels that differ by more than a few codes.
double changed(const Image<Srgb8>& a, const Image<Srgb8>& b) {
  if (a.pixels().size() != b.pixels().size()) return 1;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Srgb8 p = a.pixels()[i], q = b.pixels()[i];
    count += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) > 12;
  }
  return static_cast<double>(count) / static_cast<double>(a.pixels().size());
}

class Window : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!VirtualDisplay::available()) {
      if (std::getenv("KINESCOPE_REQUIRE_DATA") != nullptr)
        FAIL() << "Xvfb, xdotool or import missing";
      GTEST_SKIP() << "needs Xvfb, xdotool and ImageMagick's import";
    }
    display_.emplace(640, 480);
    ASSERT_FALSE(display_->name().empty()) << "Xvfb did not start";
  }

  void start(const std::vector<std::string>& arguments, const std::string& size = "640x480") {
    std::vector<std::string> line{KINESCOPE_BIN_DIR "/kinescope"};
    line.insert(line.end(), arguments.begin(), arguments.end());
    line.insert(line.end(), {"--size", size});
    program_.emplace(line,
                     std::vector<std::string>{"DISPLAY=" + display_->name(), "SDL_VIDEODRIVER=x11",
                                              "SDL_AUDIODRIVER=dummy"},
                     folder_.path().string());
  }
  void key(const std::string& name) { display_->tool("xdotool key " + name); }

  /// Looks until the screen is as wanted, or patience ends.
  bool until(const std::function<bool(const Image<Srgb8>&)>& wanted) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kPatience);
    while (std::chrono::steady_clock::now() < end) {
      shot_ = display_->screenshot();
      if (wanted(shot_)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }
  /// Looks until the picture stands still: a slow program takes its time to hear a key.
  bool stands_still() {
    Image<Srgb8> before;
    int same = 0;
    return until([&](const auto& shot) {
      same = changed(shot, before) == 0 ? same + 1 : 0;
      before = shot;
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      return same == 3;
    });
  }
  ::testing::AssertionResult shown() {
    if (until([](const Image<Srgb8>& shot) { return mean_code(shot) > 8; })) {
      return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure()
           << "the screen stayed dark: " << shot_.width() << "x" << shot_.height() << " of mean "
           << mean_code(shot_) << ", exit code " << program_->wait(0).value_or(-1) << ", files "
           << ::testing::PrintToString(folder_.files()) << ", "
           << test::read_text(folder_ / "said.txt");
  }

  test::TemporaryFolder folder_;
  std::optional<VirtualDisplay> display_;
  std::optional<Child> program_;
  Image<Srgb8> shot_;
};

TEST_F(Window, ShowsTheTeapotAndAnswersKeys) {
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
  key("w");
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

TEST_F(Window, EscapeLeavesFullScreenFirst) {
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

TEST_F(Window, HoldsTheTeapotInLittleMemory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer's own memory would be counted";
#endif
  display_.emplace(1280, 960);
  start({"demo", "teapot"}, "1280x960");
  ASSERT_TRUE(shown());
  std::this_thread::sleep_for(std::chrono::seconds(2));
  const std::size_t peak = peak_memory(program_->pid());
  EXPECT_GT(peak, 1'000'000u);
  EXPECT_LT(peak, 150'000'000u);
}

TEST_F(Window, ShowsThePictureOfDisplay) {
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

TEST_F(Window, GalleryStartsADemoAndEscapeReturns) {
  start({});
  ASSERT_TRUE(shown());
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const Image<Srgb8> gallery = display_->screenshot();
  key("Right");
  key("Down");
  key("Return");  // a demo of the second row
  ASSERT_TRUE(until([&](const auto& shot) { return changed(shot, gallery) > 0.2; }));
  key("Escape");
  ASSERT_TRUE(until([&](const auto& shot) { return changed(shot, gallery) < 0.2; }));
  EXPECT_FALSE(program_->wait(0.2)) << "Escape left the gallery too";
  key("Escape");
  EXPECT_EQ(program_->wait(kPatience), 0) << test::read_text(folder_ / "said.txt");
}

}  // namespace
}  // namespace kinescope
