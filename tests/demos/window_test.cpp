// The real program in a real window, on an X server without a screen.
#include <chrono>
#include <thread>

#include "tests/sanitized.h"
#include "window_testing.h"

namespace kinescope {
namespace {

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
  if (kSanitized) GTEST_SKIP() << "a sanitizer's own memory would be counted";
  display_.emplace(1280, 960);
  start({"demo", "teapot"}, "1280x960");
  ASSERT_TRUE(shown());
  std::this_thread::sleep_for(std::chrono::seconds(2));
  const std::size_t peak = peak_memory(program_->pid());
  EXPECT_GT(peak, 1'000'000u);
  EXPECT_LT(peak, 150'000'000u);
}

TEST_F(Window, ShowsThePlotOfVector) {
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

TEST_F(Window, GalleryFindsAndStartsADemoAndEscapeReturns) {
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
