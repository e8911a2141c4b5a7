// Coverage against a definition written another way: which side of each edge's line does a sample
// share with the opposite corner, in 128-bit integers.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "raster/rasterizer.h"
#include "raster/reference_rasterizer.h"
#include "raster/sample_pattern.h"
#include "tests/exactness/coverage_oracle.h"
#include "tests/exactness/families.h"
#include "tests/raster/triangle_soup.h"
#include "tests/sanitized.h"

namespace kinescope {
namespace {

using exactness::CoverageOracle, exactness::Family, exactness::sample_point;

constexpr int kScale = kSanitized ? 16 : 1;

CoverageOracle oracle(const TriangleSoup& soup, std::size_t triangle) {
  std::array<exactness::Point, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const TestVertex v = soup.vertex(3 * triangle + i);
    out[i] = exactness::snapped(v.x, v.y);
  }
  return CoverageOracle(out);
}

Image<LinearRgba> draw_ids(const TriangleSoup& soup, int width, int height) {
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget target(width, height, 1, ColourFormat::kLinearFloat);
  target.clear.r = -1;
  const DrawCall call = soup.call(shade_primitive);
  rasterizer.draw(target, {&call, 1});
  return std::get<Image<LinearRgba>>(target.colour);
}

/// One triangle a cell of a sheet: each is compared alone, many are drawn at once.
int count_differences_on_a_sheet(unsigned seed, int cell, float reach, int across) {
  RandomTriangles random(seed);
  TriangleSoup soup;
  const auto middle = [&](int i) {
    return (static_cast<float>(i) + 0.5f) * static_cast<float>(cell);
  };
  for (int row = 0; row < across; ++row) {
    for (int column = 0; column < across; ++column) {
      const auto t = random.triangle(middle(column), middle(row), reach);
      soup.add(t[0], t[1], t[2]);
    }
  }
  const Image<LinearRgba> drawn = draw_ids(soup, cell * across, cell * across);
  int differences = 0;
  for (std::size_t i = 0; i < soup.size(); ++i) {
    const CoverageOracle t = oracle(soup, i);
    const int x0 = static_cast<int>(i) % across * cell, y0 = static_cast<int>(i) / across * cell;
    for (int y = y0; y < y0 + cell; ++y) {
      for (int x = x0; x < x0 + cell; ++x) {
        const bool expected = t.covers(sample_point(x, y, sample_pattern(1)[0]));
        const float want = expected ? static_cast<float>(i) : -1.0f;
        differences += drawn.at(x, y).r != want;
      }
    }
  }
  return differences;
}

/// The picture itself; the families below go by the hash of what is visible.
TEST(CoverageOracle, ColoursShowTheTriangleThatCovers) {
  for (unsigned seed = 0; seed < 6 / kScale + 1; ++seed) {
    EXPECT_EQ(count_differences_on_a_sheet(seed, 3, 1.4f, 200), 0) << seed;
    EXPECT_EQ(count_differences_on_a_sheet(100 + seed, 8, 3.9f, 130), 0) << seed;
    EXPECT_EQ(count_differences_on_a_sheet(300 + seed, 48, 23.9f, 12), 0) << seed;
    EXPECT_EQ(count_differences_on_a_sheet(400 + seed, 150, 74.0f, 4), 0) << seed;
  }
}

/// Sheets of one family at every sample count. @return how many triangles there were
std::uint64_t expect_exact(Family family, unsigned sheets) {
  exactness::Comparer comparer;
  exactness::Tally tally;
  for (const int samples : {1, 4, 8}) {
    for (unsigned seed = 0; seed < (sheets - 1) / kScale + 1; ++seed) {
      const exactness::Tally sheet = exactness::compare(comparer, family, seed, samples);
      EXPECT_EQ(sheet.differing, 0u) << samples << " samples, seed " << seed;
      tally += sheet;
    }
  }
  EXPECT_GT(tally.samples, tally.triangles);
  return tally.triangles;
}

TEST(CoverageOracle, AMillionTriangles) {
  std::uint64_t triangles = 0;
  triangles += expect_exact(Family::kTiny, 6);
  triangles += expect_exact(Family::kSmall, 6);
  triangles += expect_exact(Family::kMiddling, 12);
  triangles += expect_exact(Family::kSharedEdges, 12);
  triangles += expect_exact(Family::kOffScreen, 12);
  triangles += expect_exact(Family::kGuardBand, 12);
  EXPECT_GE(triangles, 1'000'000u / kScale);
}

/// The comparison is able to fail: of two triangles over each other one hides the other.
TEST(CoverageOracle, SeesASampleThatTwoTrianglesCover) {
  TriangleSoup soup;
  soup.add({0, 0}, {0, 9}, {9, 0});
  soup.add({1, 1}, {1, 4}, {4, 1});
  const DrawCall call = soup.call(nullptr);
  exactness::Comparer comparer;
  EXPECT_EQ(comparer.compare(call, 10, 10, 1).differing, 1u);
}

TEST(CoverageOracle, TrianglesAsLargeAsTheGuardBand) {
  RandomTriangles random(7);
  for (int i = 0; i < 1200 / kScale; ++i) {
    TriangleSoup soup;
    const float reach = i % 3 == 0 ? 200.0f : i % 3 == 1 ? 3000.0f : 32600.0f;
    const auto t = random.triangle(40, 35, reach);
    soup.add(t[0], t[1], t[2]);
    const Image<LinearRgba> drawn = draw_ids(soup, 80, 70);
    const CoverageOracle only = oracle(soup, 0);
    int differences = 0;
    for (int y = 0; y < 70; ++y) {
      for (int x = 0; x < 80; ++x) {
        const bool expected = only.covers(sample_point(x, y, sample_pattern(1)[0]));
        differences += drawn.at(x, y).r != (expected ? 0.0f : -1.0f);
      }
    }
    ASSERT_EQ(differences, 0) << "triangle " << i;
  }
}

/// The reference image's coverage of every sample, for all patterns; fast paths equal it by hash.
TEST(CoverageOracle, ReferenceAtEverySampleCount) {
  for (const int samples : {1, 4, 8}) {
    RandomTriangles random(static_cast<unsigned>(samples));
    const TriangleSoup soup = random.soup(400 / kScale, 50, 40);
    const DrawCall call = soup.call(nullptr);
    const ReferenceImage reference = draw_reference(50, 40, samples, {&call, 1});
    std::vector<CoverageOracle> triangles;
    for (std::size_t i = 0; i < soup.size(); ++i) triangles.push_back(oracle(soup, i));
    std::size_t at = 0;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 50; ++x) {
        for (const SampleOffset& offset : sample_pattern(samples)) {
          std::uint32_t count = 0;
          for (const auto& t : triangles) count += t.covers(sample_point(x, y, offset));
          ASSERT_EQ(reference.coverage[at++], count) << x << "," << y;
        }
      }
    }
  }
}

