// The rasterizer's front end: triangles snapped, culled, set up and put into bins. One core.
#include <memory>

#include "bench/rates.h"
#include "bench/triangle_field.h"
#include "raster/binning.h"
#include "raster/kernels/bin_triangles.h"
#include "raster/kernels/cull.h"

namespace kinescope::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080, kTriangles = 64 * TriangleRange::kMaxCount;

/// The front end's buffers, and its steps as Rasterizer::draw takes them.
struct FrontEnd {
  explicit FrontEnd(int samples)
      : pattern(sample_pattern(samples)), grid(kWidth, kHeight, samples == 8 ? 32 : 64, 32) {}

  void cull(const DrawCall& call, std::uint32_t first) {
    cull_triangles(call, first, TriangleRange::kMaxCount, pattern, grid, true, *culled);
  }
  void bin(const DrawCall& call) {
    const SampleLimits limits = sample_limits(pattern);
    bin_pixels(culled->pixels, 0, grid, bins);
    bin_small_triangles(culled->small, 0, limits, grid, bins);
    bin_medium_triangles(culled->medium, 0, limits, grid, bins);
    SnappedTriangle triangle;
    const PixelRect all{0, 0, grid.width, grid.height};
    for (int i = 0; i < culled->large_size; ++i) {
      const std::uint32_t index = culled->large_triangle[static_cast<std::size_t>(i)];
      if (!set_up_triangle(call, index, triangle)) continue;
      bin_triangle(triangle, index, pattern, all, grid, bins.records, bins.record_pool);
    }
  }

  std::span<const SampleOffset> pattern;
  TileGrid grid;
  std::unique_ptr<CulledTriangles> culled = std::make_unique<CulledTriangles>();
  Bins bins;
};

void run(benchmark::State& state, const DrawCall& call, int samples) {
  FrontEnd front_end(samples);
  for (auto _ : state) {
    front_end.bins.clear(front_end.grid.count());
    for (std::uint32_t first = 0; first < kTriangles; first += TriangleRange::kMaxCount) {
      front_end.cull(call, first);
      front_end.bin(call);
    }
    benchmark::ClobberMemory();
  }
  count_rate(state, "triangles/s", kTriangles);
}

void cull_back_faces(benchmark::State& state) {
  const TriangleField field(kTriangles, static_cast<float>(state.range(0)), kWidth, kHeight);
  DrawCall call = field.call();
  call.cull = CullMode::kFront;
  run(state, call, 1);
}
BENCHMARK(cull_back_faces)->ArgName("leg_px")->Arg(2)->Arg(20);

/// Legs of 2 and 6 pixels are small, 12 and 30 of middle size, beyond that large.
void set_up_and_bin(benchmark::State& state) {
  const TriangleField field(kTriangles, static_cast<float>(state.range(0)), kWidth, kHeight);
  run(state, field.call(), static_cast<int>(state.range(1)));
}
BENCHMARK(set_up_and_bin)
    ->ArgNames({"leg_px", "samples"})
    ->ArgsProduct({{2, 6, 12, 30, 60, 200}, {1, 4, 8}});

}  // namespace
}  // namespace kinescope::bench

BENCHMARK_MAIN();
