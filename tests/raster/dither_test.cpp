// Dithers by their definitions, by what they keep of the picture, and beside ImageMagick.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>
#include <set>

#include "raster/base/error.h"
#include "raster/dither/error_diffusion.h"
#include "raster/dither/ordered_dither.h"
#include "raster/dither/palette_dither.h"
#include "raster/dither/threshold.h"
#include "raster/dither/void_and_cluster.h"
#include "raster/image/codecs.h"
#include "tests/raster/scratch.h"

namespace kinescope {
namespace {

GreyImage ramp(int width, int height) {
  GreyImage image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(255 * x / std::max(width - 1, 1));
    }
  }
  return image;
}

TEST(DitherThreshold, TheTextbooksExample) {
  Image<int> image(3, 3), result(3, 3), expected(3, 3);
  constexpr int kIn[] = {1, 0, 7, 4, 6, 2, 7, 5, 3}, kOut[] = {0, 0, 7, 0, 7, 0, 7, 7, 0};
  std::copy(std::begin(kIn), std::end(kIn), image.pixels().begin());
  std::copy(std::begin(kOut), std::end(kOut), expected.pixels().begin());
  const std::vector<int> four{4};
  threshold<int>(image, four, [&](int x, int y, int level) { result.at(x, y) = 7 * level; });
  EXPECT_EQ(result, expected);
}

TEST(DitherThreshold, SeveralLevelsTakeTheNearest) {
  for (const int levels : {1, 2, 3, 4, 7, 16, 256}) {
    const std::vector<std::uint8_t> thresholds = even_thresholds(levels);
    ASSERT_EQ(thresholds.size(), static_cast<std::size_t>(levels) - 1);
    for (int v = 0; v < 256 && levels > 1; ++v) {
      const int level = level_of<std::uint8_t>(static_cast<std::uint8_t>(v), thresholds);
      // |v - level 255 / (levels - 1)| is at most half a step.
      EXPECT_LE(std::abs(2 * (v * (levels - 1) - level * 255)), 255) << levels << ": " << v;
    }
  }
}

TEST(DitherOrdered, BayersMatrices) {
  EXPECT_EQ(bayer_matrix(1).ranks, (std::vector<std::uint16_t>{0}));
  EXPECT_EQ(bayer_matrix(2).ranks, (std::vector<std::uint16_t>{0, 2, 3, 1}));
  EXPECT_EQ(bayer_matrix(4).ranks,
            (std::vector<std::uint16_t>{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5}));
  for (const int bad : {-4, 0, 3, 6, 128}) EXPECT_THROW(bayer_matrix(bad), Error);
  for (const int bad : {-4, 0, 1, 9}) EXPECT_THROW(clustered_dot_matrix(bad), Error);
  for (const int bad : {-4, 0, 3, 129}) EXPECT_THROW(VoidAndCluster(bad, 1), Error);
}

std::vector<ThresholdMatrix> all_matrices() {
  std::vector<ThresholdMatrix> all;
  for (int side = 1; side <= 64; side *= 2) all.push_back(bayer_matrix(side));
  for (int side = 2; side <= 8; ++side) all.push_back(clustered_dot_matrix(side));
  all.push_back(blue_noise_matrix(16, 3));
  return all;
}

TEST(DitherOrdered, EachRankOnceAndEachGreyNearest) {
  for (const ThresholdMatrix& matrix : all_matrices()) {
    const int cells = matrix.side * matrix.side;
    std::set<int> ranks(matrix.ranks.begin(), matrix.ranks.end());
    ASSERT_EQ(ranks.size(), static_cast<std::size_t>(cells));
    ASSERT_EQ(*ranks.rbegin(), cells - 1);
    for (const int levels : {2, 3, 5}) {
      for (int v = 0; v < 256; v += 1 + cells / 64) {
        const GreyImage even(matrix.side, matrix.side, static_cast<std::uint8_t>(v));
        int sum = 0;
        ordered_dither(even, matrix, levels, [&](int, int, int level) { sum += level; });
        // Within half a cell of cells v (levels - 1) / 255; more cells than codes cannot be told.
        const double exact = double(cells) * v * (levels - 1) / 255;
        ASSERT_LE(std::abs(sum - exact), cells > 256 ? cells / 500.0 + 1 : 0.5 + 1e-9)
            << matrix.side << ": " << v << " to " << levels;
      }
    }
  }
}

