// From visible samples to encoded pixels, with a shader that costs next to nothing. One core.
#include <algorithm>

#include "bench/rates.h"
#include "bench/triangle_field.h"
#include "raster/rasterizer.h"

namespace kinescope::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;

void shade_grey(const Batch& batch, LinearRgba* out) {
  std::fill_n(out, batch.size, LinearRgba{0.5f, 0.5f, 0.5f, 1.0f});
}

void resolve(benchmark::State& state, const DrawCall& geometry, ColourFormat format) {
  DrawCall call = geometry;
  call.shade = shade_grey;
  Workers workers(1);
  Rasterizer rasterizer(workers);
  RenderTarget target(kWidth, kHeight, static_cast<int>(state.range(0)), format);
  for (auto _ : state) rasterizer.draw(target, {&call, 1});
  count_rate(state, "pixels/s", double{kWidth} * kHeight);
}

/// One triangle fills the picture: the samples of every pixel agree.
void whole_pixels(benchmark::State& state, ColourFormat format) {
  const DeviceVertex vertices[] = {{-10, -10, 0.5f, 1}, {-10, 5000, 0.5f, 1}, {5000, -10, 0.5f, 1}};
  const std::uint32_t indices[] = {0, 1, 2};
  DrawCall call;
  call.vertices = vertices;
  call.indices = indices;
  resolve(state, call, format);
}
BENCHMARK_CAPTURE(whole_pixels, linear8, ColourFormat::kLinear8)
    ->ArgName("samples")
    ->Arg(1)
    ->Arg(4)
    ->Arg(8)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_pixels, srgb8, ColourFormat::kSrgb8)
    ->ArgName("samples")
    ->Arg(1)
    ->Arg(4)
    ->Arg(8)
    ->Unit(benchmark::kMillisecond);

/// Many triangles of six pixels: most pixels are cut by an edge.
void cut_pixels(benchmark::State& state) {
  const TriangleField field(100'000, 6.0f, kWidth, kHeight);
  resolve(state, field.call(), ColourFormat::kSrgb8);
}
BENCHMARK(cut_pixels)->ArgName("samples")->Arg(1)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kinescope::bench

BENCHMARK_MAIN();