/// A closed mesh in the plane: a jittered grid. Every sample inside is covered by one triangle.
TEST(CoverageOracle, AMeshWithoutHolesCoversEachSampleOnce) {
  for (const int samples : {1, 4, 8}) {
    for (const float cell : {0.9f, 3.0f, 9.0f, 33.0f}) {
      RandomTriangles random(static_cast<unsigned>(cell));
      const int across = static_cast<int>(70 / cell) + 3;
      std::vector<TestVertex> grid;
      for (int j = 0; j <= across; ++j) {
        for (int i = 0; i <= across; ++i) {
          // The rim lies outside the target; jitter of less than half a cell folds nothing over.
          const bool rim = i == 0 || j == 0 || i == across || j == across;
          TestVertex v = random.vertex(0, 0, rim ? 0.0f : 0.24f * cell);
          if (cell < 2) v = {random.between(-.2f, .2f), random.between(-.2f, .2f)};
          v.x = (static_cast<float>(i) - 1) * cell + (rim ? 0 : v.x);
          v.y = (static_cast<float>(j) - 1) * cell + (rim ? 0 : v.y);
          grid.push_back(v);
        }
      }
      TriangleSoup soup;
      for (int j = 0; j < across; ++j) {
        for (int i = 0; i < across; ++i) {
          const auto at = [&](int x, int y) {
            return grid[static_cast<std::size_t>((j + y) * (across + 1) + i + x)];
          };
          soup.add(at(0, 0), at(1, 0), at(1, 1));
          soup.add(at(0, 0), at(1, 1), at(0, 1));
        }
      }
      const int size = static_cast<int>(static_cast<float>(across - 2) * cell) - 8;
      if (size < 1) continue;
      const DrawCall call = soup.call(shade_primitive);
      const ReferenceImage reference = draw_reference(size, size, samples, {&call, 1});
      for (const std::uint32_t count : reference.coverage) ASSERT_EQ(count, 1u) << cell;
      Workers workers(1);
      Rasterizer rasterizer(workers);
      RenderTarget target(size, size, samples);
      EXPECT_EQ(rasterizer.draw(target, {&call, 1}, true).visibility_hash,
                reference.visibility_hash);
    }
  }
}

/// Drawn additively: the two sides of a closed body cover each sample equally often.
TEST(CoverageOracle, AClosedBodyIsEnteredAsOftenAsItIsLeft) {
  RandomTriangles random(5);
  constexpr int kRings = 14, kAround = 17;
  std::vector<TestVertex> v;
  for (int i = 0; i < kRings; ++i) {
    for (int j = 0; j < kAround; ++j) {
      v.push_back({random.between(0, 60), random.between(0, 60), 0.5f});
    }
  }
  TriangleSoup torus;
  const auto at = [&](int i, int j) {
    return v[static_cast<std::size_t>((i % kRings) * kAround + j % kAround)];
  };
  for (int i = 0; i < kRings; ++i) {
    for (int j = 0; j < kAround; ++j) {
      torus.add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      torus.add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  const DrawCall fronts = torus.call(nullptr, CullMode::kBack);
  const DrawCall backs = torus.call(nullptr, CullMode::kFront);
  const ReferenceImage front = draw_reference(60, 60, 4, {&fronts, 1});
  const ReferenceImage back = draw_reference(60, 60, 4, {&backs, 1});
  EXPECT_EQ(front.coverage, back.coverage);
  EXPECT_GT(front.coverage[(30 * 60 + 30) * 4], 3u);
}

}  // namespace
}  // namespace kinescope