TEST(DitherOrdered, RowsEqualTheirPixels) {
  std::mt19937 random(4);
  for (const ThresholdMatrix& matrix : all_matrices()) {
    for (const int width : {1, 63, 64, 65, 200, 517}) {
      GreyImage image(width, 70), expected(width, 70);
      for (std::uint8_t& v : image.pixels()) v = static_cast<std::uint8_t>(random());
      ordered_dither(image, matrix, 2, [&](int x, int y, int level) {
        expected.at(x, y) = static_cast<std::uint8_t>(255 * level);
      });
      ASSERT_EQ(ordered_dither(image, matrix), expected) << matrix.side << ", " << width;
    }
  }
  EXPECT_TRUE(ordered_dither(GreyImage(), bayer_matrix(4)).empty());
}

TEST(DitherOrdered, ClusteredDotsAreOneClusterEach) {
  for (int side = 2; side <= 8; ++side) {
    const ThresholdMatrix matrix = clustered_dot_matrix(side);
    // Each cell but the first touches one that lit before it.
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        if (matrix.rank(x, y) == 0) continue;
        int before = 0;
        for (int k = 0; k < 9; ++k) {
          const int u = x + k % 3 - 1, v = y + k / 3 - 1;
          if (u < 0 || v < 0 || u >= side || v >= side) continue;
          before += matrix.rank(u, v) < matrix.rank(x, y);
        }
        EXPECT_GT(before, 0) << side << ": " << x << ' ' << y;
      }
    }
  }
}

/// The share of the dots' variance at wavelengths longer than `longest` cells, by a plain
/// transform.
double low_share(const ThresholdMatrix& matrix, int rank_end, double longest) {
  const int side = matrix.side;
  double low = 0, all = 0;
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u < side; ++u) {
      if (u == 0 && v == 0) continue;
      double re = 0, im = 0;
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
          if (matrix.rank(x, y) >= rank_end) continue;
          const double phase = 2 * std::acos(-1.0) * (u * x + v * y) / side;
          re += std::cos(phase);
          im += std::sin(phase);
        }
      }
      const double f = std::hypot(std::min(u, side - u), std::min(v, side - v)) / side;
      all += re * re + im * im;
      if (f < 1 / longest) low += re * re + im * im;
    }
  }
  return low / all;
}

TEST(DitherBlueNoise, HasNoLowFrequencies) {
  const ThresholdMatrix blue = blue_noise_matrix(32, 1);
  ThresholdMatrix white{32, std::vector<std::uint16_t>(1024)};
  std::iota(white.ranks.begin(), white.ranks.end(), std::uint16_t{0});
  std::shuffle(white.ranks.begin(), white.ranks.end(), std::mt19937(2));
  for (const int dots : {102, 512}) {
    EXPECT_LT(low_share(blue, dots, 6), low_share(white, dots, 6) / 10) << dots;
  }
  EXPECT_EQ(blue_noise_matrix(32, 1).ranks, blue.ranks) << "the seed decides";
  EXPECT_NE(blue_noise_matrix(32, 2).ranks, blue.ranks);
}

/// The definition: each share pushed into a plane of whole-number errors.
GreyImage pushed(const GreyImage& image, const DiffusionKernel& kernel, int levels,
                 bool serpentine) {
  const int width = image.width(), height = image.height();
  Image<int> plane(width, height);
  GreyImage result(width, height);
  for (int y = 0; y < height; ++y) {
    const int direction = serpentine && y % 2 ? -1 : 1;
    for (int i = 0; i < width; ++i) {
      const int x = direction > 0 ? i : width - 1 - i;
      const int value = image.at(x, y) * 256 + plane.at(x, y);
      int level = 0;  // the nearest, of two the higher
      const auto code = [&](int l) { return l * 255 * 256 / (levels - 1); };
      while (level + 1 < levels &&
             std::int64_t{2} * value * (levels - 1) >= std::int64_t{2 * level + 1} * 255 * 256) {
        ++level;
      }
      result.at(x, y) = static_cast<std::uint8_t>(level);
      const int error = value - code(level);
      int total = 0, given = 0;
      for (int k = 0; k < kernel.count; ++k) {
        const auto& tap = kernel.taps[static_cast<std::size_t>(k)];
        total += tap.weight;
        const int share = k + 1 < kernel.count ? error * tap.weight / kernel.divisor
                                               : error * total / kernel.divisor - given;
        given += share;
        if (plane.contains(x + direction * tap.dx, y + tap.dy)) {
          plane.at(x + direction * tap.dx, y + tap.dy) += share;
        }
      }
    }
  }
  return result;
}

