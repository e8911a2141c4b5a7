#include "display/frame_buffer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "raster/base/error.h"

namespace kinescope {
namespace {

using ::testing::ElementsAre;

constexpr PixelFormat kFormats[] = {
    PixelFormat::kIndexed1, PixelFormat::kIndexed2, PixelFormat::kIndexed4, PixelFormat::kIndexed8,
    PixelFormat::kRgb565,   PixelFormat::kRgb888,   PixelFormat::kXrgb8888};

std::vector<GunDrive> line_of(const FrameBuffer& buffer, int line) {
  std::vector<GunDrive> drives(static_cast<std::size_t>(buffer.width()));
  buffer.read_line(line, drives);
  return drives;
}

TEST(FrameBuffer, EveryFormatKeepsEveryPixelApart) {
  for (const PixelFormat format : kFormats) {
    const int bits = bits_per_pixel(format);
    const std::uint32_t mask = bits == 32 ? 0xffffffffu : (1u << bits) - 1u;
    FrameBuffer buffer(13, 5, format, 3);
    EXPECT_EQ(buffer.pitch_bytes(), (13 * bits + 7) / 8);
    std::mt19937 random(7);
    std::vector<std::uint32_t> stored;
    for (int page = 0; page < 3; ++page) {
      for (int i = 0; i < 13 * 5; ++i) {
        stored.push_back(static_cast<std::uint32_t>(random()) & mask);
        buffer.set_pixel(page, i % 13, i / 13, stored.back());
      }
    }
    std::size_t next = 0;
    for (int page = 0; page < 3; ++page) {
      for (int i = 0; i < 13 * 5; ++i) {
        ASSERT_EQ(buffer.pixel(page, i % 13, i / 13), stored[next++]) << bits << " bits, " << i;
      }
    }
  }
}

TEST(FrameBuffer, MemoryHoldsTheLeftmostPixelInTheHighestBits) {
  FrameBuffer one(9, 1, PixelFormat::kIndexed1);
  one.set_pixel(0, 0, 0, 1);
  one.set_pixel(0, 8, 0, 1);
  EXPECT_THAT(one.memory(0), ElementsAre(0x80, 0x80));
  FrameBuffer two(3, 1, PixelFormat::kIndexed2);
  two.set_pixel(0, 1, 0, 3);
  EXPECT_THAT(two.memory(0), ElementsAre(0x30));
  FrameBuffer four(2, 1, PixelFormat::kIndexed4);
  four.set_pixel(0, 1, 0, 0xa);
  EXPECT_THAT(four.memory(0), ElementsAre(0x0a));
  FrameBuffer deep(1, 1, PixelFormat::kRgb565);
  deep.set_pixel(0, 0, 0, 0x1234);
  EXPECT_THAT(deep.memory(0), ElementsAre(0x34, 0x12));
  FrameBuffer true_colour(1, 1, PixelFormat::kRgb888);
  true_colour.set_pixel(0, 0, 0, 0x123456);
  EXPECT_THAT(true_colour.memory(0), ElementsAre(0x56, 0x34, 0x12));
}

TEST(FrameBuffer, TablesStartAsGreysAndAsACube) {
  const FrameBuffer one(1, 1, PixelFormat::kIndexed1), two(1, 1, PixelFormat::kIndexed2);
  const FrameBuffer four(1, 1, PixelFormat::kIndexed4), eight(1, 1, PixelFormat::kIndexed8);
  EXPECT_EQ(one.colour(0), (GunDrive{0, 0, 0}));
  EXPECT_EQ(one.colour(1), (GunDrive{255, 255, 255}));
  EXPECT_EQ(two.colour(1), (GunDrive{85, 85, 85}));
  EXPECT_EQ(four.colour(15), (GunDrive{255, 255, 255}));
  EXPECT_EQ(four.colour(1), (GunDrive{17, 17, 17}));
  EXPECT_EQ(eight.colour(36 * 5 + 6 * 1 + 2), (GunDrive{255, 51, 102}));
  EXPECT_EQ(eight.colour(215), (GunDrive{255, 255, 255}));
  EXPECT_EQ(eight.colour(216), (GunDrive{6, 6, 6}));
  EXPECT_EQ(eight.colour(255), (GunDrive{249, 249, 249}));
}

TEST(FrameBuffer, StoresPicturesInTrueColour) {
  Image<Srgb8> picture(2, 1);
  picture.at(0, 0) = {255, 128, 3, 255};
  picture.at(1, 0) = {0, 255, 200, 255};
  for (const PixelFormat format : {PixelFormat::kRgb888, PixelFormat::kXrgb8888}) {
    FrameBuffer buffer(2, 1, format);
    buffer.store(0, picture);
    EXPECT_THAT(line_of(buffer, 0), ElementsAre(GunDrive{255, 128, 3}, GunDrive{0, 255, 200}));
  }
  FrameBuffer coarse(2, 1, PixelFormat::kRgb565);
  coarse.store(0, picture);
  // To the nearest of 31 or 63 steps: 128 -> 32/63 -> 130, 3 -> 0, 200 -> 24/31 -> 197.
  EXPECT_THAT(line_of(coarse, 0), ElementsAre(GunDrive{255, 130, 0}, GunDrive{0, 255, 197}));
}

TEST(FrameBuffer, PagesFlipAtRetraceOrAtOnce) {
  FrameBuffer buffer(1, 1, PixelFormat::kIndexed1, 3);
  buffer.set_pixel(1, 0, 0, 1);
  EXPECT_EQ(buffer.hidden_page(), 1);
  buffer.flip_at_retrace(1);
  EXPECT_EQ(line_of(buffer, 0)[0].r, 0);
  buffer.vertical_retrace();
  EXPECT_EQ(line_of(buffer, 0)[0].r, 255);
  EXPECT_EQ(buffer.hidden_page(), 2);
  buffer.flip_now(0);
  EXPECT_EQ(buffer.visible_page(), 0);
  // The latest request counts, and flip_now drops one that waits.
  buffer.flip_at_retrace(1);
  buffer.flip_at_retrace(2);
  buffer.vertical_retrace();
  EXPECT_EQ(buffer.visible_page(), 2);
  buffer.flip_at_retrace(1);
  buffer.flip_now(0);
  buffer.vertical_retrace();
  EXPECT_EQ(buffer.visible_page(), 0);
}

TEST(FrameBuffer, TheTableChangesAtAnyLine) {
  FrameBuffer buffer(1, 6, PixelFormat::kIndexed4);
  const GunDrive red{255, 0, 0}, blue{0, 0, 255}, green{0, 255, 0};
  buffer.set_colour(0, red);
  buffer.set_colour_at_line(4, 0, green);
  buffer.set_colour_at_line(2, 0, blue);
  std::vector<GunDrive> seen;
  for (int line = 0; line < 6; ++line) seen.push_back(line_of(buffer, line)[0]);
  EXPECT_THAT(seen, ElementsAre(red, red, blue, blue, green, green));
  EXPECT_EQ(buffer.colour(0), red);
  buffer.set_colour_at_line(2, 0, red);  // the later call on the same line wins
  EXPECT_EQ(line_of(buffer, 3)[0], red);
  buffer.clear_line_changes();
  EXPECT_EQ(line_of(buffer, 5)[0], red);
}

TEST(FrameBuffer, LinesEndWithBlackWhereTheReaderWantsMore) {
  FrameBuffer buffer(2, 1, PixelFormat::kIndexed1);
  buffer.set_pixel(0, 1, 0, 1);
  std::vector<GunDrive> drives(4, GunDrive{9, 9, 9});
  buffer.read_line(0, drives);
  EXPECT_THAT(drives, ElementsAre(GunDrive{}, GunDrive{255, 255, 255}, GunDrive{}, GunDrive{}));
}

TEST(FrameBuffer, RefusesSizesThatAreNone) {
  EXPECT_THROW(FrameBuffer(0, 5, PixelFormat::kIndexed8), Error);
  EXPECT_THROW(FrameBuffer(5, -1, PixelFormat::kIndexed8), Error);
  EXPECT_THROW(FrameBuffer(1000000000, 1000000000, PixelFormat::kIndexed8), Error);
}

}  // namespace
}  // namespace kinescope
