// A demo's screen: its panel, its help, its transport.
#include <filesystem>

#include "demo_testing.h"
#include "demos/demo_screen.h"
#include "raster/image/codecs.h"

namespace kinescope {
namespace {

void run(Screen& screen, int ticks) {
  for (int i = 0; i < ticks; ++i) screen.tick(60);
}

class EveryPanel : public EveryDemo {};

class DemoWithPanel : public ::testing::Test {
 protected:
  DemoScreen screen{find_demo("pipeline"), small_setup(640, 480)};  // the panel needs room
  std::uint64_t hash() const { return hash_picture(screen.frame()); }
  void press(const std::string& key) {
    screen.handle(key_down(key));
    run(screen, 1);
  }
};

TEST_F(DemoWithPanel, PauseStepsAndTimeScale) {
  run(screen, 3);
  EXPECT_EQ(screen.player().steps(), 3);
  press("Space");
  run(screen, 3);
  EXPECT_EQ(screen.player().steps(), 3);
  press(".");
  EXPECT_EQ(screen.player().steps(), 4);
  press(",");
  press(",");
  EXPECT_EQ(screen.player().steps(), 2);
  EXPECT_FALSE(screen.tick(60)) << "a paused screen is not drawn again";
  press("[");
  press("Space");
  EXPECT_DOUBLE_EQ(screen.transport().time_scale(), 0.5);
}

TEST_F(DemoWithPanel, PanelAndHelpLieOverThePictureAndGoAgain) {
  run(screen, 2);
  press("Space");
  const auto bare = hash();
  press("Tab");
  const auto panel = hash();
  EXPECT_NE(bare, panel);
  press("Tab");
  EXPECT_EQ(bare, hash());
  press("?");
  EXPECT_NE(bare, hash());
  EXPECT_NE(panel, hash());
  press("?");
  EXPECT_EQ(bare, hash());
}

TEST_P(EveryPanel, EveryKnobCanBeTurnedOnThePanel) {
  const auto demo = info().create(small_setup());
  Image<Srgb8> frame(640, 900);
  Panel panel;
  panel.lay(info(), *demo, *test_studio(), frame);
  // Wherever on the panel a click lands, it turns one knob at most; all of them are found.
  std::set<std::string> turned;
  for (int y = 0; y < frame.height(); y += 4) {
    for (int x = 0; x < frame.width(); x += 16) {
      const std::vector<std::string> keys = panel.click(x, y, demo->knobs());
      EXPECT_TRUE(keys.empty() || panel.contains(x, y)) << x << ", " << y;
      std::set<std::string> owners;
      for (const std::string& key : keys) {
        for (Knob knob : demo->knobs()) {
          if (knob.answer(key)) owners.insert(knob.name);
        }
      }
      EXPECT_LE(owners.size(), 1u) << x << ", " << y;
      turned.merge(owners);
    }
  }
  EXPECT_EQ(turned.size(), demo->knobs().size());
}

INSTANTIATE_TEST_SUITE_P(Panel, EveryPanel, ::testing::ValuesIn(demo_names()), test_name);

TEST_F(DemoWithPanel, AClickOnThePanelTurnsAKnob) {
  press("Tab");
  const std::span<const Knob> knobs = screen.player().demo().knobs();
  ASSERT_EQ(knobs[1].kind, KnobKind::kToggle);
  const bool before = knobs[1].on();
  for (int y = 30; y < 240 && screen.player().demo().knobs()[1].on() == before; y += 6) {
    screen.handle(mouse_event(InputKind::kMouseDown, 620, y, MouseButton::kLeft));
    screen.handle(mouse_event(InputKind::kMouseUp, 620, y, MouseButton::kLeft));
    run(screen, 1);
  }
  EXPECT_NE(screen.player().demo().knobs()[1].on(), before);
}

TEST_F(DemoWithPanel, ADragOnThePanelDoesNotReachTheDemo) {
  press("t");  // nothing turns by itself
  run(screen, 1);
  press("Tab");
  const auto before = screen.player().picture();
  screen.handle(mouse_event(InputKind::kMouseDown, 620, 14, MouseButton::kLeft));
  screen.handle(mouse_event(InputKind::kMouseMove, 300, 200));
  screen.handle(mouse_event(InputKind::kMouseUp, 300, 200, MouseButton::kLeft));
  run(screen, 1);
  EXPECT_EQ(before, screen.player().picture());
  screen.handle(mouse_event(InputKind::kMouseDown, 300, 200, MouseButton::kLeft));
  screen.handle(mouse_event(InputKind::kMouseMove, 260, 220));
  run(screen, 1);
  EXPECT_NE(before, screen.player().picture());
}

// A slow program finds many keys between two ticks.
TEST_F(DemoWithPanel, EachPressOfAStepsKeyIsAStep) {
  run(screen, 3);
  for (const char* key : {".", ".", "."}) screen.handle(key_down(key));
  run(screen, 5);
  EXPECT_EQ(screen.player().steps(), 6);
  for (const char* key : {",", ","}) screen.handle(key_down(key));
  run(screen, 5);
  EXPECT_EQ(screen.player().steps(), 4);
  InputEvent held = key_down(".");
  held.repeated = true;
  for (int i = 0; i < 4; ++i) screen.handle(held);
  run(screen, 5);
  EXPECT_EQ(screen.player().steps(), 5) << "what is held does not run on when it is let go";
}

TEST_F(DemoWithPanel, ResizesToItsWindow) {
  screen.handle(mouse_event(InputKind::kResize, 300, 200));
  screen.handle(mouse_event(InputKind::kResize, 320, 260));
  run(screen, 1);
  EXPECT_EQ(screen.frame().width(), 320);
  EXPECT_EQ(screen.frame().height(), 260);
}

TEST_F(DemoWithPanel, SavesThePictureWithoutThePanel) {
  namespace fs = std::filesystem;
  const fs::path home = fs::current_path();
  const fs::path folder = fs::path(::testing::TempDir()) / "kinescope-saves";
  fs::remove_all(folder);
  fs::create_directories(folder);
  fs::current_path(folder);
  press("Tab");
  press("s");
  press("s");
  fs::current_path(home);
  EXPECT_TRUE(fs::exists(folder / "kinescope-pipeline-0002.png"));
  const auto saved = read_image_file((folder / "kinescope-pipeline-0001.png").string());
  EXPECT_EQ(saved.width(), 640);
  EXPECT_EQ(distinct_colours(saved, 0, 0, 640, 480) > 100, true);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace kinescope
