#include "demos/tube_view.h"

#include "demo_testing.h"
#include "display/video_mode.h"

namespace kinescope {
namespace {

/// The mean light of the middle of a picture, as a code.
int mean_code(const Image<Srgb8>& picture) {
  double sum = 0;
  int count = 0;
  for (int y = picture.height() / 4; y < picture.height() * 3 / 4; ++y) {
    for (int x = picture.width() / 4; x < picture.width() * 3 / 4; ++x, ++count) {
      sum += decode(picture.at(x, y)).g;
    }
  }
  const auto light = static_cast<float>(sum / count);
  return encode_srgb8(LinearRgb{light, light, light}).g;
}

TEST(TubeView, ShowsTheTonesOfTheBarePicture) {
  Workers& workers = test_studio()->workers;
  for (const std::uint8_t code : {20, 60, 128, 200, 250}) {
    Image<Srgb8> drawn;
    const auto render = [&](int width, int height) -> const Image<Srgb8>& {
      drawn = Image<Srgb8>(width, height, {code, code, code, 255});
      return drawn;
    };
    TubeView view({parse_mode("640x480@60")}, {0, 0, 160, 120});
    Image<Srgb8> tube(160, 120), bare(160, 120);
    for (int step = 0; step < 6; ++step) {
      const Seconds period = view.refresh().period();
      view.expose({{step * period, (step + 1) * period}, {}}, workers, render, tube);
    }
    EXPECT_EQ(drawn.width(), 640);
    EXPECT_NEAR(mean_code(tube), code, 2);
    view.draw_bare(render, bare);
    EXPECT_EQ(drawn.width(), 160);
    EXPECT_EQ(mean_code(bare), code);
  }
}

/// Whoever turns the display off and on sees sharpness change, not tones.
TEST(TubeView, TheTeapotKeepsItsTones) {
  Image<Srgb8> seen[2];
  for (const bool bare : {false, true}) {
    Player player(find_demo("teapot"), small_setup(320, 240), 0);
    const Seconds period = player.demo().refresh().period();
    std::vector<InputEvent> keys = {key_down("t")};
    if (bare) keys.push_back(key_down("d"));
    player.forward(period, keys);
    for (int i = 0; i < 5; ++i) player.forward(period);
    seen[bare] = player.picture();
  }
  EXPECT_NEAR(mean_code(seen[0]), mean_code(seen[1]), 3);
  EXPECT_NEAR(seen[0].at(160, 8).g, seen[1].at(160, 8).g, 3);  // the night above it
}

}  // namespace
}  // namespace kinescope
