#include "demos/gamma_correction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

TEST(GammaCorrection, TheTubesLightIsThePictures) {
  constexpr double kGamma = 2.35;
  Image<Srgb8> ramp(256, 1);
  for (int i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i);
    ramp.at(i, 0) = {code, static_cast<std::uint8_t>(255 - i), 0, 255};
  }
  Workers workers(2);
  GammaCorrection correct(kGamma);
  const Image<Srgb8>& drive = correct(ramp, workers);
  const auto light = [](double code) { return std::pow(std::max(0.0, code) / 255, kGamma); };
  for (int i = 0; i < 256; ++i) {
    const double wanted = srgb_decode(static_cast<float>(i) / 255);
    const int got = drive.at(i, 0).r;
    // No neighbouring drive comes nearer in drive.
    EXPECT_GE(wanted, light(got - 0.501)) << i;
    EXPECT_LE(wanted, light(got + 0.501)) << i;
    EXPECT_EQ(drive.at(i, 0).g, drive.at(255 - i, 0).r);
    EXPECT_EQ(drive.at(i, 0).b, 0);
  }
  EXPECT_EQ(drive.at(255, 0).r, 255);
}

}  // namespace
}  // namespace kinescope
