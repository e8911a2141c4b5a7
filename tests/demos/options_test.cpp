#include "demos/options.h"

#include <gtest/gtest.h>

#include "raster/base/error.h"

namespace kinescope {
namespace {

TEST(Options, Sizes) {
  EXPECT_EQ(parse_size("640x480", "--size"), (Size{640, 480}));
  EXPECT_EQ(parse_size("1x1", "--size"), (Size{1, 1}));
  EXPECT_EQ(parse_size("32768x32768", "--size"), (Size{32768, 32768}));
  for (const char* bad : {"", "x", "640", "640x", "x480", "0x1", "1x0", "32769x1", "1x32769",
                          "640 x480", "640x480x3", "+1x1", "1e3x5", "99999999999x1"}) {
    EXPECT_THROW(parse_size(bad, "--size"), Error) << bad;
  }
}

TEST(Options, FramesAreACountOrARange) {
  EXPECT_EQ(parse_frames("60", "--frames").first, 0);
  EXPECT_EQ(parse_frames("60", "--frames").last, 59);
  EXPECT_EQ(parse_frames("7-9", "--frames").count(), 3);
  EXPECT_EQ(parse_frames("0-0", "--frames").count(), 1);
  for (const char* bad : {"", "0", "-1", "5-", "-5", "5-4", "1-2-3", "a-b", "99999999999"}) {
    EXPECT_THROW(parse_frames(bad, "--frames"), Error) << bad;
  }
}

TEST(Options, RatesAreExact) {
  const auto expect = [](const char* text, std::int64_t over, std::int64_t under) {
    const Rate rate = parse_rate(text, "--fps");
    EXPECT_EQ(rate.numerator, over) << text;
    EXPECT_EQ(rate.denominator, under) << text;
  };
  expect("60", 60, 1);
  expect("60000/1001", 60000, 1001);
  expect("120/2", 60, 1);
  expect("59.94", 2997, 50);
  expect("0.5", 1, 2);
  for (const char* bad : {"", "0", "-60", "60/0", "60/", "/60", "nan", "inf", "1e9", "60fps"}) {
    EXPECT_THROW(parse_rate(bad, "--fps"), Error) << bad;
  }
}

TEST(Options, Shutter) {
  EXPECT_EQ(parse_shutter("frame", "--shutter"), std::nullopt);
  EXPECT_DOUBLE_EQ(parse_shutter("1/240", "--shutter")->count(), 1.0 / 240);
  EXPECT_DOUBLE_EQ(parse_shutter("0.004", "--shutter")->count(), 0.004);
  for (const char* bad : {"", "0", "-1", "1/0", "frames", "1e9", "nan"}) {
    EXPECT_THROW(parse_shutter(bad, "--shutter"), Error) << bad;
  }
}

TEST(Options, Vectors) {
  EXPECT_EQ(parse_vector("1,2.5,-3", "--eye"), glm::vec3(1, 2.5f, -3));
  for (const char* bad : {"", "1", "1,2", "1,2,", "1,2,3,4", "a,b,c", "1,nan,2", "1, 2, 3"}) {
    EXPECT_THROW(parse_vector(bad, "--eye"), Error) << bad;
  }
}

TEST(Options, MessagesNameTheOptionAndTheText) {
  try {
    parse_whole("two", "--threads", 1, 8);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "--threads: \"two\" is not a whole number from 1 to 8");
    EXPECT_EQ(error.exit_code(), 2);
  }
}

}  // namespace
}  // namespace kinescope
