#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "raster/base/error.h"
#include "raster/image/codecs.h"
#include "tests/raster/scratch.h"

namespace kinescope {
namespace {

using testing::Scratch;

Image<Srgb8> colourful(int width, int height, int seed) {
  Image<Srgb8> picture(width, height);
  unsigned n = static_cast<unsigned>(seed);
  for (Srgb8& p : picture.pixels()) {
    n = n * 1103515245u + 12345u;
    p = {static_cast<std::uint8_t>(n >> 8), static_cast<std::uint8_t>(n >> 14),
         static_cast<std::uint8_t>(n >> 20), 255};
  }
  // The corners of the colour cube are the extremes of every plane.
  for (int i = 0; i < std::min(8, width); ++i) {
    picture.at(i, 0) = {static_cast<std::uint8_t>(i & 1 ? 255 : 0),
                        static_cast<std::uint8_t>(i & 2 ? 255 : 0),
                        static_cast<std::uint8_t>(i & 4 ? 255 : 0), 255};
  }
  return picture;
}

// ITU-R BT.601-7, 2.5: analogue weights, then the quantization of 8 bits.
struct Ycc {
  double y, cb, cr;
};
Ycc bt601(Srgb8 p) {
  const double r = p.r / 255.0, g = p.g / 255.0, b = p.b / 255.0;
  const double y = 0.299 * r + 0.587 * g + 0.114 * b;
  return {16 + 219 * y, 128 + 224 * (b - y) / 1.772, 128 + 224 * (r - y) / 1.402};
}

TEST(Y4m, HeaderAndPlanesAreThoseOfTheFormat) {
  const Scratch scratch;
  const std::string path = scratch.path("film.y4m");
  const int width = 17, height = 5;
  const std::vector<Image<Srgb8>> frames{colourful(width, height, 1), colourful(width, height, 2)};
  Y4mWriter film(path, width, height, Rate{120000, 2002});
  for (const Image<Srgb8>& frame : frames) film.write(frame);
  EXPECT_FALSE(std::filesystem::exists(path));
  film.close();
  const std::string bytes = Scratch::text(path);
  const std::string header =
      "YUV4MPEG2 W17 H5 F60000:1001 Ip A1:1 C444 XCOLORRANGE=LIMITED XMATRIX=601\n";
  const std::size_t plane = static_cast<std::size_t>(width * height), frame_size = 6 + 3 * plane;
  ASSERT_EQ(bytes.size(), header.size() + 2 * frame_size);
  EXPECT_EQ(bytes.substr(0, header.size()), header);
  for (std::size_t f = 0; f < 2; ++f) {
    const std::string frame = bytes.substr(header.size() + f * frame_size, frame_size);
    EXPECT_EQ(frame.substr(0, 6), "FRAME\n");
    for (std::size_t i = 0; i < plane; ++i) {
      const Ycc expected = bt601(frames[f].pixels()[i]);
      const auto at = [&](std::size_t p) {
        return static_cast<std::uint8_t>(frame[6 + p * plane + i]);
      };
      // Rounded, of weights with 16 binary places.
      ASSERT_NEAR(at(0), expected.y, 0.51);
      ASSERT_NEAR(at(1), expected.cb, 0.51);
      ASSERT_NEAR(at(2), expected.cr, 0.51);
    }
  }
}

TEST(Y4m, GreyIsExactlyGreyAndWhiteIs235) {
  const Scratch scratch;
  const std::string path = scratch.path("film.y4m");
  Image<Srgb8> greys(256, 1);
  for (int x = 0; x < 256; ++x) {
    const auto v = static_cast<std::uint8_t>(x);
    greys.at(x, 0) = {v, v, v, 255};
  }
  Y4mWriter film(path, 256, 1, Rate{25, 1});
  film.write(greys);
  film.close();
  const std::string bytes = Scratch::text(path);
  const std::string planes = bytes.substr(bytes.size() - 3 * 256);
  EXPECT_EQ(static_cast<std::uint8_t>(planes[0]), 16);
  EXPECT_EQ(static_cast<std::uint8_t>(planes[255]), 235);
  EXPECT_EQ(planes.substr(256), std::string(512, '\x80'));
}

TEST(Y4m, WithoutCloseNothingRemains) {
  const Scratch scratch;
  {
    Y4mWriter film(scratch.path("film.y4m"), 8, 8, Rate{60, 1});
    film.write(Image<Srgb8>(8, 8));
  }
  EXPECT_EQ(scratch.file_count(), 0);
}

TEST(Y4m, SaysThatTheDiskIsFull) {
  try {
    Y4mWriter film("/dev/full", 640, 480, Rate{60, 1});
    film.write(Image<Srgb8>(640, 480));
    film.close();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kCannotWrite);
    EXPECT_THAT(error.what(), ::testing::StartsWith("/dev/full: "));
  }
}

TEST(Y4m, FfmpegReadsTheSameColours) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) {
    if (std::getenv("KINESCOPE_REQUIRE_DATA")) FAIL() << "ffmpeg is required";
    GTEST_SKIP() << "ffmpeg is not here";
  }
  const Scratch scratch;
  const std::string path = scratch.path("film.y4m"), raw = scratch.path("film.rgb");
  const Image<Srgb8> frame = colourful(64, 48, 3);
  Y4mWriter film(path, 64, 48, Rate{60000, 1001});
  film.write(frame);
  film.write(frame);
  film.close();
  const std::string command =
      "ffmpeg -v error -sws_flags accurate_rnd -i " + path + " -f rawvideo -pix_fmt rgb24 " + raw;
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string bytes = Scratch::text(raw);
  ASSERT_EQ(bytes.size(), 2u * 64 * 48 * 3);
  for (std::size_t i = 0; i < frame.pixels().size(); ++i) {
    const Srgb8 p = frame.pixels()[i];
    // Half a code of each plane, times the weights of the way back.
    ASSERT_NEAR(static_cast<std::uint8_t>(bytes[3 * i]), p.r, 2);
    ASSERT_NEAR(static_cast<std::uint8_t>(bytes[3 * i + 1]), p.g, 2);
    ASSERT_NEAR(static_cast<std::uint8_t>(bytes[3 * i + 2]), p.b, 3);
  }
}

}  // namespace
}  // namespace kinescope
