// A program of ours in a window on an X server without a screen.
#pragma once

#include <chrono>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "demo_testing.h"
#include "program_run.h"
#include "virtual_display.h"

namespace kinescope {

using test::Child;
using test::VirtualDisplay;

inline constexpr double kPatience = 40;  // seconds, for a slow machine

inline double mean_code(const Image<Srgb8>& picture) {
  double sum = 0;
  for (const Srgb8 c : picture.pixels()) sum += c.r + c.g + c.b;
  return picture.empty() ? 0 : sum / (3.0 * static_cast<double>(picture.pixels().size()));
}

/// The share of pixels that differ by more than a few codes.
inline double changed(const Image<Srgb8>& a, const Image<Srgb8>& b) {
  if (a.pixels().size() != b.pixels().size()) return 1;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Srgb8 p = a.pixels()[i], q = b.pixels()[i];
    count += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) > 12;
  }
  return static_cast<double>(count) / static_cast<double>(a.pixels().size());
}

class ProgramWindow : public ::testing::Test {
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
    start_line(line);
  }
  void start_line(const std::vector<std::string>& line) {
    program_.emplace(line,
                     std::vector<std::string>{"DISPLAY=" + display_->name(), "SDL_VIDEODRIVER=x11",
                                              "SDL_AUDIODRIVER=dummy"},
                     folder_.path().string());
  }
  void key(const std::string& name) { display_->tool("xdotool key " + name); }
  /// Until it has repeated itself many times.
  void hold(const std::string& name) {
    display_->tool("xdotool keydown " + name + " sleep 1.2 keyup " + name);
  }

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

}  // namespace kinescope
