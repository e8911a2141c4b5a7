// Large triangles drawn as spans, depth and visibility only: pixels a second. One core.
#include <algorithm>

#include "bench/rates.h"
#include "bench/triangle_field.h"
#include "raster/rasterizer.h"

namespace kinescope::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;

/// Enough triangles to cover every pixel about sixteen times.
void fill_spans(benchmark::State& state) {
  const double leg = static_cast<double>(state.range(0)), covered = leg * leg / 2;
  const int count = std::max(1, static_cast<int>(16.0 * kWidth * kHeight / covered));
  const TriangleField field(count, static_cast<float>(leg), kWidth, kHeight);
  const DrawCall call = field.call();
  Workers workers(1);
  Rasterizer rasterizer(workers);
  RenderTarget target(kWidth, kHeight, static_cast<int>(state.range(1)), ColourFormat::kLinear8);
  for (auto _ : state) rasterizer.draw(target, {&call, 1});
  count_rate(state, "pixels/s", count * covered);
  count_rate(state, "triangles/s", count);
}
BENCHMARK(fill_spans)
    ->ArgNames({"leg_px", "samples"})
    ->ArgsProduct({{50, 200, 1000}, {1, 4, 8}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kinescope::bench

BENCHMARK_MAIN();
