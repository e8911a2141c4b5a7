// Every demo at sizes that leave no room for what it draws beside its picture.
#include <array>
#include <limits>

#include "demo_testing.h"
#include "demos/ui/canvas.h"

namespace kinescope {
namespace {

class EverySize : public EveryDemo {};

TEST_P(EverySize, IsDrawnAndShrunkTo) {
  constexpr std::array<std::array<int, 2>, 7> kSizes = {
      {{320, 240}, {1, 1}, {1, 2}, {640, 1}, {640, 20}, {2048, 1}, {1, 2048}}};
  const auto studio = std::make_shared<Studio>(2);
  // Made at its size, or brought to it by the window.
  const std::unique_ptr<Demo> resized = info().create({studio, 320, 240, 1});
  Seconds now(0);
  for (const auto& [width, height] : kSizes) {
    const std::unique_ptr<Demo> made = info().create({studio, width, height, 1});
    Image<Srgb8> picture;
    for (int step = 0; step < 2; ++step) {
      const Seconds length = step_length(info(), *made);
      made->step({{step * length, (step + 1) * length}, {}}, picture);
      EXPECT_EQ(picture.width(), width);
      EXPECT_EQ(picture.height(), height);
    }
    const Seconds end = now + step_length(info(), *resized);
    resized->step({{now, end}, {mouse_event(InputKind::kResize, width, height)}}, picture);
    EXPECT_EQ(picture.width(), width);
    EXPECT_EQ(picture.height(), height);
    now = end;
  }
}

INSTANTIATE_TEST_SUITE_P(Demos, EverySize, ::testing::ValuesIn(demo_names()), test_name);

TEST(Room, ShrinksToItsCentreAtMost) {
  const Rect room{10, 20, 8, 2};
  const Rect less = room.shrunk(3), more = room.shrunk(-1);
  EXPECT_EQ(less.x, 13);
  EXPECT_EQ(less.width, 2);
  EXPECT_EQ(less.y, 21);
  EXPECT_EQ(less.height, 0);
  EXPECT_EQ(more.y, 19);
  EXPECT_EQ(more.height, 4);
}

TEST(Clip, HoldsWhatLiesOutsideOrNowhere) {
  Image<Srgb8> picture(4, 3, {0, 0, 0, 255});
  const Image<Srgb8> before = picture;
  Canvas canvas(picture);
  canvas.set_clip({4.5f, -7, 3, 2});  // beside the picture
  canvas.fill({-100, -100, 1000, 1000}, {255, 255, 255, 255});
  EXPECT_EQ(hash_picture(picture), hash_picture(before));
  canvas.clear_clip();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  canvas.disc({nan, nan}, 3, {255, 255, 255, 255});
  canvas.line({nan, 1}, {3, nan}, 3, {255, 255, 255, 255});
  canvas.fill({-1e30f, -1e30f, 2e30f, 2e30f}, {255, 255, 255, 255});
  EXPECT_EQ(hash_picture(picture), hash_picture(Image<Srgb8>(4, 3, {255, 255, 255, 255})));
}

}  // namespace
}  // namespace kinescope
