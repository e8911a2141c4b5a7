// Filled paths against areas found by cutting polygons to pixels, and against the readable
// reference bit by bit.
#include "raster/path/path_painter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include "raster/base/simd.h"
#include "tests/raster/area_oracle.h"

namespace kinescope {
namespace {

class SimdGuard {
 public:
  ~SimdGuard() { use_simd_target("best"); }
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float between(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine_);
  }
  /// Corners around a centre, so that edges meet at corners only.
  Corners star(glm::vec2 centre, float least, float most, int count) {
    Corners star;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * (i + between(0.1f, 0.9f)) / count;
      const double radius = between(least, most);
      star.push_back(glm::dvec2(
          glm::vec2(glm::dvec2(centre) + radius * glm::dvec2(std::cos(angle), std::sin(angle)))));
    }
    return star;
  }

 private:
  std::mt19937 engine_;
};

void add(const Corners& corners, bool backwards, Path& path) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::vec2 p = corners[backwards ? corners.size() - 1 - i : i];
    i == 0 ? path.move_to(p) : path.line_to(p);
  }
  path.close();
}

/// White light on black: coverage itself.
Image<LinearRgba> fill(const Path& path, FillRule rule, int width, int height) {
  Workers workers(2);
  PathPainter painter(workers);
  Image<LinearRgba> picture(width, height, {0, 0, 0, 1});
  FilledPath filled{&path};
  filled.rule = rule;
  filled.ink.colour = {1, 1, 1, 1};
  painter.draw({&filled, 1}, 0.01f, picture);
  return picture;
}

TEST(PathPainter, CoversTheAreaOfAPolygonWithAHole) {
  Random random(1);
  for (int n = 0; n < 200; ++n) {
    const glm::vec2 centre{random.between(-5, 45), random.between(-5, 35)};
    const Corners outer = random.star(centre, 8, 25, 3 + n % 9);
    // Well within: the least distance of the outer edges is large where there are many.
    const Corners inner = random.star(centre, 0.5f, n % 9 > 3 ? 1.5f : 0.1f, 5);
    Path path;
    const bool even_odd = n % 2;
    add(outer, false, path);
    add(inner, !even_odd, path);
    const Image<LinearRgba> picture =
        fill(path, even_odd ? FillRule::kEvenOdd : FillRule::kNonZero, 40, 90);
    for (int y = 0; y < 90; ++y) {
      for (int x = 0; x < 40; ++x) {
        const double hole = area_in_pixel(inner, x, y);
        const double area = area_in_pixel(outer, x, y) - (n % 9 > 3 ? hole : 0);
        const double tolerance = n % 9 > 3 ? 0.0005 : 0.0005 + std::abs(hole);
        ASSERT_NEAR(picture.at(x, y).r, area, tolerance) << n << ": " << x << ' ' << y;
      }
    }
  }
}

TEST(PathPainter, ThousandsOfTinyEdgesAddUp) {
  Path path;
  Corners circle;
  for (int i = 0; i < 20000; ++i) {
    const double t = 2 * std::numbers::pi * i / 20000;
    circle.push_back(glm::dvec2(glm::vec2(20 + 15.3 * std::cos(t), 20 + 15.3 * std::sin(t))));
  }
  add(circle, false, path);
  const Image<LinearRgba> picture = fill(path, FillRule::kNonZero, 40, 40);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      ASSERT_NEAR(picture.at(x, y).r, area_in_pixel(circle, x, y), 0.5 / 255) << x << ' ' << y;
    }
  }
}

TEST(PathPainter, CurvesAreFilledWithinTheTolerance) {
  Path path;
  constexpr float k = 0.5522848f * 12;  // a circle of four cubics
  path.move_to({32, 20});
  path.cubic_to({32, 20 + k}, {20 + k, 32}, {20, 32});
  path.cubic_to({20 - k, 32}, {8, 20 + k}, {8, 20});
  path.cubic_to({8, 20 - k}, {20 - k, 8}, {20, 8});
  path.cubic_to({20 + k, 8}, {32, 20 - k}, {32, 20});
  float sum = 0;
  const Image<LinearRgba> picture = fill(path, FillRule::kNonZero, 40, 40);
  for (const LinearRgba& p : picture.pixels()) sum += p.r;
  EXPECT_NEAR(sum, std::numbers::pi * 144, 0.01 * 2 * std::numbers::pi * 12);
}

TEST(PathPainter, PlacesPathsByTheirMatrix) {
  Path square;
  add({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, false, square);
  Workers workers(1);
  PathPainter painter(workers);
  Image<Linear8> picture(8, 8);
  FilledPath filled{&square, {0, 3, 2, 0, 4, 1}};  // turned and stretched to [4, 6) x [1, 4)
  filled.ink.colour = {1, 0, 0, 1};
  painter.draw({&filled, 1}, 0.1f, picture);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const bool inside = x >= 4 && x < 6 && y >= 1 && y < 4;
      EXPECT_EQ(picture.at(x, y).r, inside ? 255 : 0) << x << ' ' << y;
    }
  }
}

