#include "demos/picture.h"

#include <gtest/gtest.h>

#include <set>

namespace kinescope {
namespace {

TEST(Picture, FitsWithinAndKeepsItsShape) {
  EXPECT_EQ(fit_within({1280, 960}, 4.0 / 3), (Size{1280, 960}));
  EXPECT_EQ(fit_within({1000, 300}, 4.0 / 3), (Size{400, 300}));
  EXPECT_EQ(fit_within({300, 1000}, 4.0 / 3), (Size{300, 225}));
  EXPECT_EQ(fit_within({1, 1}, 4.0 / 3), (Size{1, 1}));
  EXPECT_EQ(fit_within({1000, 1}, 4.0 / 3), (Size{1, 1}));
}

TEST(Picture, CentredOnBlack) {
  const Image<Srgb8> white(2, 1, {255, 255, 255, 255});
  const Image<Srgb8> out = centre_on_black(white, {4, 3});
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      const bool inside = y == 1 && (x == 1 || x == 2);
      EXPECT_EQ(out.at(x, y), inside ? white.at(0, 0) : Srgb8{}) << x << " " << y;
    }
  }
}

TEST(Picture, HashDependsOnEveryChannelPlaceAndShape) {
  std::set<std::uint64_t> hashes;
  hashes.insert(hash_picture(Image<Srgb8>(6, 4)));
  hashes.insert(hash_picture(Image<Srgb8>(4, 6)));
  hashes.insert(hash_picture(Image<Srgb8>(24, 1)));
  for (int place = 0; place < 24; ++place) {
    for (int channel = 0; channel < 4; ++channel) {
      Image<Srgb8> picture(6, 4);
      Srgb8& c = picture.at(place % 6, place / 6);
      std::uint8_t* const channels[] = {&c.r, &c.g, &c.b, &c.a};
      *channels[channel] ^= 1;
      hashes.insert(hash_picture(picture));
    }
  }
  EXPECT_EQ(hashes.size(), 3u + 24 * 4);
}

TEST(Picture, SixteenBitsOfLinearLight) {
  Workers workers(1);
  Image<LinearRgba> light(3, 1);
  light.at(0, 0) = {0, 0.5f, 1, 1};
  light.at(1, 0) = {2, -1, 0.001f, 0.5f};
  const Image<Srgb16> out = encode_picture16(light, workers);
  EXPECT_EQ(out.at(0, 0), (Srgb16{0, encode_srgb16({0.5f, 0, 0}).r, 65535, 65535}));
  EXPECT_EQ(out.at(1, 0).r, 65535);
  EXPECT_EQ(out.at(1, 0).g, 0);
  EXPECT_EQ(out.at(1, 0).a, 32768);
}

}  // namespace
}  // namespace kinescope
