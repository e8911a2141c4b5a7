#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "raster/base/error.h"
#include "raster/base/input_file.h"
#include "raster/image/codecs.h"
#include "tests/raster/optional_data.h"
#include "tests/raster/png_by_hand.h"
#include "tests/raster/scratch.h"

namespace kinescope {
namespace {

using testing::Bytes;
using ::testing::HasSubstr;
using testing::png_by_hand;
using testing::PngSpec;
using testing::Scratch;

unsigned hashed(int x, int y, int channel) {
  return static_cast<unsigned>(x * 2654435761u + static_cast<unsigned>(y) * 40503u +
                               static_cast<unsigned>(channel) * 97u) >>
         7;
}

std::uint8_t scaled(unsigned value, int bits) {
  return static_cast<std::uint8_t>(std::lround(value * 255.0 / ((1 << bits) - 1)));
}

std::string error_of(const Bytes& bytes) {
  try {
    read_image(bytes, "t.png");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    return error.what();
  }
  return "no error";
}

struct Kind {
  int colour_type, bits;
};

class PngOf : public ::testing::TestWithParam<Kind> {};

TEST_P(PngOf, ReadsWhatTheSpecificationSays) {
  const auto [type, bits] = GetParam();
  const unsigned mask = (1u << bits) - 1;
  for (const bool interlaced : {false, true}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {9, 13}, {3, 2}, {64, 5}}) {
      const PngSpec spec{width, height, bits, type, interlaced, {}, {}};
      const auto sample = [mask](int x, int y, int c) { return hashed(x, y, c) & mask; };
      const Image<Srgb8> picture = read_image(png_by_hand(spec, sample), "t.png");
      ASSERT_EQ(picture.width(), width);
      ASSERT_EQ(picture.height(), height);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const auto value = [&](int c) { return scaled(sample(x, y, c), bits); };
          const bool grey = type == 0 || type == 4;
          const Srgb8 expected{value(0), value(grey ? 0 : 1), value(grey ? 0 : 2),
                               type == 4   ? value(1)
                               : type == 6 ? value(3)
                                           : std::uint8_t{255}};
          ASSERT_EQ(picture.at(x, y), expected) << x << ' ' << y << " interlaced " << interlaced;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, PngOf,
                         ::testing::Values(Kind{0, 1}, Kind{0, 2}, Kind{0, 4}, Kind{0, 8},
                                           Kind{0, 16}, Kind{2, 8}, Kind{2, 16}, Kind{4, 8},
                                           Kind{4, 16}, Kind{6, 8}, Kind{6, 16}));

TEST(Png, ReadsPalettesWithTransparency) {
  for (const int bits : {1, 2, 4, 8}) {
    const unsigned size = 1u << bits;
    PngSpec spec{21, 6, bits, 3, bits == 4, {}, {}};
    for (unsigned i = 0; i < size; ++i) {
      for (const unsigned c : {i * 37, i * 91 + 5, 255 - i})
        spec.palette.push_back(static_cast<std::uint8_t>(c));
    }
    spec.transparency = {0, 128};  // the other colours are opaque
    const auto sample = [size](int x, int y, int) { return hashed(x, y, 0) % size; };
    const Image<Srgb8> picture = read_png(png_by_hand(spec, sample), "t.png");
    for (int y = 0; y < spec.height; ++y) {
      for (int x = 0; x < spec.width; ++x) {
        const std::size_t i = sample(x, y, 0);
        const std::uint8_t alpha = i == 0 ? 0 : i == 1 ? 128 : 255;
        ASSERT_EQ(picture.at(x, y), (Srgb8{spec.palette[3 * i], spec.palette[3 * i + 1],
                                           spec.palette[3 * i + 2], alpha}))
            << bits << ": " << x << ' ' << y;
      }
    }
  }
}

TEST(Png, ReadsTheTransparentColourOfGreyAndRgb) {
  const auto sample = [](int x, int y, int) { return static_cast<unsigned>(x + 4 * y); };
  const PngSpec grey{4, 4, 8, 0, false, {}, {0, 5}};
  const Image<Srgb8> picture = read_png(png_by_hand(grey, sample), "t.png");
  EXPECT_EQ(picture.at(1, 1).a, 0);
  EXPECT_EQ(picture.at(2, 1), (Srgb8{6, 6, 6, 255}));
  const PngSpec rgb{4, 4, 8, 2, false, {}, {0, 7, 0, 7, 0, 7}};
  const Image<Srgb8> coloured = read_png(png_by_hand(rgb, sample), "t.png");
  EXPECT_EQ(coloured.at(3, 1).a, 0);
  EXPECT_EQ(coloured.at(3, 2).a, 255);
}

// gAMA says with which power the samples were encoded; Srgb8 is about the sRGB curve.
TEST(Png, BringsOtherGammasToSrgb) {
  PngSpec spec{256, 1, 8, 2, false, {}, {}, 100000};
  const auto sample = [](int x, int, int) { return static_cast<unsigned>(x); };
  const Image<Srgb8> linear = read_png(png_by_hand(spec, sample), "t.png");
  for (int x = 0; x < 256; ++x) {
    // libpng stands in a power of 2.2 for the curve.
    EXPECT_NEAR(linear.at(x, 0).r, 255 * std::pow(x / 255.0, 1 / 2.2), 1) << x;
  }
  spec.gamma = 45455;
  const Image<Srgb8> usual = read_png(png_by_hand(spec, sample), "t.png");
  for (int x = 0; x < 256; ++x) EXPECT_EQ(usual.at(x, 0).r, x);
}

TEST(Png, RefusesWhatIsCutOffWhereverThatIs) {
  const PngSpec spec{20, 20, 8, 6, false, {}, {}};
  const Bytes whole = png_by_hand(spec, [](int x, int y, int c) { return hashed(x, y, c) & 255; });
  EXPECT_EQ(error_of(whole), "no error");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string line =
        error_of(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
    ASSERT_THAT(line, HasSubstr("t.png: ")) << size;
    ASSERT_EQ(line.find('\n'), std::string::npos);
  }
  Bytes cut = whole;
  cut.resize(cut.size() - 20);
  EXPECT_THAT(error_of(cut), HasSubstr("cut off"));
}

TEST(Png, RefusesDamage) {
  const PngSpec spec{20, 20, 8, 2, false, {}, {}};
  const Bytes whole = png_by_hand(spec, [](int x, int y, int c) { return hashed(x, y, c) & 255; });
  Bytes flipped = whole;
  flipped[whole.size() / 2] ^= 0x40;
  EXPECT_THAT(error_of(flipped), HasSubstr("damaged"));
  Bytes header = whole;
  header[18] = 1;  // another width, but the old checksum
  EXPECT_THAT(error_of(header), HasSubstr("damaged"));
  Bytes long_chunk = whole;
  long_chunk[33] = 0x7f;  // the length of the second chunk
  EXPECT_THAT(error_of(long_chunk), HasSubstr("byte 33: "));
}

TEST(Png, RefusesHugeClaimsBeforeItTakesMemory) {
  const auto claimed = [](int width, int height) {
    Bytes bytes = png_by_hand({8, 8, 1, 0, false, {}, {}}, [](int, int, int) { return 0u; });
    Bytes header;
    testing::put32(header, static_cast<std::uint32_t>(width));
    testing::put32(header, static_cast<std::uint32_t>(height));
    std::copy(header.begin(), header.end(), bytes.begin() + 16);
    Bytes checksum;
    testing::put32(checksum, testing::crc(bytes.data() + 12, 17));
    std::copy(checksum.begin(), checksum.end(), bytes.begin() + 29);
    return bytes;
  };
  EXPECT_THAT(error_of(claimed(32769, 1)), HasSubstr("too large"));
  EXPECT_THAT(error_of(claimed(30000, 30000)), HasSubstr("too large"));
  EXPECT_THAT(error_of(claimed(1000000, 1000000)), HasSubstr("too large"));
  EXPECT_THAT(error_of(claimed(16384, 16384)), HasSubstr("cannot be held by so short a file"));
  EXPECT_THAT(error_of(claimed(0, 5)), HasSubstr("t.png: "));
}

TEST(Png, OtherDataIsNamedForWhatItIs) {
  EXPECT_EQ(error_of({}), "t.png: an empty file, not a picture");
  EXPECT_EQ(error_of({'G', 'I', 'F', '8', '9', 'a'}), "t.png: neither a PNG nor a JPEG picture");
  EXPECT_THROW(read_image_file("/nonexistent.png"), Error);
}

template <typename Pixel, typename Value>
Image<Pixel> noise(int width, int height, bool opaque) {
  Image<Pixel> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto value = [&](int c) { return static_cast<Value>(hashed(x, y, c)); };
      picture.at(x, y) = {value(0), value(1), value(2), opaque ? Pixel{}.a : value(3)};
    }
  }
  return picture;
}