/// Overlapping contours of any kind, partly outside, with curves.
struct Drawing {
  Drawing(int count, float width, float height, unsigned seed) : paths(count) {
    Random random(seed);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      for (int contour = 0; contour < 2; ++contour) {
        const auto point = [&, centre = glm::vec2(random.between(0, width),
                                                  random.between(0, height))]() {
          const float reach = i % 5 ? 30 : 300;
          return centre + glm::vec2(random.between(-reach, reach), random.between(-reach, reach));
        };
        paths[i].move_to(point());
        for (int k = 0; k < 4; ++k) {
          paths[i].line_to(point());
          paths[i].quadratic_to(point(), point());
          paths[i].cubic_to(point(), point(), point());
        }
      }
      FilledPath f{&paths[i]};
      f.rule = i % 2 ? FillRule::kEvenOdd : FillRule::kNonZero;
      f.ink = {{random.between(0, 1), random.between(0, 1), random.between(0, 1),
                i % 3 ? 1.0f : random.between(0, 1)},
               i % 7 ? Mixing::kOver : Mixing::kAdd};
      fills.push_back(f);
    }
  }
  std::vector<Path> paths;
  std::vector<FilledPath> fills;
};

constexpr float kTolerancePx = 0.05f;

/// Each path in one box of its own, pixel by pixel.
template <typename Pixel>
void draw_reference(std::span<const FilledPath> fills, Image<Pixel>& picture) {
  for (const FilledPath& fill : fills) {
    ExactArea area(picture.width(), picture.height());
    path_edges(*fill.path, fill.place, kTolerancePx,
               [&](glm::vec2 a, glm::vec2 b) { area.add_edge(a, b); });
    const typename ink::FormFor<Pixel>::Type ink(fill.ink);
    area.rows(fill.rule, [&](int y, std::span<const float> row) {
      for (int x = 0; x < picture.width(); ++x) {
        ink::lay(ink, row[static_cast<std::size_t>(x)], picture.at(x, y));
      }
    });
  }
}

template <typename Pixel>
void expect_reference(int width, int height, unsigned seed) {
  const SimdGuard guard;
  const Drawing drawing(40, static_cast<float>(width), static_cast<float>(height), seed);
  Image<Pixel> reference(width, height);
  draw_reference(drawing.fills, reference);
  for (const std::string& name : simd_targets()) {
    use_simd_target(name);
    for (const int threads : {1, 2, 8}) {
      Workers workers(threads);
      PathPainter painter(workers);
      Image<Pixel> picture(width, height);
      painter.draw(drawing.fills, kTolerancePx, picture);
      EXPECT_EQ(std::memcmp(picture.pixels().data(), reference.pixels().data(),
                            reference.pixels().size_bytes()),
                0)
          << name << ", " << threads << " threads, " << width << "x" << height;
    }
  }
}

TEST(PathPainter, EqualsTheReferenceOnEveryInstructionSetAndThreadCount) {
  for (const auto& [width, height] : {std::pair{200, 150}, {1, 90}, {7, 70}, {8, 64}, {65, 129}}) {
    expect_reference<Linear8>(width, height, static_cast<unsigned>(width));
    expect_reference<LinearRgba>(width, height, static_cast<unsigned>(width) + 1);
  }
}

TEST(PathPainter, SameFrameAfterFrame) {
  const Drawing large(30, 400, 300, 8), small(10, 60, 40, 9);
  Workers workers(2);
  PathPainter painter(workers);
  Image<Linear8> first(60, 40), again(60, 40), other(400, 300), none;
  painter.draw(small.fills, kTolerancePx, first);
  painter.draw(large.fills, kTolerancePx, other);
  painter.draw(small.fills, kTolerancePx, again);
  painter.draw(small.fills, kTolerancePx, none);
  EXPECT_TRUE(first == again);
}

TEST(PathPainter, PointsThatAreNotFiniteAreLeftOut) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Path whole, broken;
  add({{2, 2}, {10, 3}, {9, 11}, {3, 9}}, false, whole);
  broken.move_to({kNan, 2});
  broken.line_to({2, 2});
  broken.line_to({10, 3});
  broken.line_to({INFINITY, 5});
  broken.quadratic_to({kNan, 1}, {9, 11});
  broken.line_to({3, 9});
  broken.close();
  const Image<LinearRgba> a = fill(whole, FillRule::kNonZero, 14, 14);
  const Image<LinearRgba> b = fill(broken, FillRule::kNonZero, 14, 14);
  EXPECT_TRUE(a == b);
}

TEST(PathPainter, HugeCoordinatesCoverWhatTheyShould) {
  Path path;
  constexpr float kBig = 1e30f;
  add({{-kBig, -kBig}, {kBig, -kBig}, {kBig, kBig}, {-kBig, kBig}}, false, path);
  const Image<LinearRgba> picture = fill(path, FillRule::kNonZero, 9, 70);
  for (const LinearRgba& p : picture.pixels()) EXPECT_EQ(p.r, 1);
}

}  // namespace
}  // namespace kinescope
