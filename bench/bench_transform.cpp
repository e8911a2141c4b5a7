// Vertices: from local to world space, and through clip space to pixels. One core.
#include <numbers>
#include <random>

#include "bench/rates.h"
#include "engine/vertex_transform.h"
#include "shading/surface.h"

namespace kinescope::bench {
namespace {

std::vector<glm::vec3> random_points(std::size_t count) {
  std::mt19937 random(1);
  const auto uniform = [&random] { return static_cast<float>(random() >> 8) * 0x1p-23f - 1.0f; };
  std::vector<glm::vec3> points(count);
  for (glm::vec3& p : points) p = {uniform(), uniform(), uniform()};
  return points;
}

void project_vertices(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  Positions world;
  world.resize(count);
  const std::vector<glm::vec3> points = random_points(count);
  for (std::size_t i = 0; i < count; ++i) {
    world.x[i] = points[i].x, world.y[i] = points[i].y, world.z[i] = points[i].z;
  }
  Camera camera;
  camera.set_field_of_view(std::numbers::pi_v<float> / 4, 16.0f / 9.0f);
  const Projector projector = make_projector(camera.clip_from_world(), {0, 0, 1920, 1080}, 32768);
  DevicePositions device;
  device.resize(count + Positions::kPadding);
  for (auto _ : state) {
    benchmark::DoNotOptimize(project(projector, world, 0, count, device));
    benchmark::ClobberMemory();
  }
  count_rate(state, "vertices/s", static_cast<double>(count));
}
BENCHMARK(project_vertices)->Arg(4096)->Arg(1 << 20);

void move_vertices_to_world(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<glm::vec3> points = random_points(count);
  const WorldTransform transform = make_world_transform(glm::mat4(2.0f));
  Positions world;
  world.resize(count);
  std::vector<float> rows(count * vertex_row::kStride);
  for (auto _ : state) {
    to_world(transform, points, points, 0, count, world, rows, vertex_row::kStride);
    benchmark::ClobberMemory();
  }
  count_rate(state, "vertices/s", static_cast<double>(count));
}
BENCHMARK(move_vertices_to_world)->Arg(4096)->Arg(1 << 20);

}  // namespace
}  // namespace kinescope::bench

BENCHMARK_MAIN();
