#include "raster/colour/pack_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace kinescope {
namespace {

std::vector<Srgb8> pixels_that_differ(std::size_t count) {
  std::vector<Srgb8> pixels(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto code = [i](std::size_t k) { return static_cast<std::uint8_t>(31 * i + k); };
    pixels[i] = {code(7), code(101), code(190), code(3)};
  }
  return pixels;
}

TEST(PackWords, PutsEachChannelWhereTheLayoutSays) {
  const std::vector<Srgb8> in = {{0x12, 0x34, 0x56, 0x78}};
  std::vector<std::uint32_t> out(1);
  pack_words(in, {16, 8, 0}, out);
  EXPECT_EQ(out[0], 0x00123456u);
  pack_words(in, {0, 8, 16}, out);
  EXPECT_EQ(out[0], 0x00563412u);
  pack_words(in, {24, 16, 8}, out);
  EXPECT_EQ(out[0], 0x12345600u);
}

TEST(PackWords, WritesEveryCountAndNothingPastIt) {
  for (std::size_t count = 0; count < 40; ++count) {
    const std::vector<Srgb8> in = pixels_that_differ(count);
    std::vector<std::uint32_t> out(count + 1, 0xdeadbeefu), wanted(count + 1, 0xdeadbeefu);
    for (std::size_t i = 0; i < count; ++i) {
      wanted[i] = 65536u * in[i].r + 256u * in[i].g + in[i].b;
    }
    pack_words(in, {}, out);
    EXPECT_THAT(out, testing::ElementsAreArray(wanted)) << count;
  }
}

}  // namespace
}  // namespace kinescope
