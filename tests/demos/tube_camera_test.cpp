#include "demos/tube_camera.h"

#include <gtest/gtest.h>

#include "display/tube/preset.h"

namespace kinescope {
namespace {

TubeSettings small_tube() {
  TubeSettings settings = tube_presets().front().settings;
  settings.mode = {"small", 360000, {64, 8, 12, 16}, {48, 2, 2, 8}, false};  // 60 Hz
  return settings;
}

float mean_green(const Image<LinearRgb>& light) {
  double sum = 0;
  for (const LinearRgb c : light.pixels()) sum += c.g;
  return static_cast<float>(sum / static_cast<double>(light.pixels().size()));
}

TEST(TubeCamera, SteadyWhiteIsSteadyFromTheFirstExposure) {
  Workers workers(2);
  const Image<Srgb8> white(64, 48, {255, 255, 255, 255});
  TubeCamera camera(
      small_tube(), 64, 48, [&](std::int64_t) -> const auto& { return white; }, workers);
  const Seconds T = camera.refresh().period();
  const float first = mean_green(camera.expose({Seconds(0), T}));
  const float second = mean_green(camera.expose({T, 2 * T}));
  EXPECT_NEAR(first, 1, 0.05);  // the spot spreads a little over the edges
  EXPECT_NEAR(first, second, 1e-3);
}

TEST(TubeCamera, EachRefreshShowsItsOwnPicture) {
  Workers workers(2);
  const Image<Srgb8> white(64, 48, {255, 255, 255, 255}), black(64, 48);
  std::vector<std::int64_t> asked;
  TubeCamera camera(
      small_tube(), 64, 48,
      [&](std::int64_t refresh) -> const auto& {
        asked.push_back(refresh);
        return refresh == 2 ? white : black;
      },
      workers);
  const Seconds T = camera.refresh().period();
  const auto light = [&](double begin, double end) {
    return mean_green(camera.expose({begin * T, end * T}));
  };
  EXPECT_LT(light(0, 1), 1e-3);
  EXPECT_LT(light(1, 2), 1e-3);
  EXPECT_GT(light(2, 3), 0.5);
  EXPECT_LT(light(3, 4), 0.5);
  EXPECT_EQ(asked, (std::vector<std::int64_t>{0, 1, 2, 3}));
}

TEST(TubeCamera, LongExposuresAddUpAndUnseenTimePasses) {
  Workers workers(2);
  const Image<Srgb8> white(64, 48, {255, 255, 255, 255});
  const auto source = [&](std::int64_t) -> const auto& { return white; };
  TubeCamera whole(small_tube(), 64, 48, source, workers);
  TubeCamera parts(small_tube(), 64, 48, source, workers);
  const Seconds T = whole.refresh().period();
  const float three = mean_green(whole.expose({1.25 * T, 4.25 * T}));
  float sum = mean_green(parts.expose({1.25 * T, 2 * T}));
  sum += mean_green(parts.expose({2 * T, 3.5 * T}));
  sum += mean_green(parts.expose({3.5 * T, 4.25 * T}));
  EXPECT_NEAR(three, sum, 1e-4);
  EXPECT_NEAR(three, 3, 0.15);
}

}  // namespace
}  // namespace kinescope
