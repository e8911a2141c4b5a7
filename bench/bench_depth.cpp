// Depth only, from device vertices to the nearest triangle of each sample: the work of an occlusion
// culler, with exact depth. One core.
#include <algorithm>

#include "bench/rates.h"
#include "bench/triangle_field.h"
#include "raster/rasterizer.h"

namespace kinescope::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;

/// Legs of 2 pixels make small triangles, of 10 and 20 medium ones.
void depth_only(benchmark::State& state) {
  const auto leg = static_cast<int>(state.range(0));
  const int count = std::min(200'000, 50'000'000 / (leg * leg));
  const TriangleField field(count, static_cast<float>(leg), kWidth, kHeight);
  const DrawCall call = field.call();
  Workers workers(1);
  Rasterizer rasterizer(workers);
  RenderTarget target(kWidth, kHeight, static_cast<int>(state.range(1)), ColourFormat::kLinear8);
  for (auto _ : state) rasterizer.draw(target, {&call, 1});
  count_rate(state, "triangles/s", count);
}
BENCHMARK(depth_only)
    ->ArgNames({"leg_px", "samples"})
    ->ArgsProduct({{2, 10, 20}, {1, 4, 8}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kinescope::bench

BENCHMARK_MAIN();
