#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <jpeglib.h>

#include "raster/base/error.h"
#include "raster/image/codecs.h"
#include "tests/raster/optional_data.h"

namespace kinescope {
namespace {

using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

struct Kind {
  J_COLOR_SPACE colours = JCS_RGB;
  J_COLOR_SPACE stored = JCS_YCbCr;
  int channels = 3;
  bool progressive = false, arithmetic = false, adobe = true, subsampled = false;
};

/// Slow waves: what JPEG keeps almost whole.
std::uint8_t wave(int x, int y, int channel) {
  return static_cast<std::uint8_t>(
      std::lround(128 + 100 * std::sin(0.05 * x * (channel + 1) + 0.04 * y)));
}

Bytes encoded(const Kind& kind, int width, int height) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &data, &size);
  info.image_width = static_cast<JDIMENSION>(width);
  info.image_height = static_cast<JDIMENSION>(height);
  info.input_components = kind.channels;
  info.in_color_space = kind.colours;
  jpeg_set_defaults(&info);
  jpeg_set_colorspace(&info, kind.stored);
  jpeg_set_quality(&info, 100, TRUE);
  if (!kind.subsampled) info.comp_info[0].h_samp_factor = info.comp_info[0].v_samp_factor = 1;
  if (kind.progressive) jpeg_simple_progression(&info);
  info.arith_code = kind.arithmetic;
  if (!kind.adobe) info.write_Adobe_marker = FALSE;
  jpeg_start_compress(&info, TRUE);
  for (int y = 0; y < height; ++y) {
    Bytes row;
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < kind.channels; ++c) row.push_back(wave(x, y, c));
    }
    JSAMPROW rows = row.data();
    jpeg_write_scanlines(&info, &rows, 1);
  }
  jpeg_finish_compress(&info);
  const Bytes bytes(data, data + size);
  jpeg_destroy_compress(&info);
  std::free(data);
  return bytes;
}

void expect_waves(const Bytes& bytes, int width, int height, bool grey, int tolerance) {
  const Image<Srgb8> picture = read_image(bytes, "t.jpeg");
  ASSERT_EQ(picture.width(), width);
  ASSERT_EQ(picture.height(), height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Srgb8 p = picture.at(x, y);
      ASSERT_NEAR(p.r, wave(x, y, 0), tolerance) << x << ' ' << y;
      ASSERT_NEAR(p.g, wave(x, y, grey ? 0 : 1), tolerance) << x << ' ' << y;
      ASSERT_NEAR(p.b, wave(x, y, grey ? 0 : 2), tolerance) << x << ' ' << y;
      ASSERT_EQ(p.a, 255);
    }
  }
}

std::string error_of(const Bytes& bytes) {
  try {
    read_image(bytes, "t.jpeg");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    return error.what();
  }
  return "no error";
}

TEST(Jpeg, ReadsEachKindOfCoding) {
  for (const bool progressive : {false, true}) {
    for (const bool arithmetic : {false, true}) {
      Kind kind;
      kind.progressive = progressive;
      kind.arithmetic = arithmetic;
      for (const auto& [width, height] : {std::pair{1, 1}, {8, 8}, {19, 33}, {100, 50}}) {
        expect_waves(encoded(kind, width, height), width, height, false, 4);
      }
      kind.subsampled = true;
      expect_waves(encoded(kind, 64, 64), 64, 64, false, 12);
    }
  }
}

TEST(Jpeg, ReadsGreyAndPlainRgb) {
  expect_waves(encoded({JCS_GRAYSCALE, JCS_GRAYSCALE, 1}, 40, 30), 40, 30, true, 2);
  expect_waves(encoded({JCS_RGB, JCS_RGB, 3}, 40, 30), 40, 30, false, 2);
}

// Adobe's programs store inks inverted and say so by a marker; others store them as they are.
TEST(Jpeg, ReadsInksBothWays) {
  for (const bool adobe : {true, false}) {
    for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK}) {
      if (stored == JCS_YCCK && !adobe) continue;  // only the marker tells it from CMYK
      Kind kind{JCS_CMYK, stored, 4};
      kind.adobe = adobe;
      const Image<Srgb8> picture = read_jpeg(encoded(kind, 32, 20), "t.jpeg");
      for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 32; ++x) {
          const auto through = [&](int c) { return adobe ? wave(x, y, c) : 255 - wave(x, y, c); };
          ASSERT_NEAR(picture.at(x, y).r, through(0) * through(3) / 255.0, 7) << adobe;
          ASSERT_NEAR(picture.at(x, y).g, through(1) * through(3) / 255.0, 7) << adobe;
          ASSERT_NEAR(picture.at(x, y).b, through(2) * through(3) / 255.0, 7) << adobe;
          ASSERT_EQ(picture.at(x, y).a, 255);
        }
      }
    }
  }
}

