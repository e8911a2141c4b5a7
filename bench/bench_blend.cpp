// How fast layers of light are laid over one another: Mpix/s of blended fragments, 1920x1080.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "engine/framing.h"
#include "engine/renderer.h"
#include "engine/teapot.h"
#include "raster/rasterizer.h"

namespace kinescope::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;

/// A vertex colour, interpolated.
void shade_colour(const Batch& batch, LinearRgba* out) {
  const float* const r = batch.attribute[0];
  const float* const g = batch.attribute[1];
  const float* const b = batch.attribute[2];
  const float* const a = batch.attribute[3];
  for (int i = 0; i < batch.size; ++i) out[i] = {r[i], g[i], b[i], a[i]};
}

/// Rectangles with a colour at each corner.
class Rectangles {
 public:
  explicit Rectangles(unsigned seed) : random_(seed) {}

  float uniform(float lo, float hi) {
    return lo + (hi - lo) * static_cast<float>(random_() >> 8) * 0x1p-24f;
  }
  void add(float x0, float y0, float x1, float y1, float z) {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (const auto& [x, y] : {std::pair{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}) {
      vertices_.push_back({x, y, z, 1});
      for (int c = 0; c < 4; ++c) rows_.push_back(uniform(0.1f, 0.5f));
    }
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) indices_.push_back(first + i);
  }
  DrawCall call(BlendMode mode, BlendOrder order) const {
    DrawCall call;
    call.vertices = vertices_;
    call.indices = indices_;
    call.attributes = rows_;
    call.attribute_count = call.attribute_stride = 4;
    call.shade = shade_colour;
    call.blend = mode;
    call.order = order;
    call.depth_write = mode == BlendMode::kOpaque;
    return call;
  }

 private:
  std::mt19937 random_;
  std::vector<DeviceVertex> vertices_;
  std::vector<float> rows_;
  std::vector<std::uint32_t> indices_;
};

/// Draws until the benchmark has enough; reports fragments a second.
void run(benchmark::State& state, std::span<const DrawCall> calls) {
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget target(kWidth, kHeight, static_cast<int>(state.range(0)), ColourFormat::kLinear8);
  std::uint64_t fragments = 0;
  for (auto _ : state) fragments += rasterizer.draw(target, calls).fragments;
  state.counters["Mpix/s"] =
      benchmark::Counter(static_cast<double>(fragments) * 1e-6, benchmark::Counter::kIsRate);
}

/// 32 quads that fill the picture.
void layers(benchmark::State& state, BlendMode mode, BlendOrder order) {
  Rectangles quads(1);
  for (int i = 0; i < 32; ++i) {
    quads.add(0, 0, kWidth, kHeight, 0.95f - 0.02f * static_cast<float>(i));
  }
  const DrawCall call = quads.call(mode, order);
  run(state, {&call, 1});
}

/// 100,000 sprites of 2 to 14 pixels.
void sprites(benchmark::State& state, BlendMode mode, BlendOrder order) {
  Rectangles quads(2);
  for (int i = 0; i < 100000; ++i) {
    const float x = quads.uniform(0, kWidth), y = quads.uniform(0, kHeight);
    const float side = quads.uniform(2, 14);
    quads.add(x, y, x + side, y + side, quads.uniform(0, 1));
  }
  const DrawCall call = quads.call(mode, order);
  run(state, {&call, 1});
}

/// Glass teapots, seen through one another: about eight layers.
void teapots(benchmark::State& state) {
  Scene scene;
  Material glass;
  glass.base_colour = {0.3f, 0.6f, 0.7f};
  glass.specular = glm::vec3(0.5f);
  glass.opacity = 0.3f;
  glass.double_sided = true;
  scene.materials.push_back(glass);
  scene.meshes.push_back(teapot_mesh(16));
  scene.meshes[0].material = 0;
  for (int i = 0; i < 4; ++i) {
    Node node;
    node.parent_from_local[3] = {0.2f * static_cast<float>(i), 0, -2.0f * static_cast<float>(i), 1};
    node.meshes = {0};
    scene.nodes.push_back(node);
  }
  constexpr float kAspect = static_cast<float>(kWidth) / kHeight;
  const Camera camera = frame_scene(scene, kAspect);
  add_default_lights(scene, camera);
  Workers workers(2);
  Renderer renderer(workers);
  RenderTarget target(kWidth, kHeight, static_cast<int>(state.range(0)), ColourFormat::kLinear8);
  std::uint64_t fragments = 0;
  for (auto _ : state) {
    fragments += renderer.render(scene, camera, {}, target).raster.fragments;
  }
  state.counters["Mpix/s"] =
      benchmark::Counter(static_cast<double>(fragments) * 1e-6, benchmark::Counter::kIsRate);
}

#define KINESCOPE_BENCH_CASE(function, name, ...) \
  BENCHMARK_CAPTURE(function, name, __VA_ARGS__)  \
      ->Arg(1)                                    \
      ->Arg(4)                                    \
      ->UseRealTime()                             \
      ->Unit(benchmark::kMillisecond)

KINESCOPE_BENCH_CASE(layers, opaque, BlendMode::kOpaque, BlendOrder::kSubmitted);
KINESCOPE_BENCH_CASE(layers, additive, BlendMode::kAdditive, BlendOrder::kSubmitted);
KINESCOPE_BENCH_CASE(layers, alpha, BlendMode::kAlpha, BlendOrder::kSubmitted);
KINESCOPE_BENCH_CASE(layers, alpha_by_depth, BlendMode::kAlpha, BlendOrder::kByDepth);
KINESCOPE_BENCH_CASE(sprites, additive, BlendMode::kAdditive, BlendOrder::kSubmitted);
KINESCOPE_BENCH_CASE(sprites, alpha_by_depth, BlendMode::kAlpha, BlendOrder::kByDepth);
BENCHMARK(teapots)->Arg(1)->Arg(4)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kinescope::bench

BENCHMARK_MAIN();