template <const DiffusionKernel& kKernel>
void expect_as_pushed() {
  std::mt19937 random(6);
  for (int n = 0; n < 40; ++n) {
    GreyImage image(1 + n * 3 % 40, 1 + n % 13);
    for (std::uint8_t& v : image.pixels()) v = static_cast<std::uint8_t>(random());
    for (const int levels : {2, 3, 16}) {
      for (const bool serpentine : {false, true}) {
        GreyImage result(image.width(), image.height());
        diffuse_errors<kKernel>(image, levels, serpentine, [&](int x, int y, int level) {
          result.at(x, y) = static_cast<std::uint8_t>(level);
        });
        ASSERT_EQ(result, pushed(image, kKernel, levels, serpentine)) << n << ' ' << levels;
      }
    }
  }
}

TEST(DitherDiffusion, EqualsItsDefinition) {
  expect_as_pushed<kFloydSteinberg>();
  expect_as_pushed<kJarvis>();
  expect_as_pushed<kAtkinson>();
}

TEST(DitherDiffusion, SharesAddUp) {
  for (const DiffusionKernel& k : {kFloydSteinberg, kJarvis, kAtkinson}) {
    int sum = 0;
    for (int i = 0; i < k.count; ++i) sum += k.taps[static_cast<std::size_t>(i)].weight;
    EXPECT_EQ(sum, k.name == "Atkinson" ? 6 : k.divisor) << k.name;
  }
}

TEST(DitherDiffusion, KeepsTheMeanAndShowsItsErrors) {
  const GreyImage image(64, 64, 100);
  double white = 0;
  ErrorDiffusion<> diffusion(image);
  ASSERT_TRUE(diffusion.next());
  EXPECT_EQ(diffusion.level(), 0);
  EXPECT_EQ(diffusion.error(), 100);
  EXPECT_EQ(diffusion.carried(1, 0), 43.75) << "7/16";
  EXPECT_EQ(diffusion.carried(0, 1), 31.25) << "5/16";
  EXPECT_EQ(diffusion.carried(1, 1), 6.25) << "1/16";
  ASSERT_TRUE(diffusion.next());
  EXPECT_EQ(diffusion.value(), 143.75);
  EXPECT_EQ(diffusion.level(), 1);
  white += diffusion.level();
  while (diffusion.next()) white += diffusion.level();
  EXPECT_NEAR(white / (64 * 64) * 255, 100, 1.5);
}

TEST(DitherDiffusion, EmptyPictures) {
  for (const GreyImage& image : {GreyImage(), GreyImage(0, 5), GreyImage(5, 0)}) {
    diffuse_errors<kJarvis>(image, 2, true, [](int, int, int) { FAIL(); });
  }
}

Image<Srgb8> as_colours(const GreyImage& grey) {
  Image<Srgb8> image(grey.width(), grey.height());
  for (std::size_t i = 0; i < grey.pixels().size(); ++i) {
    const std::uint8_t v = grey.pixels()[i];
    image.pixels()[i] = {v, v, v, 255};
  }
  return image;
}

/// How far the means of 8x8 pixels lie from the picture's, root mean square.
double local_error(const GreyImage& a, const GreyImage& b) {
  double squares = 0;
  int blocks = 0;
  for (int y = 0; y + 8 <= a.height(); y += 8) {
    for (int x = 0; x + 8 <= a.width(); x += 8, ++blocks) {
      double sum = 0;
      for (int k = 0; k < 64; ++k) sum += a.at(x + k % 8, y + k / 8) - b.at(x + k % 8, y + k / 8);
      squares += sum / 64 * sum / 64;
    }
  }
  return std::sqrt(squares / blocks);
}

// Their scans differ in detail; what matters is how much of the picture is left.
TEST(DitherDiffusion, KeepsAsMuchAsImageMagick) {
  GreyImage image = ramp(256, 128);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 256; ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(
          std::clamp(image.at(x, y) + 40 * std::sin(x / 9.0) * std::cos(y / 13.0), 0.0, 255.0));
    }
  }
  const testing::Scratch scratch;
  write_png(scratch.path("in.png"), as_colours(image));
  const std::string command = "convert '" + scratch.path("in.png") +
                              "' -colorspace gray -dither FloydSteinberg -remap pattern:gray50 '" +
                              scratch.path("out.png") + "'";
  ASSERT_EQ(std::system(command.c_str()), 0) << "ImageMagick is required";
  const Image<Srgb8> theirs = read_image_file(scratch.path("out.png"));
  GreyImage their_grey(256, 128), ours(256, 128);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 256; ++x) their_grey.at(x, y) = theirs.at(x, y).r;
  }
  diffuse_errors<kFloydSteinberg>(image, 2, true, [&](int x, int y, int level) {
    ours.at(x, y) = static_cast<std::uint8_t>(255 * level);
  });
  const double our_error = local_error(ours, image), their_error = local_error(their_grey, image);
  EXPECT_LT(our_error, 1.1 * their_error);
  EXPECT_GT(their_error, 0.5) << "the comparison means something";
}

