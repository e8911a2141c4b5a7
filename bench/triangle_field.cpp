#include "bench/triangle_field.h"

#include <random>

namespace kinescope::bench {

TriangleField::TriangleField(int count, float leg_px, int width, int height) {
  std::mt19937 random(1);
  const auto uniform = [&random] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
  const auto add = [this](float x, float y, float z) {
    indices_.push_back(static_cast<std::uint32_t>(vertices_.size()));
    vertices_.push_back({x, y, z, 1.0f});
  };
  for (int i = 0; i < count; ++i) {
    const float x = uniform() * (static_cast<float>(width) - leg_px);
    const float y = uniform() * (static_cast<float>(height) - leg_px);
    const float z = uniform() * 0.9f;
    // Counter-clockwise as seen; half of them with the right angle at the other corner.
    if (random() & 1) {
      add(x, y, z);
      add(x, y + leg_px, z + 0.1f * uniform());
      add(x + leg_px, y, z + 0.1f * uniform());
    } else {
      add(x + leg_px, y + leg_px, z);
      add(x + leg_px, y, z + 0.1f * uniform());
      add(x, y + leg_px, z + 0.1f * uniform());
    }
  }
}

DrawCall TriangleField::call() const {
  DrawCall call;
  call.vertices = vertices_;
  call.indices = indices_;
  return call;
}

}  // namespace kinescope::bench
