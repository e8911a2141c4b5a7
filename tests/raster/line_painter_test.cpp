// Lines in SIMD, on all workers, against the readable reference: equal bit by bit.
#include "raster/path/line_painter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "raster/base/simd.h"
#include "raster/path/stroke_coverage.h"

namespace kinescope {
namespace {

class SimdGuard {
 public:
  ~SimdGuard() { use_simd_target("best"); }
};

template <typename Pixel>
void draw_reference(std::span<const InkedLine> lines, const Stroke& stroke, Mixing mixing,
                    Image<Pixel>& picture) {
  for (const InkedLine& line : lines) {
    const typename ink::FormFor<Pixel>::Type ink(Ink{line.colour, mixing});
    stroke_coverage(line.segment, stroke, {0, 0, picture.width(), picture.height()},
                    [&](int x, int y, std::span<const float> coverage) {
                      for (const float c : coverage) ink::lay(ink, c, picture.at(x++, y));
                    });
  }
}

std::vector<InkedLine> random_lines(int count, int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  std::vector<InkedLine> lines;
  for (int i = 0; i < count; ++i) {
    const glm::vec2 from{between(-20, static_cast<float>(width) + 20),
                         between(-20, static_cast<float>(height) + 20)};
    const float angle = between(0, 6.2832f);
    const float length = std::exp2(between(-5, i % 10 == 0 ? 15.0f : 7.0f));
    glm::vec2 to = from + length * glm::vec2(std::cos(angle), std::sin(angle));
    if (i % 11 == 0) to.x = from.x;
    if (i % 13 == 0) to.y = from.y;
    lines.push_back({{from, to},
                     {between(-0.2f, 1.2f), between(0, 1), between(0, 1),
                      i % 3 ? 1.0f : between(-0.2f, 1.2f)}});
  }
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  lines[static_cast<std::size_t>(count / 2)].segment.to.y = kNan;
  lines[static_cast<std::size_t>(count / 3)].segment.from.x = INFINITY;
  return lines;
}

template <typename Pixel>
bool same_bits(const Image<Pixel>& a, const Image<Pixel>& b) {
  return std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size_bytes()) == 0;
}

/// Every instruction set, number of threads, cap, mixing and width.
template <typename Pixel>
void expect_reference(Pixel ground, int width, int height, unsigned seed) {
  const SimdGuard guard;
  const std::vector<InkedLine> lines = random_lines(150, width, height, seed);
  for (const float line_width : {1.0f, 0.6f, 2.2f, 9.0f}) {
    for (const Cap cap : {Cap::kButt, Cap::kSquare, Cap::kRound}) {
      for (const Mixing mixing : {Mixing::kOver, Mixing::kAdd}) {
        Image<Pixel> reference(width, height, ground);
        draw_reference(lines, {line_width, cap}, mixing, reference);
        for (const std::string& name : simd_targets()) {
          use_simd_target(name);
          Workers workers(2);
          LinePainter painter(workers);
          Image<Pixel> picture(width, height, ground);
          painter.draw(lines, {line_width, cap}, mixing, picture);
          EXPECT_TRUE(same_bits(picture, reference))
              << name << ": " << width << "x" << height << ", " << line_width << " px, cap "
              << static_cast<int>(cap) << ", mixing " << static_cast<int>(mixing);
        }
      }
    }
  }
}

TEST(LinePainter, EqualsTheReferenceOnEveryInstructionSet) {
  expect_reference(Linear8{10, 200, 30, 255}, 150, 170, 1);
  expect_reference(LinearRgba{0.1f, 0.8f, 0.2f, 1}, 150, 170, 2);
}

TEST(LinePainter, PicturesNarrowerThanAVector) {
  for (const int width : {1, 2, 3, 4, 5, 7, 8, 9, 13}) {
    expect_reference(Linear8{10, 200, 30, 255}, width, 40, 3);
    expect_reference(LinearRgba{0.1f, 0.8f, 0.2f, 1}, width, 40, 4);
  }
}

TEST(LinePainter, SameForAnyThreadCount) {
  // More than one chunk of lines, and bands of which the last is not whole.
  const std::vector<InkedLine> lines = random_lines(10000, 300, 333, 5);
  const auto draw = [&](int threads) {
    Workers workers(threads);
    LinePainter painter(workers);
    Image<Linear8> picture(300, 333);
    painter.draw(lines, Stroke{}, Mixing::kOver, picture);
    return picture;
  };
  const Image<Linear8> one = draw(1);
  Image<Linear8> reference(300, 333);
  draw_reference(lines, Stroke{}, Mixing::kOver, reference);
  EXPECT_TRUE(one == reference);
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(draw(threads) == one) << threads;
}

TEST(LinePainter, KeepsItsMemoryButNothingOfThePictureBefore) {
  Workers workers(2);
  LinePainter painter(workers);
  Image<Linear8> large(200, 500), small(40, 30), fresh(40, 30);
  painter.draw(random_lines(500, 200, 500, 6), {3, Cap::kRound}, Mixing::kOver, large);
  const std::vector<InkedLine> few = random_lines(20, 40, 30, 7);
  painter.draw(few, Stroke{}, Mixing::kOver, small);
  painter.draw({}, Stroke{}, Mixing::kOver, small);
  LinePainter(workers).draw(few, Stroke{}, Mixing::kOver, fresh);
  EXPECT_TRUE(small == fresh);
  Image<Linear8> none;
  painter.draw(few, Stroke{}, Mixing::kOver, none);
}

TEST(LinePainter, TheLastLineLiesOnTop) {
  std::vector<InkedLine> lines{{{{0, 5}, {20, 5}}, {1, 0, 0, 1}},
                               {{{9, 0}, {9, 20}}, {0, 0, 1, 1}}};
  Workers workers(2);
  LinePainter painter(workers);
  Image<Linear8> picture(20, 20);
  painter.draw(lines, {2, Cap::kButt}, Mixing::kOver, picture);
  EXPECT_EQ(picture.at(9, 5), (Linear8{0, 0, 255, 255}));
  EXPECT_EQ(picture.at(3, 5), (Linear8{255, 0, 0, 255}));
  std::swap(lines[0], lines[1]);
  painter.draw(lines, {2, Cap::kButt}, Mixing::kOver, picture);
  EXPECT_EQ(picture.at(9, 5), (Linear8{255, 0, 0, 255}));
}

TEST(LinePainter, AddedLightAddsUpAndSaturates) {
  const std::vector<InkedLine> lines(3, {{{0, 2.5f}, {8, 2.5f}}, {0.4f, 0.1f, 0, 1}});
  Workers workers(1);
  LinePainter painter(workers);
  Image<Linear8> codes(8, 5, {0, 0, 7, 9});
  painter.draw(lines, {1, Cap::kButt}, Mixing::kAdd, codes);
  EXPECT_EQ(codes.at(4, 2), (Linear8{255, 78, 7, 9}));
  Image<LinearRgba> light(8, 5, {0, 0, 0, 0.5f});
  painter.draw(lines, {1, Cap::kButt}, Mixing::kAdd, light);
  EXPECT_NEAR(light.at(4, 2).r, 1.2f, 1e-6);
  EXPECT_EQ(light.at(4, 2).a, 0.5f);
}

TEST(LinePainter, PixelsThatAreNotCoveredStayWhateverTheyHold) {
  Workers workers(1);
  LinePainter painter(workers);
  const InkedLine line{{{10.2f, 10.7f}, {50.1f, 33.3f}}, {1, 1, 1, 1}};
  Image<LinearRgba> light(64, 64, {0, 0, 0, 0});
  painter.draw({&line, 1}, Stroke{}, Mixing::kAdd, light);
  for (const Mixing mixing : {Mixing::kOver, Mixing::kAdd}) {
    const LinearRgba ground{INFINITY, 2, -INFINITY, 0.5f};
    Image<LinearRgba> picture(64, 64, ground);
    painter.draw({&line, 1}, Stroke{}, mixing, picture);
    int touched = 0;
    for (std::size_t i = 0; i < light.pixels().size(); ++i) {
      if (light.pixels()[i].r == 0) {
        EXPECT_EQ(picture.pixels()[i], ground);
      } else {
        ++touched;
      }
    }
    EXPECT_GT(touched, 60);
  }
}

}  // namespace
}  // namespace kinescope
