// What the lighting kernels read: points, structure of arrays, and a surface's lights made ready.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "shading/limits.h"
#include "shading/surface.h"

namespace kinescope {

/// Each array is aligned to 64 bytes and padded to whole vectors.
struct PointArrays {
  std::array<const float*, 3> position{};
  std::array<const float*, 3> normal{};  ///< of any length
  std::array<const float*, 3> colour{};  ///< null: white
  const float* facing = nullptr;         ///< as Batch::facing; null: by the eye
};

/// Attribute `first` of a batch and the two after it.
inline std::array<const float*, 3> three_arrays(const Batch& batch, int first) {
  const auto i = static_cast<std::size_t>(first);
  return {batch.attribute[i], batch.attribute[i + 1], batch.attribute[i + 2]};
}

/// The arrays of a batch whose rows are vertex rows.
inline PointArrays point_arrays(const Batch& batch, const Surface& surface) {
  PointArrays points;
  points.position = three_arrays(batch, vertex_row::kPosition);
  points.normal = three_arrays(batch, vertex_row::kNormal);
  if (surface.vertex_colours) points.colour = three_arrays(batch, vertex_row::kColour);
  points.facing = batch.facing;
  return points;
}

/// Constants of one batch.
struct HighlightConstants {
  explicit HighlightConstants(const Material& material)
      : none(material.specular == glm::vec3(0.0f)),
        exponent(std::fmax(material.shininess, 0.0f)),
        least_cosine(exponent > 0.0f ? std::exp2(kLeastHighlightLog2 / exponent) : 0.0f) {}

  bool none;
  float exponent;
  float least_cosine;  ///< smaller cosines give less than kLeastHighlightLog2
};

/// The lights of one batch. Those beyond the first few are made ready at each use.
class ReadyLights {
 public:
  explicit ReadyLights(std::span<const Light> lights) : lights_(lights) {
    for (std::size_t k = 0; k < ready_.size() && k < lights_.size(); ++k) {
      ready_[k].emplace(lights_[k]);
    }
  }

  /// Light k; the reference holds until the next call.
  const PreparedLight& at(std::size_t k) {
    if (k < ready_.size()) return *ready_[k];
    return spare_.emplace(lights_[k]);
  }

 private:
  std::span<const Light> lights_;
  std::array<std::optional<PreparedLight>, 16> ready_;
  std::optional<PreparedLight> spare_;
};

}  // namespace kinescope
