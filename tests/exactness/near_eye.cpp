#include "tests/exactness/near_eye.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "engine/cut_triangles.h"
#include "raster/sample_pattern.h"
#include "tests/exactness/coverage_oracle.h"
#include "tests/raster/triangle_soup.h"

namespace kinescope::exactness {
namespace {

constexpr int kWidth = 32, kHeight = 24;
constexpr float kNear = 1e-6f;
/// Snapping and rounding at the edge of the guard band move an edge by less than this.
constexpr double kReachPx = 1.0 / 32;

/// Clip space is (x, y, z - near, z): w is the vertex's own z.
glm::mat4 clip_from_world() {
  glm::mat4 m(1.0f);
  m[3][2] = -kNear;
  m[2][3] = 1.0f;
  m[3][3] = 0.0f;
  return m;
}

glm::vec3 random_vertex(RandomTriangles& random) {
  const float magnitude = std::pow(10.0f, random.between(-6.5f, 2.0f));
  const float z = random.below(4) == 0 ? -magnitude : magnitude;
  // In sight or a little aside, far aside, or anywhere.
  const float x = random.between(-1, 1), y = random.between(-1, 1);
  const int place = random.below(3);
  const float reach = place == 0 ? 1.2f * magnitude : place == 1 ? 8.0f * magnitude : 1.0f;
  return {x * reach, y * reach, z};
}

/// Where rays through samples meet a triangle, without any division by w.
class HomogeneousTriangle {
 public:
  explicit HomogeneousTriangle(const std::array<glm::dvec3, 3>& v) {  // (x, y, w)
    const double volume = glm::dot(v[0], glm::cross(v[1], v[2]));
    edge_on_ = std::abs(volume) < 1e-9 * glm::length(v[0]) * glm::length(v[1]) * glm::length(v[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      plane_[i] = glm::cross(v[(i + 1) % 3], v[(i + 2) % 3]) / volume;
      plane_[3] += plane_[i] * (v[i].z - double{kNear});  // depth where w is 1
    }
  }

  enum class Answer { kCovered, kNot, kTooClose };
  Answer at(double x_px, double y_px) const {
    if (edge_on_) return Answer::kTooClose;
    const glm::dvec3 ray(x_px * 2 / kWidth - 1, 1 - y_px * 2 / kHeight, 1);
    bool covered = true;
    for (const glm::dvec3& e : plane_) {
      const double value = glm::dot(e, ray);
      const double slope_px = std::hypot(e.x * 2 / kWidth, e.y * 2 / kHeight);
      if (!(std::abs(value) > kReachPx * slope_px + 1e-6 * glm::length(e)))
        return Answer::kTooClose;
      covered &= value > 0;
    }
    return covered ? Answer::kCovered : Answer::kNot;
  }

 private:
  std::array<glm::dvec3, 4> plane_{};  ///< positive inside: three edges, and depth
  bool edge_on_;
};

/// The stages before the rasterizer, on triangles that share no vertex.
struct Pipeline {
  Pipeline(int count, unsigned seed) {
    RandomTriangles random(seed);
    const auto vertices = static_cast<std::size_t>(count) * 3;
    world.resize(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
      const glm::vec3 p = random_vertex(random);
      world.x[i] = p.x, world.y[i] = p.y, world.z[i] = p.z;
      indices.push_back(static_cast<std::uint32_t>(i));
    }
    constexpr float kGuardBand = DeviceVertex::kGuardBand;
    const Projector projector =
        make_projector(clip_from_world(), {0, 0, kWidth, kHeight}, kGuardBand);
    device.resize(vertices + Positions::kPadding);
    project(projector, world, 0, vertices, device);
    Workers workers(1);
    std::vector<float> rows(vertices);
    cut.cut(workers, projector, kGuardBand, world, indices, device, rows, 1, 0);
    for (DeviceVertex& v : device.vertices) v.z = Comparer::kDepth;
  }
  /// Triangles [begin, end) of what is left.
  DrawCall call(std::size_t begin, std::size_t end) const {
    DrawCall c;
    c.vertices = device.vertices;
    c.indices = cut.indices().subspan(3 * begin, 3 * (end - begin));
    c.cull = CullMode::kNone;
    return c;
  }
  HomogeneousTriangle homogeneous(std::size_t triangle) const {
    std::array<glm::dvec3, 3> v;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t at = 3 * triangle + i;
      v[i] = {world.x[at], world.y[at], world.z[at]};
    }
    return HomogeneousTriangle(v);
  }

  Positions world;
  std::vector<std::uint32_t> indices;
  DevicePositions device;
  CutTriangles cut;
};

std::vector<CoverageOracle> oracles_of(const DrawCall& call) {
  std::vector<CoverageOracle> out;
  for (std::size_t i = 0; i < call.indices.size(); i += 3) {
    std::array<Point, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = call.indices[i + k];
      corners[k] = snapped(call.vertices[v].x_px, call.vertices[v].y_px);
    }
    out.emplace_back(corners);
  }
  return out;
}

void compare_samples(const HomogeneousTriangle& whole, const DrawCall& left, int samples,
                     NearEyeTally& tally) {
  const std::vector<CoverageOracle> parts = oracles_of(left);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const SampleOffset& o : sample_pattern(samples)) {
        const auto answer = whole.at(x + double{o.x.to_float()}, y + double{o.y.to_float()});
        if (answer == HomogeneousTriangle::Answer::kTooClose) continue;
        const Point p = sample_point(x, y, o);
        const auto times = std::count_if(
            parts.begin(), parts.end(), [&](const CoverageOracle& part) { return part.covers(p); });
        const bool covered = answer == HomogeneousTriangle::Answer::kCovered;
        ++tally.samples;
        tally.covered += covered;
        tally.samples_differing += times != (covered ? 1 : 0);
      }
    }
  }
}

}  // namespace

NearEyeTally compare_near_eye(Comparer& comparer, int count, unsigned seed, int samples) {
  const Pipeline pipeline(count, seed);
  const std::span<const std::uint32_t> source = pipeline.cut.source_triangle();
  NearEyeTally tally;
  std::size_t begin = 0;
  for (std::size_t triangle = 0; triangle < static_cast<std::size_t>(count); ++triangle) {
    std::size_t end = begin;
    while (end < source.size() && source[end] == triangle) ++end;
    const DrawCall call = pipeline.call(begin, end);
    tally.device += comparer.compare(call, kWidth, kHeight, samples);
    compare_samples(pipeline.homogeneous(triangle), call, samples, tally);
    begin = end;
  }
  return tally;
}

}  // namespace kinescope::exactness
