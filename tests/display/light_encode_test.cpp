#include "display/light_encode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/display/tube_fixtures.h"

namespace kinescope {
namespace {

Image<LinearRgb> ramp() {
  Image<LinearRgb> light(50, 37);
  for (int y = 0; y < 37; ++y) {
    for (int x = 0; x < 50; ++x) {
      light.at(x, y) = {static_cast<float>(x) / 40, static_cast<float>(y) / 36, -0.1f};
    }
  }
  return light;
}

TEST(LightEncode, EncodesEveryPixelWithItsGain) {
  const Image<LinearRgb> light = ramp();
  Workers workers(2);
  Image<Srgb8> eight;
  Image<Srgb16> sixteen(1, 1);
  for (const float gain : {1.0f, 0.25f, 3.0f}) {
    encode_light(light, ExposureGain::fixed(gain), workers, eight);
    encode_light(light, ExposureGain::fixed(gain), workers, sixteen);
    for (int y = 0; y < 37; ++y) {
      for (int x = 0; x < 50; ++x) {
        const LinearRgb p = light.at(x, y);
        const LinearRgb scaled{p.r * gain, p.g * gain, p.b * gain};
        ASSERT_EQ(eight.at(x, y), encode_srgb8(scaled)) << x << "," << y;
        ASSERT_NEAR(sixteen.at(x, y).g, encode_srgb16(scaled).g, 1);
        ASSERT_EQ(sixteen.at(x, y).b, 0);
      }
    }
  }
}

TEST(LightEncode, AverageGainMakesSteadyWhiteWhiteAtAnyLength) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, 0xffffff);
  Workers workers(1);
  for (const int frames : {1, 2, 15}) {
    RasterTube tube = cell_tube(mode, "P22");
    tube.expose(buffer, 30 * mode.frame_period(), workers);
    const Seconds begin = tube.now();
    const auto& light = tube.expose(buffer, (30 + frames) * mode.frame_period(), workers);
    Image<Srgb8> picture;
    encode_light(light, ExposureGain::average({begin, tube.now()}, mode.frame_period()), workers,
                 picture);
    EXPECT_EQ(picture.at(5, 5), (Srgb8{255, 255, 255})) << frames;
  }
}

}  // namespace
}  // namespace kinescope
