#include "tests/shading/batch_arrays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace kinescope {

BatchArrays::BatchArrays() {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (auto& array : attribute) std::fill(std::begin(array), std::end(array), kNan);
  for (auto& array : gradient) std::fill(std::begin(array), std::end(array), kNan);
  std::fill(std::begin(primitive), std::end(primitive), 0xFFFFFFFFu);
  std::fill(std::begin(x), std::end(x), 0);
  std::fill(std::begin(y), std::end(y), 0);
}

Batch BatchArrays::batch(int size, const Surface& surface, bool gradients) const {
  Batch batch;
  batch.size = size;
  batch.constants = &surface;
  batch.x = x;
  batch.y = y;
  batch.primitive = primitive;
  for (std::size_t k = 0; k < batch.attribute.size(); ++k) batch.attribute[k] = attribute[k];
  if (gradients) {
    batch.du_dx = gradient[0];
    batch.dv_dx = gradient[1];
    batch.du_dy = gradient[2];
    batch.dv_dy = gradient[3];
  }
  return batch;
}

void BatchArrays::set3(int first, int i, glm::vec3 v) {
  for (int k = 0; k < 3; ++k) attribute[first + k][i] = v[k];
}

glm::vec3 BatchArrays::get3(int first, int i) const {
  return {attribute[first][i], attribute[first + 1][i], attribute[first + 2][i]};
}

std::vector<LinearRgba> shaded(ShadingModel model, const Batch& batch) {
  constexpr LinearRgba kMark{-7, -7, -7, -7};
  constexpr int kRoom = Batch::kMaxSize, kGuard = 16;
  std::vector<LinearRgba> out(kRoom + kGuard, kMark);
  shade_function(model)(batch, out.data());
  EXPECT_TRUE(std::all_of(out.begin() + kRoom, out.end(), [&](const LinearRgba& c) {
    return c == kMark;
  })) << "a shader wrote past the batch";
  out.resize(static_cast<std::size_t>(batch.size));
  return out;
}

glm::vec3 Random::in_cube(float low, float high) {
  const float x_part = uniform(low, high), y_part = uniform(low, high);
  return {x_part, y_part, uniform(low, high)};
}

glm::vec3 Random::direction() {
  while (true) {
    const glm::vec3 v = in_cube(-1.0f, 1.0f);
    const float squared = glm::dot(v, v);
    if (squared > 0.01f && squared <= 1.0f) return v / glm::sqrt(squared);
  }
}

}  // namespace kinescope
