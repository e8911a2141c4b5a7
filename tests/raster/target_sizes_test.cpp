// Targets from one pixel to the largest, and those that are refused.
#include "raster/render_target.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "raster/base/error.h"
#include "tests/raster/float_canvas.h"
#include "tests/raster/triangle_soup.h"

namespace kinescope {
namespace {

TEST(Rasterizer, OnePixel) {
  TriangleSoup soup;
  soup.add({0, 0}, {0, 3}, {3, 0});
  const DrawCall call = soup.call(shade_primitive);
  for (const int samples : {1, 4, 8}) {
    FloatCanvas canvas(1, 1, samples);
    canvas.target.clear.r = -1;
    EXPECT_EQ(canvas.draw({&call, 1}).fragments, 1u);
    EXPECT_EQ(canvas.at(0, 0).r, 0.0f);
  }
}

TEST(Rasterizer, TheLargestTargetToItsLastPixel) {
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget target(RenderTarget::kMaxSize, 16, 1);
  RenderTarget tall(16, RenderTarget::kMaxSize, 1);
  TriangleSoup soup;
  soup.add({-32768, -32768}, {-32768, 32768}, {32768, 32768});
  soup.add({-32768, -32768}, {32768, 32768}, {32768, -32768});
  const DrawCall call = soup.call([](const Batch& b, LinearRgba* out) {
    for (int i = 0; i < b.size; ++i) {
      out[i] = {static_cast<float>(b.x[i]) / 16383, static_cast<float>(b.y[i]) / 16383, 0, 1};
    }
  });
  EXPECT_EQ(rasterizer.draw(target, {&call, 1}).fragments, 16u * 16384);
  EXPECT_EQ(target.srgb8().at(16383, 15).r, 255);
  EXPECT_EQ(rasterizer.draw(tall, {&call, 1}).fragments, 16u * 16384);
  EXPECT_EQ(tall.srgb8().at(15, 16383).g, 255);
}

TEST(RenderTarget, RefusesSizesThatNoMemoryHolds) {
  for (const int bad : {0, -1, 16385, 1 << 30, std::numeric_limits<int>::min()}) {
    EXPECT_THROW(RenderTarget(bad, 10), Error) << bad;
    EXPECT_THROW(RenderTarget(10, bad), Error) << bad;
  }
  EXPECT_THROW(RenderTarget(10, 10, 3), Error);
}

#ifndef KINESCOPE_SANITIZED
TEST(RenderTarget, SaysSoWhenMemoryCannotBeHad) {
  const auto draw_with_little_memory = [] {
    rlimit limit{};
    limit.rlim_cur = limit.rlim_max = 600u << 20;
    setrlimit(RLIMIT_AS, &limit);
    try {
      const RenderTarget target(RenderTarget::kMaxSize, RenderTarget::kMaxSize);
    } catch (const Error& e) {
      std::fputs(e.what(), stderr);
      std::_Exit(3);
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(draw_with_little_memory(), testing::ExitedWithCode(3),
              "no memory for a picture of 16384x16384 \\(1073 MB\\)");
}
#endif

TEST(Rasterizer, RefusesTilesThatAreNotMultiplesOfEight) {
  Workers workers(1);
  RenderTarget target(10, 10);
  for (const int bad : {-8, 4, 12, 72}) {
    Rasterizer wide(workers, {bad, 8}), high(workers, {8, bad});
    EXPECT_THROW(wide.draw(target, {}), Error) << bad;
    EXPECT_THROW(high.draw(target, {}), Error) << bad;
  }
}

}  // namespace
}  // namespace kinescope