TEST(PngWriter, WritesWhatItReads) {
  const Scratch scratch;
  const std::string path = scratch.path("p.png");
  for (const bool opaque : {true, false}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {33, 17}, {640, 3}}) {
      const Image<Srgb8> picture = noise<Srgb8, std::uint8_t>(width, height, opaque);
      write_png(path, picture);
      EXPECT_EQ(read_image_file(path), picture);
      const std::vector<std::uint8_t> bytes = read_file(path);
      EXPECT_EQ(bytes[24], 8);
      EXPECT_EQ(bytes[25], opaque || (width == 1 && picture.at(0, 0).a == 255) ? 2 : 6);
      EXPECT_THAT(std::string(bytes.begin(), bytes.end()), HasSubstr("sRGB"));
    }
  }
}

TEST(PngWriter, Writes16BitsBigEndian) {
  const Scratch scratch;
  const std::string path = scratch.path("p.png");
  for (const bool opaque : {true, false}) {
    const Image<Srgb16> picture = noise<Srgb16, std::uint16_t>(40, 30, opaque);
    write_png(path, picture);
    const std::vector<std::uint8_t> bytes = read_file(path);
    EXPECT_EQ(bytes[24], 16);
    EXPECT_EQ(bytes[25], opaque ? 2 : 6);
    // The reader's own scaling of 16-bit samples is tested above.
    const Image<Srgb8> read = read_image_file(path);
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        const Srgb16 p = picture.at(x, y);
        ASSERT_EQ(read.at(x, y),
                  (Srgb8{scaled(p.r, 16), scaled(p.g, 16), scaled(p.b, 16), scaled(p.a, 16)}));
      }
    }
  }
}

