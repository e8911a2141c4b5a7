// What frames of video look like, beside the formulas of ITU-R BT.601 and BT.709 in doubles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "raster/image/codecs.h"
#include "tests/raster/scratch.h"
#include "tests/raster/y4m_bytes.h"

namespace kinescope {
namespace {

using testing::film_of;
using testing::first_frame;
using testing::Scratch;

/// A plane of samples, and where its first one lies among luma's.
struct Plane {
  int width, height, across, down;
  double x, y;
  std::vector<int> codes;
  /// By weighing the four samples around a place, each by its nearness.
  double at(double luma_x, double luma_y) const {
    const double px = (luma_x - x) / across, py = (luma_y - y) / down;
    double sum = 0;
    for (int j = static_cast<int>(std::floor(py)); j <= std::floor(py) + 1; ++j) {
      for (int i = static_cast<int>(std::floor(px)); i <= std::floor(px) + 1; ++i) {
        const double weight =
            std::max(0.0, 1 - std::abs(px - i)) * std::max(0.0, 1 - std::abs(py - j));
        const int cx = std::clamp(i, 0, width - 1), cy = std::clamp(j, 0, height - 1);
        sum += weight * codes[static_cast<std::size_t>(cy * width + cx)];
      }
    }
    return sum;
  }
};

struct Case {
  const char* name;
  int across, down;
  double blue_x, blue_y, red_x, red_y;
  int bits = 8;
  bool full = false;
  bool bt709 = false;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Decoded : public ::testing::TestWithParam<Case> {};

TEST_P(Decoded, IsWhatTheFormulasSay) {
  const Case& c = GetParam();
  constexpr int kWidth = 13, kHeight = 9;
  std::mt19937 random(7);
  const auto plane = [&](int across, int down, double x, double y) {
    Plane p{(kWidth + across - 1) / across, (kHeight + down - 1) / down, across, down, x, y, {}};
    std::uniform_int_distribution<int> code(0, (1 << c.bits) - 1);
    for (int i = 0; i < p.width * p.height; ++i) p.codes.push_back(code(random));
    return p;
  };
  const Plane luma = plane(1, 1, 0, 0), blue = plane(c.across, c.down, c.blue_x, c.blue_y),
              red = plane(c.across, c.down, c.red_x, c.red_y);
  std::string bytes;
  for (const Plane* p : {&luma, &blue, &red}) {
    for (const int code : p->codes) {
      bytes += static_cast<char>(code & 255);
      if (c.bits > 8) bytes += static_cast<char>(code >> 8);
    }
  }
  const std::string header = std::string("YUV4MPEG2 W13 H9 F25:1 Ip C") + c.name +
                             (c.full ? " XCOLORRANGE=FULL" : "") + (c.bt709 ? " XMATRIX=709" : "");
  const Image<Srgb8> frame = first_frame(film_of(header, bytes));
  ASSERT_EQ(frame.width(), kWidth);
  ASSERT_EQ(frame.height(), kHeight);
  const double kr = c.bt709 ? 0.2126 : 0.299, kb = c.bt709 ? 0.0722 : 0.114;
  const double unit = 1 << (c.bits - 8), most = (1 << c.bits) - 1;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double Y = luma.codes[static_cast<std::size_t>(y * kWidth + x)];
      const double ey = c.full ? Y / most : (Y / unit - 16) / 219;
      const double scale = c.full ? most : 224 * unit;
      const double eb = (blue.at(x, y) - 128 * unit) / scale;
      const double er = (red.at(x, y) - 128 * unit) / scale;
      const double r = ey + er * 2 * (1 - kr), b = ey + eb * 2 * (1 - kb);
      const double g = (ey - kr * r - kb * b) / (1 - kr - kb);
      const Srgb8 p = frame.at(x, y);
      ASSERT_NEAR(p.r, 255 * std::clamp(r, 0.0, 1.0), 0.51) << x << ' ' << y;
      ASSERT_NEAR(p.g, 255 * std::clamp(g, 0.0, 1.0), 0.51) << x << ' ' << y;
      ASSERT_NEAR(p.b, 255 * std::clamp(b, 0.0, 1.0), 0.51) << x << ' ' << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, Decoded,
    ::testing::Values(Case{"420", 2, 2, 0.5, 0.5, 0.5, 0.5},
                      Case{"420jpeg", 2, 2, 0.5, 0.5, 0.5, 0.5},
                      Case{"420mpeg2", 2, 2, 0, 0.5, 0, 0.5}, Case{"420paldv", 2, 2, 0, 1, 0, 0},
                      Case{"420p10", 2, 2, 0, 0.5, 0, 0.5, 10}, Case{"422", 2, 1, 0, 0, 0, 0},
                      Case{"422p12", 2, 1, 0, 0, 0, 0, 12}, Case{"411", 4, 1, 0, 0, 0, 0},
                      Case{"444", 1, 1, 0, 0, 0, 0}, Case{"444", 1, 1, 0, 0, 0, 0, 8, true},
                      Case{"444p16", 1, 1, 0, 0, 0, 0, 16, true},
                      Case{"444", 1, 1, 0, 0, 0, 0, 8, false, true}));

/// Frames of a single colour by their published codes.
struct PublishedBar {
  int y, cb, cr, r, g, b;
};

void check_bars(const std::string& matrix, std::initializer_list<PublishedBar> bars) {
  for (const PublishedBar& bar : bars) {
    std::string planes;
    for (const int code : {bar.y, bar.cb, bar.cr}) planes += static_cast<char>(code);
    const Srgb8 p =
        first_frame(film_of("YUV4MPEG2 W1 H1 F25:1 C444 XMATRIX=" + matrix, planes)).at(0, 0);
    // Published codes are rounded: half a code of luma and of chroma.
    EXPECT_NEAR(p.r, bar.r, 2) << bar.y;
    EXPECT_NEAR(p.g, bar.g, 2) << bar.y;
    EXPECT_NEAR(p.b, bar.b, 2) << bar.y;
  }
}

TEST(VideoColours, SeventyFivePerCentBarsByTheirPublishedCodes) {
  // ITU-R BT.801-1 for BT.601; SMPTE RP 219 in 8 bits for BT.709.
  check_bars("601", {{235, 128, 128, 255, 255, 255},
                     {180, 128, 128, 191, 191, 191},
                     {162, 44, 142, 191, 191, 0},
                     {131, 156, 44, 0, 191, 191},
                     {112, 72, 58, 0, 191, 0},
                     {84, 184, 198, 191, 0, 191},
                     {65, 100, 212, 191, 0, 0},
                     {35, 212, 114, 0, 0, 191},
                     {16, 128, 128, 0, 0, 0}});
  check_bars("709", {{180, 128, 128, 191, 191, 191},
                     {168, 44, 136, 191, 191, 0},
                     {145, 147, 44, 0, 191, 191},
                     {133, 63, 52, 0, 191, 0},
                     {63, 193, 204, 191, 0, 191},
                     {51, 109, 212, 191, 0, 0},
                     {28, 212, 120, 0, 0, 191}});
}

TEST(VideoColours, MatrixOfVideoThatDoesNotSay) {
  EXPECT_EQ(usual_matrix(640, 480), YuvMatrix::kBt601);
  EXPECT_EQ(usual_matrix(1024, 576), YuvMatrix::kBt601);
  EXPECT_EQ(usual_matrix(1280, 720), YuvMatrix::kBt709);
  EXPECT_EQ(usual_matrix(960, 720), YuvMatrix::kBt709);
}

TEST(VideoColours, GreyIsGrey) {
  const auto grey = [](const char* header, const char* planes, std::size_t size) {
    return first_frame(film_of(header, std::string(planes, size))).at(0, 0);
  };
  EXPECT_EQ(grey("YUV4MPEG2 W1 H1 Cmono", "\x10", 1), (Srgb8{0, 0, 0, 255}));
  EXPECT_EQ(grey("YUV4MPEG2 W1 H1 Cmono", "\xeb", 1), (Srgb8{255, 255, 255, 255}));
  EXPECT_EQ(grey("YUV4MPEG2 W1 H1 Cmono XCOLORRANGE=FULL", "\x80", 1), (Srgb8{128, 128, 128, 255}));
  EXPECT_EQ(grey("YUV4MPEG2 W1 H1 Cmono16", "\0\xeb", 2), (Srgb8{255, 255, 255, 255}));
}

TEST(VideoFields, KeepTheirChromaApart) {
  // Four lines of luma; two of chroma: the upper field's is red, the lower field's blue.
  const std::string luma(8, '\x50'), blue("\x5a\xf0", 2), red("\xf0\x6e", 2);
  for (const char* order : {"t", "b"}) {
    for (const char* kind : {"420jpeg", "420mpeg2", "420paldv"}) {
      const Image<Srgb8> frame = first_frame(
          film_of(std::string("YUV4MPEG2 W2 H4 I") + order + " C" + kind, luma + blue + red));
      for (int x = 0; x < 2; ++x) {
        EXPECT_EQ(frame.at(x, 0), frame.at(x, 2)) << kind;
        EXPECT_EQ(frame.at(x, 1), frame.at(x, 3)) << kind;
        EXPECT_GT(frame.at(x, 0).r, frame.at(x, 0).b + 100) << kind;
        EXPECT_GT(frame.at(x, 1).b, frame.at(x, 1).r + 100) << kind;
      }
    }
  }
}

TEST(VideoFields, ChromaOfAFieldLiesWhereMpeg2PutsIt) {
  // 13818-2, figure 6-2: a field's chroma is 1/4 (upper) or 3/4 (lower) of the way between its
  // lines.
  std::string chroma;
  for (const int code : {100, 100, 180, 180}) chroma += static_cast<char>(code);
  const std::string luma(8, '\x7e'), neutral(4, '\x80');
  const Image<Srgb8> frame =
      first_frame(film_of("YUV4MPEG2 W1 H8 It C420mpeg2", luma + neutral + chroma));
  const auto red_of = [](double cr) {
    return 255 * ((126.0 - 16) / 219 + 1.402 * (cr - 128) / 224);
  };
  // Upper field, lines 0, 2, 4, 6: at -1/8, 3/8, 7/8, 11/8 of the chroma's steps.
  EXPECT_NEAR(frame.at(0, 0).r, red_of(100), 0.51);
  EXPECT_NEAR(frame.at(0, 2).r, red_of(100 + 80 * 0.375), 0.51);
  EXPECT_NEAR(frame.at(0, 4).r, red_of(100 + 80 * 0.875), 0.51);
  EXPECT_NEAR(frame.at(0, 6).r, red_of(180), 0.51);
  EXPECT_NEAR(frame.at(0, 1).r, red_of(100), 0.51);
  EXPECT_NEAR(frame.at(0, 3).r, red_of(100 + 80 * 0.125), 0.51);
  EXPECT_NEAR(frame.at(0, 5).r, red_of(100 + 80 * 0.625), 0.51);
  EXPECT_NEAR(frame.at(0, 7).r, red_of(180), 0.51);
}

TEST(VideoDecode, WhatTheWriterWroteComesBack) {
  const Scratch scratch;
  Image<Srgb8> frame(2000, 3);  // so wide that BT.709 would be usual
  std::mt19937 random(3);
  for (Srgb8& p : frame.pixels()) {
    const auto n = random();
    p = {static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(n >> 8),
         static_cast<std::uint8_t>(n >> 16), 255};
  }
  Y4mWriter writer(scratch.path("a.y4m"), 2000, 3, Rate{60000, 1001});
  writer.write(frame);
  writer.close();
  Workers workers(2);
  InputFile file(scratch.path("a.y4m"));
  const auto reader = read_y4m(file, workers);
  EXPECT_EQ(reader->rate().numerator, 60000);
  EXPECT_EQ(reader->pixel_aspect(), 1.0);
  Image<Srgb8> back;
  ASSERT_TRUE(reader->read(back));
  for (std::size_t i = 0; i < frame.pixels().size(); ++i) {
    const Srgb8 a = frame.pixels()[i], b = back.pixels()[i];
    ASSERT_NEAR(a.r, b.r, 2);
    ASSERT_NEAR(a.g, b.g, 2);
    ASSERT_NEAR(a.b, b.b, 2);
  }
  EXPECT_FALSE(reader->read(back));
}

class Ffmpeg : public ::testing::TestWithParam<const char*> {};

TEST_P(Ffmpeg, ShowsTheSameColours) {
  const Scratch scratch;
  // Smooth, so that how chroma is interpolated matters little.
  const std::string film = scratch.path("a.y4m"), raw = scratch.path("a.rgb");
  const std::string source =
      "ffmpeg -v error -f lavfi -i \"nullsrc=size=96x64:rate=25:duration=0.08,format=rgb24,"
      "geq=r='2*X+9*N':g='3*Y':b='230-X-Y'\" -strict -1 -pix_fmt ";
  ASSERT_EQ(std::system((source + GetParam() + " " + film).c_str()), 0);
  ASSERT_EQ(std::system(("ffmpeg -v error -i " + film +
                         " -sws_flags bilinear+accurate_rnd+full_chroma_int+full_chroma_inp -f "
                         "rawvideo -pix_fmt rgb24 " +
                         raw)
                            .c_str()),
            0);
  const std::string expected = Scratch::text(raw);
  Workers workers(2);
  InputFile file(film);
  const auto reader = read_y4m(file, workers);
  Image<Srgb8> frame;
  std::size_t at = 0;
  int frames = 0;
  for (; reader->read(frame); ++frames) {
    for (const Srgb8 p : frame.pixels()) {
      ASSERT_LE(at + 3, expected.size());
      ASSERT_NEAR(p.r, static_cast<std::uint8_t>(expected[at]), 4) << at;
      ASSERT_NEAR(p.g, static_cast<std::uint8_t>(expected[at + 1]), 4) << at;
      ASSERT_NEAR(p.b, static_cast<std::uint8_t>(expected[at + 2]), 4) << at;
      at += 3;
    }
  }
  EXPECT_EQ(frames, 2);
  EXPECT_EQ(at, expected.size());
}

// Not 4:1:1: swscale takes its chroma to lie in the middle of four pixels, DV puts it on the first.
INSTANTIATE_TEST_SUITE_P(Formats, Ffmpeg,
                         ::testing::Values("yuv420p", "yuv422p", "yuv444p", "yuv420p10",
                                           "yuv422p12", "yuv444p16", "yuvj420p", "gray", "gray16"));

}  // namespace
}  // namespace kinescope
