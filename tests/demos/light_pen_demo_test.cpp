// The light pen's demo: ink appears where the pen is, and only where there is light.
#include <cmath>

#include "demo_testing.h"

namespace kinescope {
namespace {

constexpr int kWidth = 640, kHeight = 480;

/// Drags the pen from one place to another over a second, and shows what is on the tube then.
Image<Srgb8> drag(std::vector<InputEvent> first, int x0, int y0, int x1, int y1) {
  Player player(find_demo("light-pen-raster"), small_setup(kWidth, kHeight), 0);
  const Seconds refresh = player.demo().refresh().period();
  first.push_back(key_down("g"));                               // no chart over the picture,
  first.push_back(mouse_event(InputKind::kMouseMove, x0, y0));  // nor the pen's own figure
  player.forward(refresh, std::move(first));
  constexpr int kSteps = 40;
  for (int i = 0; i <= kSteps; ++i) {
    const int x = x0 + (x1 - x0) * i / kSteps, y = y0 + (y1 - y0) * i / kSteps;
    const bool down = i == 0;
    player.forward(refresh, {mouse_event(down ? InputKind::kMouseDown : InputKind::kMouseMove, x, y,
                                         down ? MouseButton::kLeft : MouseButton::kNone)});
  }
  // The pen is taken away, so that its ring hides nothing.
  player.forward(refresh, {mouse_event(InputKind::kMouseUp, 5, 5, MouseButton::kLeft)});
  for (int i = 0; i < 3; ++i) player.forward(refresh);
  return player.picture();
}

/// How far from the line from a to b the ink is at most, and how much of it there is.
struct Ink {
  double farthest = 0;
  int pixels = 0;
};
Ink ink_about(const Image<Srgb8>& picture, int x0, int y0, int x1, int y1) {
  Ink ink;
  const double dx = x1 - x0, dy = y1 - y0, length = std::hypot(dx, dy);
  for (int y = 40; y < kHeight - 40; ++y) {
    for (int x = 40; x < kWidth - 40; ++x) {
      const Srgb8 c = picture.at(x, y);
      if (c.r < c.b + 40) continue;
      const double along = ((x - x0) * dx + (y - y0) * dy) / length;
      const double beside = std::abs((x - x0) * dy - (y - y0) * dx) / length;
      const double beyond = std::max({0.0, -along, along - length});
      ink.farthest = std::max(ink.farthest, std::hypot(beside, beyond));
      ++ink.pixels;
    }
  }
  return ink;
}

TEST(LightPenDemo, DrawsWhereThePenIs) {
  for (const auto& [x0, y0, x1, y1] :
       {std::array{100, 100, 500, 300}, std::array{500, 400, 150, 390},
        std::array{320, 80, 330, 420}}) {
    const Ink ink = ink_about(drag({}, x0, y0, x1, y1), x0, y0, x1, y1);
    EXPECT_GT(ink.pixels, 600) << x0 << "," << y0;
    EXPECT_LT(ink.farthest, 6) << x0 << "," << y0;
  }
}

TEST(LightPenDemo, DrawsNothingInTheDark) {
  const std::vector<InputEvent> darken(20, key_down("1"));
  EXPECT_EQ(ink_about(drag(darken, 100, 100, 500, 300), 100, 100, 500, 300).pixels, 0);
}

TEST(LightPenDemo, AnUncorrectedLagDrawsBesideThePen) {
  // A bright screen, half of whose light trips the pen; an amplifier of 1 us.
  std::vector<InputEvent> keys(18, key_down("8"));
  keys.insert(keys.end(), 10, key_down("2"));
  keys.insert(keys.end(), 20, key_down("6"));
  const double corrected = ink_about(drag(keys, 300, 100, 300, 400), 300, 100, 300, 400).farthest;
  keys.push_back(key_down("d"));
  const double lagging = ink_about(drag(keys, 300, 100, 300, 400), 300, 100, 300, 400).farthest;
  EXPECT_LT(corrected, 6);
  EXPECT_GT(lagging, corrected + 2);
}

TEST(LightPenDemo, OnARollingPictureInkTrailsFromThePen) {
  Player player(find_demo("light-pen-raster"), small_setup(kWidth, kHeight), 0);
  const Seconds refresh = player.demo().refresh().period();
  std::vector<InputEvent> first(5, key_down("0"));  // the hold is off by half a hertz
  first.push_back(key_down("g"));
  first.push_back(mouse_event(InputKind::kMouseDown, 300, 240, MouseButton::kLeft));
  player.forward(refresh, std::move(first));
  for (int i = 0; i < 24; ++i) player.forward(refresh);
  // Taken away, so that neither it nor its mark lies there.
  player.forward(refresh, {mouse_event(InputKind::kMouseUp, 5, 5, MouseButton::kLeft)});
  player.forward(refresh);
  // The pen was held still: what it has drawn rolls on, a line of the picture's 525 * 0.5 a second.
  const Ink ink = ink_about(player.picture(), 300, 240, 300, 240 + 525 * 25 / 120);
  EXPECT_GT(ink.pixels, 200);
  EXPECT_LT(ink.farthest, 8);
}

}  // namespace
}  // namespace kinescope
