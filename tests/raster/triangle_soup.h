// Triangles for the rasterizer's tests: by hand, or random of many shapes.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "raster/draw_call.h"

namespace kinescope {

struct TestVertex {
  float x = 0, y = 0, z = 0.5f, inv_w = 1;
};

/// Owns the arrays that a DrawCall looks at. Vertices are not shared.
class TriangleSoup {
 public:
  void add(const TestVertex& a, const TestVertex& b, const TestVertex& c) {
    for (const TestVertex& v : {a, b, c}) {
      indices_.push_back(static_cast<std::uint32_t>(vertices_.size()));
      vertices_.push_back({v.x, v.y, v.z, v.inv_w});
    }
  }
  std::size_t size() const { return indices_.size() / 3; }
  TestVertex vertex(std::size_t i) const {
    const DeviceVertex& v = vertices_[i];
    return {v.x_px, v.y_px, v.z, v.inv_w};
  }

  DrawCall call(ShadeFunction shade, CullMode cull = CullMode::kNone) const {
    DrawCall draw;
    draw.vertices = vertices_;
    draw.indices = indices_;
    draw.cull = cull;
    draw.shade = shade;
    return draw;
  }

 private:
  std::vector<DeviceVertex> vertices_;
  std::vector<std::uint32_t> indices_;
};

/// Writes the triangle's number into red: exact in a float target up to 2^24.
inline void shade_primitive(const Batch& batch, LinearRgba* out) {
  for (int i = 0; i < batch.size; ++i) {
    out[i] = {static_cast<float>(batch.primitive[i]), 0, 0, 1};
  }
}

/// Random triangles around a box: every size class, slivers, points on pixel centres, flat ones.
class RandomTriangles {
 public:
  explicit RandomTriangles(unsigned seed) : random_(seed) {}

  float between(float lo, float hi) {
    return lo + (hi - lo) * static_cast<float>(random_() >> 8) * 0x1p-24f;
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  /// A vertex within `reach` of (x, y): anywhere, on a pixel's centre or corner, or in sixteenths.
  TestVertex vertex(float x, float y, float reach) {
    TestVertex v{x + between(-reach, reach), y + between(-reach, reach), between(0, 1),
                 between(0.1f, 2)};
    const float grid = std::array{0.0f, 1.0f, 2.0f, 16.0f}[static_cast<std::size_t>(below(4))];
    if (grid > 0) {
      v.x = std::floor(v.x * grid) / grid + (grid == 1.0f ? 0.5f : 0.0f);
      v.y = std::floor(v.y * grid) / grid + (grid == 1.0f ? 0.5f : 0.0f);
    }
    return v;
  }

  /// Three vertices within `reach` of (x, y); some slivers, some flat, some with depths that tie.
  std::array<TestVertex, 3> triangle(float x, float y, float reach) {
    std::array<TestVertex, 3> t = {vertex(x, y, reach), vertex(x, y, reach), vertex(x, y, reach)};
    const int shape = below(10);
    if (shape == 0) {  // a sliver
      t[2].x = (t[0].x + t[1].x) * 0.5f + between(-0.02f, 0.02f);
      t[2].y = (t[0].y + t[1].y) * 0.5f + between(-0.02f, 0.02f);
    }
    if (shape == 1) t[1].y = t[0].y;
    if (shape == 2) t[1].x = t[0].x;
    if (shape == 3) t[2] = t[below(2) == 0 ? 0 : 1];
    if (shape == 4) t[0].z = t[1].z = t[2].z = 0.5f;
    if (shape == 5) t[0].z = t[1].z = t[2].z = below(2) == 0 ? 0.0f : 1.0f;
    return t;
  }

  /// Triangles of all sizes over a target, some reaching far outside it.
  TriangleSoup soup(int count, int width, int height) {
    TriangleSoup out;
    for (int i = 0; i < count; ++i) {
      const float reach =
          std::array{
              0.7f, 2.0f, 6.0f, 12.0f, 40.0f, 100.0f, 1000.0f, 30000.0f}[static_cast<std::size_t>(
              below(8) * below(8) / 7)];
      const float x = between(-5, static_cast<float>(width) + 5);
      const float y = between(-5, static_cast<float>(height) + 5);
      const auto t = triangle(x, y, reach);
      out.add(t[0], t[1], t[2]);
    }
    return out;
  }

 private:
  std::mt19937 random_;
};

}  // namespace kinescope