TEST(PngWriter, SaysThatTheDiskIsFullAndKeepsTheOlderFile) {
  const Image<Srgb8> picture = noise<Srgb8, std::uint8_t>(300, 300, true);
  try {
    write_png("/dev/full", picture);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kCannotWrite);
    EXPECT_STREQ(error.what(), "/dev/full: cannot be written: No space left on device");
  }
  EXPECT_THROW(write_png("/nonexistent/p.png", picture), Error);
}

TEST(PngData, EveryFileOfTheSuiteIsReadAndEveryInvalidOneRefused) {
  const std::filesystem::path folder = "/usr/share/go-1.19/src/image/png/testdata";
  KINESCOPE_NEEDS(folder);
  int read = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".png") continue;
    const std::string file = entry.path().filename();
    // A pixel beyond the palette is drawn black.
    const bool invalid = file.starts_with("invalid") && file != "invalid-palette.png";
    try {
      const Image<Srgb8> picture = read_image_file(entry.path());
      EXPECT_FALSE(picture.empty());
      EXPECT_FALSE(invalid) << entry.path();
      ++read;
    } catch (const Error& error) {
      EXPECT_TRUE(invalid) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(read, 35);
  EXPECT_EQ(refused, 4);
}

}  // namespace
}  // namespace kinescope
