// What no caller should hand in, and what one may hand in too much of.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <numeric>

#include "raster/base/error.h"
#include "raster/rasterizer.h"
#include "tests/raster/triangle_soup.h"
#include "tests/sanitized.h"

namespace kinescope {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr std::uint64_t kScale = kSanitized ? 16 : 1;

void show_attribute(const Batch& b, LinearRgba* out) {
  for (int i = 0; i < b.size; ++i) out[i] = {b.attribute[0][i], 0.5f, 0, 1};
}

/// Two triangles side by side, with one attribute a vertex; the first is the one to spoil.
struct Pair {
  Pair() {
    soup.add({1, 1}, {1, 30}, {30, 1});
    soup.add({33, 1}, {33, 30}, {62, 1});
    rows.assign(6, 0.25f);
  }
  DrawCall call() const {
    DrawCall c = soup.call(show_attribute);
    c.attributes = rows;
    c.attribute_count = c.attribute_stride = 1;
    return c;
  }
  TriangleSoup soup;
  std::vector<float> rows;
};

RenderTarget draw(const DrawCall& call, int samples, ColourFormat format) {
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget target(64, 32, samples, format);
  rasterizer.draw(target, {&call, 1});
  return target;
}

TEST(BadInput, NotANumberInAnAttributeStaysInItsTriangle) {
  for (const float bad : {kNan, kInfinity, -kInfinity, 3e38f}) {
    for (const int samples : {1, 4, 8}) {
      Pair good, spoilt;
      spoilt.rows[1] = bad;
      const RenderTarget want = draw(good.call(), samples, ColourFormat::kLinearFloat);
      const RenderTarget got = draw(spoilt.call(), samples, ColourFormat::kLinearFloat);
      const auto& a = std::get<Image<LinearRgba>>(want.colour);
      const auto& b = std::get<Image<LinearRgba>>(got.colour);
      for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 64; ++x) {
          // The other triangle, its neighbours in a batch, and the other channels.
          if (x >= 32) {
            ASSERT_EQ(a.at(x, y), b.at(x, y)) << x << "," << y;
          }
          ASSERT_EQ(a.at(x, y).g, b.at(x, y).g) << x << "," << y;
        }
      }
      // Encoded, it is some colour: no crash, and the target's other pixels hold.
      draw(spoilt.call(), samples, ColourFormat::kSrgb8);
      draw(spoilt.call(), samples, ColourFormat::kLinear8);
    }
  }
}

/// Never from the pipeline, which cuts at w > 0; a caller's mistake must not spread.
TEST(BadInput, ImpossiblePerspectiveStaysInItsTriangle) {
  for (const float bad : {kNan, kInfinity, 0.0f, -1.0f, 1e-38f, 1e30f}) {
    TriangleSoup spoilt;
    spoilt.add({1, 1, 0.5f, bad}, {1, 30, 0.5f, 1}, {30, 1, 0.5f, bad});
    spoilt.add({33, 1}, {33, 30}, {62, 1});
    Pair good;
    DrawCall call = good.call();
    const RenderTarget want = draw(call, 4, ColourFormat::kLinearFloat);
    call.vertices = spoilt.call(nullptr).vertices;
    const RenderTarget got = draw(call, 4, ColourFormat::kLinearFloat);
    const auto& a = std::get<Image<LinearRgba>>(want.colour);
    const auto& b = std::get<Image<LinearRgba>>(got.colour);
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 64; ++x) {
        if (x >= 32) {
          ASSERT_EQ(a.at(x, y), b.at(x, y)) << bad << " at " << x << "," << y;
        }
        ASSERT_EQ(a.at(x, y).g, b.at(x, y).g) << bad << " at " << x << "," << y;
      }
    }
  }
}

TEST(BadInput, NoTrianglesAndCallsWithNone) {
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget target(20, 10, 1);
  target.clear = {1, 1, 1, 1};
  const DrawCall empty;
  const std::vector<DrawCall> calls(1000, empty);
  EXPECT_EQ(rasterizer.draw(target, {}).triangles, 0u);
  const RasterStats stats = rasterizer.draw(target, calls, true);
  EXPECT_EQ(stats.triangles, 0u);
  EXPECT_EQ(stats.visibility_hash, 0u);
  for (const Srgb8& p : target.srgb8().pixels()) EXPECT_EQ(p, (Srgb8{255, 255, 255, 255}));
}

TEST(BadInput, IndicesLeftOverMakeNoTriangle) {
  Pair pair;
  DrawCall call = pair.call();
  call.indices = call.indices.first(5);
  Workers workers(1);
  Rasterizer rasterizer(workers);
  RenderTarget target(64, 32);
  EXPECT_EQ(rasterizer.draw(target, {&call, 1}).triangles, 1u);
}