TEST(Jpeg, RefusesWhatIsCutOffWhereverThatIs) {
  for (const bool progressive : {false, true}) {
    Kind kind;
    kind.progressive = progressive;
    const Bytes whole = encoded(kind, 20, 20);
    EXPECT_EQ(error_of(whole), "no error");
    // The last two bytes are the end marker alone; what lies before is needed.
    for (std::size_t size = 0; size + 2 < whole.size(); ++size) {
      const std::string line =
          error_of(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
      ASSERT_THAT(line, HasSubstr("t.jpeg: ")) << size << " of " << whole.size();
      ASSERT_EQ(line.find('\n'), std::string::npos);
    }
  }
}

/// The place of the frame header's height, after its marker, length and precision.
std::size_t height_at(const Bytes& bytes) {
  for (std::size_t i = 0; i + 9 < bytes.size(); ++i) {
    if (bytes[i] == 0xff && (bytes[i + 1] == 0xc0 || bytes[i + 1] == 0xc2)) return i + 5;
  }
  return 0;
}

TEST(Jpeg, RefusesHugeClaimsBeforeItTakesMemory) {
  Bytes bytes = encoded({}, 40, 40);
  const std::size_t at = height_at(bytes);
  ASSERT_GT(at, 0u);
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = 0xfe;
  EXPECT_THAT(error_of(bytes), HasSubstr("t.jpeg: "));
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = 0x7f;
  EXPECT_THAT(error_of(bytes), HasSubstr("too large"));
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = i % 2 ? 0 : 0x3f;
  EXPECT_THAT(error_of(bytes), HasSubstr("cannot be held by so short a file"));
}

TEST(Jpeg, RefusesDamageAndBombs) {
  Bytes bytes = encoded({}, 40, 40);
  bytes[height_at(bytes) - 1] = 13;  // bits a sample
  EXPECT_THAT(error_of(bytes), HasSubstr("damaged"));
  EXPECT_THAT(error_of({0xff, 0xd8, 0xff}), HasSubstr("t.jpeg: "));
  EXPECT_THAT(error_of({0xff, 0xd8, 0xff, 0xd9}), HasSubstr("t.jpeg: "));

  // A progressive picture whose last scan is repeated a thousand times.
  Kind kind;
  kind.progressive = true;
  const Bytes once = encoded(kind, 16, 16);
  std::size_t last = 0;
  for (std::size_t i = 0; i + 1 < once.size(); ++i) {
    if (once[i] == 0xff && once[i + 1] == 0xda) last = i;
  }
  Bytes bomb(once.begin(), once.end() - 2);
  for (int i = 0; i < 1000; ++i) {
    bomb.insert(bomb.end(), once.begin() + static_cast<std::ptrdiff_t>(last), once.end() - 2);
  }
  bomb.insert(bomb.end(), {0xff, 0xd9});
  EXPECT_THAT(error_of(bomb), HasSubstr("damaged"));
}

// Somebody else's pictures, and the same as PNG.
TEST(JpegData, AgreesWithTheSamePicturesAsPng) {
  const std::string folder = "/usr/share/go-1.19/src/image/testdata/";
  KINESCOPE_NEEDS(folder);
  const auto difference = [&](const std::string& jpeg, const std::string& png) {
    const Image<Srgb8> a = read_image_file(folder + jpeg), b = read_image_file(folder + png);
    EXPECT_EQ(a.width(), b.width());
    EXPECT_EQ(a.height(), b.height());
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.pixels().size(), b.pixels().size()); ++i) {
      const Srgb8 p = a.pixels()[i], q = b.pixels()[i];
      sum += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
    }
    return sum / 3 / static_cast<double>(a.pixels().size());
  };
  EXPECT_LT(difference("video-001.jpeg", "video-001.png"), 6);
  EXPECT_LT(difference("video-001.progressive.jpeg", "video-001.png"), 6);
  // Later scans are missing, but the end marker is there: a whole file of a coarse picture.
  EXPECT_LT(
      difference("video-001.progressive.truncated.jpeg", "video-001.progressive.truncated.png"), 6);
  EXPECT_LT(difference("video-001.rgb.jpeg", "video-001.rgb.png"), 6);
  EXPECT_LT(difference("video-001.cmyk.jpeg", "video-001.cmyk.png"), 6);
  EXPECT_LT(difference("video-005.gray.jpeg", "video-005.gray.png"), 6);
}

TEST(JpegData, EveryFileIsRead) {
  const std::filesystem::path folder = "/usr/share/go-1.19/src/image/testdata";
  KINESCOPE_NEEDS(folder);
  int read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".jpeg") continue;
    EXPECT_FALSE(read_image_file(entry.path()).empty());
    ++read;
  }
  EXPECT_GE(read, 20);
}

}  // namespace
}  // namespace kinescope