Image<Srgb8> colourful(int width, int height) {
  Image<Srgb8> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = {static_cast<std::uint8_t>(x * 255 / width),
                        static_cast<std::uint8_t>(y * 255 / height),
                        static_cast<std::uint8_t>((x * y) % 256), 255};
    }
  }
  return image;
}

TEST(DitherPalette, FewColoursAreKeptExactly) {
  Image<Srgb8> image(20, 20);
  const Palette colours{{0, 0, 0, 255}, {255, 0, 0, 255}, {8, 200, 40, 255}, {250, 251, 252, 255}};
  for (std::size_t i = 0; i < 400; ++i) image.pixels()[i] = colours[i * 7 % 11 % 4];
  const Palette palette = median_cut(image, 256);
  EXPECT_EQ(palette.size(), 4u);
  for (const auto& indices : {to_palette(image, palette), diffuse_to_palette(image, palette)}) {
    for (std::size_t i = 0; i < 400; ++i) {
      ASSERT_EQ(palette[indices.pixels()[i]], image.pixels()[i]);
    }
  }
}

TEST(DitherPalette, NearestIsTheNearest) {
  const Palette palette = median_cut(colourful(60, 50), 37);
  ASSERT_EQ(palette.size(), 37u);
  NearestEntry nearest(palette);
  std::mt19937 random(8);
  for (int n = 0; n < 200000; ++n) {
    const int r = random() % 256, g = random() % 256, b = random() % 256;
    const auto distance = [&](const Srgb8& p) {
      return (p.r - r) * (p.r - r) + (p.g - g) * (p.g - g) + (p.b - b) * (p.b - b);
    };
    int best = 1 << 30;
    for (const Srgb8& p : palette) best = std::min(best, distance(p));
    ASSERT_EQ(distance(palette[nearest(r, g, b)]), best);
  }
}

TEST(DitherPalette, CutsHalveTheirBoxes) {
  const Image<Srgb8> image = colourful(128, 128);
  MedianCut cut(image, 64);
  std::size_t boxes = 1;
  while (cut.next()) {
    EXPECT_EQ(cut.boxes().size(), ++boxes);
    std::int64_t pixels = 0;
    for (const MedianCut::Box& box : cut.boxes()) {
      EXPECT_GT(box.pixels, 0);
      pixels += box.pixels;
    }
    EXPECT_EQ(pixels, 128 * 128);
  }
  EXPECT_EQ(boxes, 64u);
}

TEST(DitherPalette, DiffusionKeepsLocalMeans) {
  const Image<Srgb8> image = colourful(128, 128);
  Palette palette;  // the corners of the cube can mix every colour
  for (int i = 0; i < 8; ++i) {
    const auto full = [i](int bit) { return static_cast<std::uint8_t>(i & bit ? 255 : 0); };
    palette.push_back({full(1), full(2), full(4), 255});
  }
  const auto error = [&](const Image<std::uint8_t>& indices) {
    GreyImage wanted(128, 128), shown(128, 128);
    for (std::size_t i = 0; i < wanted.pixels().size(); ++i) {
      wanted.pixels()[i] = image.pixels()[i].g;
      shown.pixels()[i] = palette[indices.pixels()[i]].g;
    }
    return local_error(shown, wanted);
  };
  EXPECT_LT(error(diffuse_to_palette(image, palette)), error(to_palette(image, palette)) / 5);
}

TEST(DitherPalette, BadPalettes) {
  EXPECT_TRUE(median_cut(Image<Srgb8>(), 16).empty());
  EXPECT_THROW(median_cut(colourful(4, 4), 0), Error);
  EXPECT_THROW(median_cut(colourful(4, 4), 257), Error);
  EXPECT_THROW(to_palette(colourful(4, 4), {}), Error);
  EXPECT_THROW(diffuse_to_palette(colourful(4, 4), Palette(257)), Error);
  EXPECT_TRUE(to_palette(Image<Srgb8>(), Palette(1)).empty());
}

}  // namespace
}  // namespace kinescope