/// The right half of the target under ten million small triangles, one call.
TEST(BadInput, TenMillionTrianglesInOneCall) {
  constexpr std::uint64_t kCount = 10'000'000 / kScale;
  RandomTriangles random(3);
  TriangleSoup soup;
  for (int i = 0; i < 1000; ++i) {
    const float x = random.between(33, 62), y = random.between(1, 30), z = random.between(0.1f, 1);
    soup.add({x, y, z}, {x, y + 1.6f, z}, {x + 1.6f, y, z});
  }
  DrawCall call = soup.call(shade_primitive);
  std::vector<std::uint32_t> indices(3 * kCount);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    indices[i] = static_cast<std::uint32_t>(i % (3 * soup.size()));
  }
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget few(64, 32), many(64, 32);
  const RasterStats once = rasterizer.draw(few, {&call, 1}, true);
  call.indices = indices;
  const RasterStats often = rasterizer.draw(many, {&call, 1}, true);
  EXPECT_EQ(often.triangles, kCount);
  EXPECT_EQ(often.drawn, once.drawn * (kCount / soup.size()));
  // Of equal depths the first is kept: the repeats change nothing.
  EXPECT_EQ(often.visibility_hash, once.visibility_hash);
  EXPECT_EQ(often.fragments, once.fragments);
}

TEST(BadInput, SixtyFiveThousandCallsOfOneTriangle) {
  constexpr int kCalls = 65536, kAcross = 256;
  std::vector<DeviceVertex> vertices;
  std::vector<std::uint32_t> indices(3 * kCalls);
  std::iota(indices.begin(), indices.end(), 0u);
  std::vector<LinearRgba> colours;
  for (int i = 0; i < kCalls; ++i) {
    const auto column = static_cast<float>(i % kAcross), row = static_cast<float>(i / kAcross);
    vertices.push_back({column, row, 0.5f, 1});  // holds one pixel's centre
    vertices.push_back({column, row + 1.9f, 0.5f, 1});
    vertices.push_back({column + 1.9f, row, 0.5f, 1});
    colours.push_back({static_cast<float>(i), 0, 0, 1});
  }
  std::vector<DrawCall> calls(kCalls);
  for (std::size_t i = 0; i < calls.size(); ++i) {
    calls[i].vertices = vertices;
    calls[i].indices = std::span(indices).subspan(3 * i, 3);
    calls[i].constants = &colours[i];
    calls[i].shade = [](const Batch& batch, LinearRgba* out) {
      std::fill_n(out, batch.size, *static_cast<const LinearRgba*>(batch.constants));
    };
  }
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget target(kAcross, kAcross, 1, ColourFormat::kLinearFloat);
  EXPECT_EQ(rasterizer.draw(target, calls).fragments, std::uint64_t{kCalls});
  const auto& drawn = std::get<Image<LinearRgba>>(target.colour);
  for (int i = 0; i < kCalls; ++i) {
    ASSERT_EQ(drawn.at(i % kAcross, i / kAcross).r, static_cast<float>(i));
  }
}

#ifndef KINESCOPE_SANITIZED
TEST(BadInput, AFrameThatMemoryCannotHoldEndsInOneLine) {
  const auto draw_with_little_memory = [] {
    RandomTriangles random(1);
    TriangleSoup soup;
    for (int i = 0; i < 1000; ++i) {
      const float x = random.between(0, 990), y = random.between(0, 990);
      soup.add({x, y}, {x, y + 7}, {x + 7, y});
    }
    DrawCall call = soup.call(shade_primitive);
    std::vector<std::uint32_t> indices(9'000'000);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      indices[i] = static_cast<std::uint32_t>(i % (3 * soup.size()));
    }
    call.indices = indices;
    Workers workers(1);
    Rasterizer rasterizer(workers);
    RenderTarget target(1000, 1000, 8);
    // Ten bytes a triangle more than it has now: less than any bin takes.
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit{};
    limit.rlim_cur = limit.rlim_max =
        pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + indices.size() / 3 * 10;
    setrlimit(RLIMIT_AS, &limit);
    try {
      rasterizer.draw(target, {&call, 1});
    } catch (const Error& e) {
      std::fputs(e.what(), stderr);
      std::_Exit(e.exit_code());
    }
    std::_Exit(0);
  };
  // In a process of its own, whose heap holds nothing that other tests gave back.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(draw_with_little_memory(), testing::ExitedWithCode(3),
              "no memory to draw this frame; fewer samples need less");
}
#endif

}  // namespace
}  // namespace kinescope
