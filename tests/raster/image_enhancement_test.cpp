// Tone curves, convolutions, the median, raster operations, pixmaps of few bits and the spray can,
// beside what they are by definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "raster/image/bit_depth.h"
#include "raster/image/enhancement.h"
#include "raster/image/raster_op.h"
#include "raster/scan/spray.h"

namespace kinescope {
namespace {

GreyImage noise(int width, int height, unsigned seed, int tones = 256) {
  std::mt19937 random(seed);
  GreyImage image(width, height);
  for (std::uint8_t& tone : image.pixels()) {
    tone = static_cast<std::uint8_t>(random() % static_cast<unsigned>(tones));
  }
  return image;
}

/// The pixel as the filters see it beyond the edges.
int code(const GreyImage& image, int x, int y) {
  return image.at(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
}

TEST(ToneSpread, IsTheMeanAndDeviationByDefinition) {
  Histogram counts{};
  counts[10] = 3, counts[50] = 1;
  const ToneSpread spread = tone_spread(counts);
  EXPECT_DOUBLE_EQ(spread.mean, 20);
  EXPECT_DOUBLE_EQ(spread.deviation, std::sqrt((3 * 100.0 + 900) / 4));
  EXPECT_EQ(spread.tones, 2);
  EXPECT_EQ(tone_spread(Histogram{}).deviation, 0);
}

TEST(ToneCurve, EqualizingIsTheShareOfPixelsThatAreAsDark) {
  const GreyImage image = noise(31, 17, 1, 90);
  const ToneCurve curve = equalizing_curve(histogram(image));
  const double all = 31 * 17;
  for (const std::uint8_t tone : image.pixels()) {
    const auto darker = std::count_if(image.pixels().begin(), image.pixels().end(),
                                      [&](std::uint8_t other) { return other <= tone; });
    EXPECT_NEAR(curve[tone], 255 * static_cast<double>(darker) / all, 0.5 + 1e-9);
  }
  EXPECT_EQ(equalizing_curve(histogram(GreyImage()))[77], 77) << "no pixels, no change";
}

TEST(ToneCurve, StretchingReachesBothEndsAndGivesUpItsShare) {
  GreyImage image(10, 10, 100);
  image.at(0, 0) = 60;
  image.at(1, 0) = 160;
  image.at(2, 0) = 80;
  image.at(3, 0) = 140;
  const Histogram counts = histogram(image);
  const ToneCurve whole = stretching_curve(counts);
  EXPECT_EQ(whole[60], 0);
  EXPECT_EQ(whole[160], 255);
  EXPECT_EQ(whole[110], 128);
  const ToneCurve without_ends = stretching_curve(counts, 0.01);
  EXPECT_EQ(without_ends[80], 0);
  EXPECT_EQ(without_ends[140], 255);
  EXPECT_EQ(stretching_curve(histogram(GreyImage(4, 4, 9)))[9], 9) << "one tone";
}

TEST(ToneCurve, NegativeContrastAndGammaAreTheirFormulas) {
  for (int i = 0; i < 256; i += 5) {
    const auto tone = static_cast<std::size_t>(i);
    EXPECT_EQ(negative_curve()[tone], 255 - i);
    EXPECT_NEAR(contrast_curve(2)[tone], std::clamp(127.5 + 2 * (i - 127.5), 0.0, 255.0), 0.51);
    EXPECT_NEAR(power_curve(0.5)[tone], std::sqrt(i * 255.0), 0.51);
  }
  EXPECT_EQ(with_curve(GreyImage(1, 1, 3), negative_curve()).at(0, 0), 252);
}

TEST(Convolution, OfAnImpulseIsTheMaskItself) {
  GreyImage impulse(7, 7);
  impulse.at(3, 3) = 1;
  const Convolution mask{3, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
  convolve(impulse, mask, [&](int x, int y, std::uint8_t result) {
    const bool within = std::abs(x - 3) <= 1 && std::abs(y - 3) <= 1;
    EXPECT_EQ(result, within ? (y - 2) * 3 + (x - 2) + 1 : 0) << x << ", " << y;
  });
}

TEST(Convolution, IsTheWeightedSumOfNeighbours) {
  const GreyImage image = noise(13, 9, 2);
  for (const Convolution& mask : {box_blur(5), gaussian_blur(1.1), sharpening(0.7), laplacian(),
                                  emboss(), sobel_across(), sobel_down()}) {
    int calls = 0;
    convolve(image, mask, [&](int x, int y, std::uint8_t result) {
      double sum = mask.offset;
      const int half = mask.side / 2;
      for (int j = 0; j < mask.side; ++j) {
        for (int i = 0; i < mask.side; ++i) {
          sum += mask.weights[static_cast<std::size_t>(j * mask.side + i)] *
                 code(image, x + half - i, y + half - j);
        }
      }
      EXPECT_NEAR(result, std::clamp(sum, 0.0, 255.0), 0.5 + 1e-9);
      ++calls;
    });
    EXPECT_EQ(calls, 13 * 9);
  }
}

TEST(Convolution, BlursKeepTheMeanAndEdgesOfAnEvenPictureAreNone) {
  for (const Convolution& mask : {box_blur(3), gaussian_blur(2), sharpening(3)}) {
    convolve(GreyImage(6, 5, 200), mask,
             [](int, int, std::uint8_t result) { EXPECT_EQ(result, 200); });
  }
  sobel_edges(GreyImage(6, 5, 200), [](int, int, std::uint8_t result) { EXPECT_EQ(result, 0); });
  GreyImage step(6, 5);
  for (int y = 0; y < 5; ++y) std::fill_n(step.row(y) + 3, 3, std::uint8_t{20});
  sobel_edges(step, [](int x, int, std::uint8_t result) {
    EXPECT_EQ(result, x == 2 || x == 3 ? 80 : 0) << x;
  });
}

TEST(MedianFilter, IsTheMiddleOfTheSortedWindow) {
  for (const int tones : {2, 7, 256}) {
    const GreyImage image = noise(14, 11, 3, tones);
    for (const int radius : {0, 1, 2, 6}) {
      int calls = 0;
      median_filter(image, radius, [&](int x, int y, std::uint8_t result) {
        std::vector<int> window;
        for (int dy = -radius; dy <= radius; ++dy) {
          for (int dx = -radius; dx <= radius; ++dx) window.push_back(code(image, x + dx, y + dy));
        }
        std::sort(window.begin(), window.end());
        ASSERT_EQ(result, window[window.size() / 2]) << x << ", " << y << ", radius " << radius;
        ++calls;
      });
      EXPECT_EQ(calls, 14 * 11);
    }
  }
  median_filter(GreyImage(), 3, [](int, int, std::uint8_t) { FAIL() << "an empty picture"; });
}

TEST(Enhancement, EachIsWhatItsNameSays) {
  const GreyImage image = noise(9, 8, 4, 60);
  const Histogram counts = histogram(image);
  const auto bytes = [](const GreyImage& of) {
    return std::vector<std::uint8_t>(of.pixels().begin(), of.pixels().end());
  };
  const auto result = [&](Enhancement kind, double amount) {
    GreyImage out(image.width(), image.height());
    int at = 0;
    enhance(image, {kind, amount}, [&](int x, int y, std::uint8_t tone) {
      EXPECT_EQ(y * image.width() + x, at++);  // row by row
      out.at(x, y) = tone;
    });
    EXPECT_EQ(at, 72);
    return bytes(out);
  };
  const auto by = [&](const ToneCurve& curve) { return bytes(with_curve(image, curve)); };
  const auto summed = [&](const Convolution& mask) {
    GreyImage out(image.width(), image.height());
    convolve(image, mask, [&](int x, int y, std::uint8_t tone) { out.at(x, y) = tone; });
    return bytes(out);
  };
  EXPECT_EQ(result(Enhancement::kStretch, 1), by(stretching_curve(counts, 0.005)));
  EXPECT_EQ(result(Enhancement::kEqualize, 1), by(equalizing_curve(counts)));
  EXPECT_EQ(result(Enhancement::kContrast, 2), by(contrast_curve(2)));
  EXPECT_EQ(result(Enhancement::kGamma, 0.5), by(power_curve(0.5)));
  EXPECT_EQ(result(Enhancement::kNegative, 1), by(negative_curve()));
  EXPECT_EQ(result(Enhancement::kBox, 2), summed(box_blur(5)));
  EXPECT_EQ(result(Enhancement::kGaussian, 1.5), summed(gaussian_blur(1.5)));
  EXPECT_EQ(result(Enhancement::kSharpen, 0.7), summed(sharpening(0.7)));
  EXPECT_EQ(result(Enhancement::kLaplacian, 1), summed(laplacian()));
  EXPECT_EQ(result(Enhancement::kEmboss, 1), summed(emboss()));
}

TEST(RasterOp, EachIsItsTruthTable) {
  for (unsigned op = 0; op < 16; ++op) {
    const std::uint8_t result =
        apply(static_cast<RasterOp>(op), std::uint8_t{0b1100}, std::uint8_t{0b1010});
    EXPECT_EQ(result & 0xf, op) << "bits of source and destination count up to its number";
  }
  const Srgb8 s{0xf0, 0x0f, 0x35, 9}, d{0xcc, 0x33, 0x5a, 200};
  EXPECT_EQ(apply(RasterOp::kOr, s, d), (Srgb8{0xfc, 0x3f, 0x7f, 200}));
  EXPECT_EQ(apply(RasterOp::kErase, s, d), (Srgb8{0x0c, 0x30, 0x4a, 200}));
  EXPECT_EQ(apply(RasterOp::kXor, s, apply(RasterOp::kXor, s, d)), d) << "twice is never";
}

Image<Srgb8> coloured(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image<Srgb8> image(width, height);
  for (Srgb8& c : image.pixels()) {
    const auto bits = static_cast<std::uint32_t>(random());
    c = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
         static_cast<std::uint8_t>(bits >> 16), 255};
  }
  return image;
}

TEST(RasterOp, APartIsLaidOverEvenItsOwnPictureAndCutAtBothEdges) {
  for (const auto& [x, y] :
       {std::pair{3, 2}, {-2, 1}, {1, -3}, {0, 0}, {9, 9}, {40, 2}, {-9, -9}}) {
    for (const PixelRect part : {PixelRect{1, 1, 7, 6}, {-3, -2, 20, 30}, {5, 5, 5, 9}}) {
      Image<Srgb8> image = coloured(10, 8, 4), expected = image;
      const Image<Srgb8> source = image;
      for (int v = part.y0; v < part.y1; ++v) {
        for (int u = part.x0; u < part.x1; ++u) {
          const int tx = u - part.x0 + x, ty = v - part.y0 + y;
          if (!source.contains(u, v) || !expected.contains(tx, ty)) continue;
          expected.at(tx, ty) = source.at(u, v);
        }
      }
      bit_blt(image, x, y, image, part, RasterOp::kCopy);
      EXPECT_EQ(image, expected) << x << ", " << y;
    }
  }
}

TEST(RasterOp, AFilledRectangleIsCutToThePicture) {
  Image<Srgb8> image = coloured(9, 7, 5);
  const Image<Srgb8> before = image;
  raster_fill(image, {-4, 5, 3, 100}, {255, 255, 255, 255}, RasterOp::kXor);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) {
      Srgb8 c = before.at(x, y);
      if (x < 3 && y >= 5) c = {std::uint8_t(~c.r), std::uint8_t(~c.g), std::uint8_t(~c.b), c.a};
      EXPECT_EQ(image.at(x, y), c);
    }
  }
}

TEST(BitDepth, EachCodeBecomesTheNearestLevel) {
  for (int bits = 1; bits <= 8; ++bits) {
    const int most = (1 << bits) - 1;
    for (int c = 0; c < 256; ++c) {
      double least = 1e9;
      for (int level = 0; level <= most; ++level) {
        least = std::min(least, std::abs(level * 255.0 / most - c));
      }
      EXPECT_LE(std::abs(nearest_level(c, bits) - c), least + 0.5) << bits << " bits of " << c;
    }
    EXPECT_EQ(nearest_level(0, bits), 0);
    EXPECT_EQ(nearest_level(255, bits), 255);
  }
}

TEST(BitDepth, ChannelsShareTheBitsAndKeepTheColoursApart) {
  for (int bits = 4; bits <= 24; ++bits) {
    const ChannelBits share = channel_bits(bits);
    EXPECT_EQ(share.red + share.green + share.blue, bits);
    EXPECT_GE(share.green, share.red);
    EXPECT_GE(share.red, share.blue);
    EXPECT_LE(share.green - share.blue, 1);
  }
  EXPECT_EQ(channel_bits(16).green, 6);
  const Srgb8 colour{200, 30, 77, 9};
  EXPECT_EQ(with_bit_depth(colour, 24), colour);
  EXPECT_EQ(with_bit_depth({250, 200, 160, 255}, 1), (Srgb8{255, 255, 255, 255}));
  EXPECT_EQ(with_bit_depth({250, 20, 10, 255}, 1), (Srgb8{0, 0, 0, 255})) << "by luma";
  EXPECT_EQ(frame_buffer_bytes(640, 480, 1), 38400);
  EXPECT_EQ(frame_buffer_bytes(9, 2, 1), 4) << "a row begins with a byte of its own";
  EXPECT_EQ(frame_buffer_bytes(1024, 768, 24), 2359296);
}

struct Dice {
  std::mt19937_64 engine{6};
  double uniform() { return static_cast<double>(engine() >> 11) * 0x1p-53; }
};

TEST(Spray, FillsItsDiscEvenly) {
  Dice dice;
  constexpr int kDrops = 40000, kRings = 4;
  std::vector<int> rings(kRings);
  glm::dvec2 sum(0);
  spray({100, 100}, 80, kDrops, dice, [&](int x, int y) {
    const double r = std::hypot(x + 0.5 - 100, y + 0.5 - 100);
    ASSERT_LE(r, 80 + std::sqrt(0.5));
    ++rings[static_cast<std::size_t>(std::min(kRings - 1.0, kRings * (r / 80) * (r / 80)))];
    sum += glm::dvec2(x + 0.5 - 100, y + 0.5 - 100);
  });
  // Rings of one area: a binomial's deviation is 87.
  for (const int drops : rings) EXPECT_NEAR(drops, kDrops / kRings, 5 * 87 + 150);
  EXPECT_LT(std::hypot(sum.x, sum.y) / kDrops, 1);
}

}  // namespace
}  // namespace kinescope
