// Shaders on full batches: every illumination model, plain and textured. One core.
#include <glm/geometric.hpp>
#include <memory>
#include <random>

#include "bench/rates.h"
#include "bench/workload_kinds.h"
#include "shading/procedural_texture.h"

namespace kinescope::bench {
namespace {

/// A batch of one patch of a lit surface, sixteen pixels square, as the rasterizer hands it out.
struct FullBatch {
  explicit FullBatch(const Surface& surface) {
    std::mt19937 random(1);
    const auto uniform = [&random] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    for (std::size_t i = 0; i < kSize; ++i) {
      x[i] = static_cast<std::uint16_t>(i % 16);
      y[i] = static_cast<std::uint16_t>(i / 16);
      primitive[i] = static_cast<std::uint32_t>(i / 8);
      const glm::vec3 normal = glm::normalize(glm::vec3(uniform() - 0.5f, uniform() - 0.5f, 1.0f));
      for (std::size_t k = 0; k < 3; ++k) {
        attribute[vertex_row::kPosition + k][i] = uniform();
        attribute[vertex_row::kNormal + k][i] = normal[static_cast<int>(k)];
      }
      attribute[vertex_row::kTexcoord][i] = static_cast<float>(x[i]) * kTexelsAPixel / 1024;
      attribute[vertex_row::kTexcoord + 1][i] = static_cast<float>(y[i]) * kTexelsAPixel / 1024;
      gradient[0][i] = gradient[3][i] = kTexelsAPixel / 1024;
    }
    batch.size = kSize;
    batch.constants = &surface;
    batch.x = x.data();
    batch.y = y.data();
    batch.primitive = primitive.data();
    for (std::size_t k = 0; k < attribute.size(); ++k) batch.attribute[k] = attribute[k].data();
    batch.du_dx = gradient[0].data();
    batch.dv_dx = gradient[1].data();
    batch.du_dy = gradient[2].data();
    batch.dv_dy = gradient[3].data();
  }

  static constexpr std::size_t kSize = Batch::kMaxSize;
  static constexpr float kTexelsAPixel = 1.4f;  // between two levels of the pyramid
  template <typename T>
  using Column = std::array<T, kSize>;
  alignas(64) std::array<Column<float>, Batch::kMaxAttributes> attribute{};
  alignas(64) std::array<Column<float>, 4> gradient{};
  alignas(64) Column<std::uint32_t> primitive{};
  alignas(64) Column<std::uint16_t> x{};
  alignas(64) Column<std::uint16_t> y{};
  alignas(64) Column<LinearRgba> out{};
  Batch batch;
};

void shade_batch(benchmark::State& state, ShadingModel model, bool textured) {
  Scene scene;
  add_bench_lights(scene);
  const std::vector<Light> lights = world_lights(scene);
  const std::vector<LitColour> lit(FullBatch::kSize, {glm::vec3(0.5f), glm::vec3(0.1f)});
  const Texture texture(labelled_checkerboard(1024, 1024));
  Surface surface;
  surface.material = bench_material();
  surface.lights = lights;
  surface.triangle_light = lit;
  surface.eye = {0.0f, 0.0f, 3.0f};
  if (textured) surface.texture = &texture;
  const auto full = std::make_unique<FullBatch>(surface);
  const ShadeFunction shade = shade_function(model);
  for (auto _ : state) {
    shade(full->batch, full->out.data());
    benchmark::ClobberMemory();
  }
  count_rate(state, "pixels/s", Batch::kMaxSize);
}
BENCHMARK_CAPTURE(shade_batch, unlit, ShadingModel::kUnlit, false);
BENCHMARK_CAPTURE(shade_batch, flat, ShadingModel::kFlat, false);
BENCHMARK_CAPTURE(shade_batch, gouraud, ShadingModel::kGouraud, false);
BENCHMARK_CAPTURE(shade_batch, phong, ShadingModel::kPhong, false);
BENCHMARK_CAPTURE(shade_batch, blinn, ShadingModel::kBlinn, false);
BENCHMARK_CAPTURE(shade_batch, unlit_textured, ShadingModel::kUnlit, true);
BENCHMARK_CAPTURE(shade_batch, gouraud_textured, ShadingModel::kGouraud, true);
BENCHMARK_CAPTURE(shade_batch, phong_textured, ShadingModel::kPhong, true);

/// Gouraud's first half.
void light_rows(benchmark::State& state) {
  Scene scene;
  add_bench_lights(scene);
  const std::vector<Light> lights = world_lights(scene);
  Surface surface;
  surface.material = bench_material();
  surface.lights = lights;
  surface.eye = {0.0f, 0.0f, 3.0f};
  constexpr std::size_t kVertices = 4096;
  std::vector<float> rows(kVertices * vertex_row::kStride, 0.6f);
  std::vector<float> lit(kVertices * lit_row::kMaxSize);
  for (auto _ : state) {
    light_vertices(surface, rows, lit);
    benchmark::ClobberMemory();
  }
  count_rate(state, "vertices/s", kVertices);
}
BENCHMARK(light_rows);

}  // namespace
}  // namespace kinescope::bench

BENCHMARK_MAIN();
