// Whole frames, from a scene to encoded pixels.
#include "bench/rates.h"
#include "bench/workloads.h"
#include "engine/renderer.h"

namespace kinescope::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;

void draw_frame(benchmark::State& state, const char* name) {
  const Workload workload = make_workload(name);
  Workers workers(static_cast<int>(state.range(1)));
  Renderer renderer(workers);
  RenderTarget target(kWidth, kHeight, static_cast<int>(state.range(0)), ColourFormat::kLinear8);
  RenderSettings settings;
  settings.shading = workload.shading;
  int frame = 0;
  for (auto _ : state) {
    const Camera camera = workload.camera(frame++, static_cast<float>(kWidth) / kHeight);
    renderer.render(workload.scene, camera, settings, target);
  }
  count_rate(state, "frames/s", 1);
  count_rate(state, "triangles/s", static_cast<double>(drawn_triangle_count(workload.scene)));
  count_rate(state, "pixels/s", double{kWidth} * kHeight);
}
BENCHMARK_CAPTURE(draw_frame, knot_phong, "knot-phong")
    ->ArgNames({"samples", "threads"})
    ->ArgsProduct({{1, 4, 8}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_frame, knot_gouraud, "knot-gouraud")
    ->ArgNames({"samples", "threads"})
    ->ArgsProduct({{1, 4, 8}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kinescope::bench

BENCHMARK_MAIN();
