#include "display/layer_colours.h"

#include <algorithm>
#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace kinescope {
namespace {

glm::dvec3 vector_of(LinearRgb c) { return {c.r, c.g, c.b}; }

}  // namespace

std::array<std::array<float, 3>, 3> layer_colours(const PhosphorType& type) {
  std::array<glm::dvec3, 3> colour{};
  glm::dvec3 mixture(0);
  for (std::size_t i = 0; i < type.layers.size(); ++i) {
    mixture += colour[i] = type.layers[i].share * vector_of(type.layers[i].colour);
  }
  if (type.colour) {
    const glm::dmat3 rgb_from_guns(colour[0], colour[1], colour[2]);
    const glm::dvec3 luminance = glm::inverse(rgb_from_guns) * glm::dvec3(1, 1, 1);
    for (int i = 0; i < 3; ++i) colour[static_cast<std::size_t>(i)] *= luminance[i];
  } else {
    for (glm::dvec3& c : colour) c /= std::max({mixture.x, mixture.y, mixture.z});
  }
  std::array<std::array<float, 3>, 3> colours{};
  for (std::size_t i = 0; i < 3; ++i) {
    colours[i] = {static_cast<float>(colour[i].x), static_cast<float>(colour[i].y),
                  static_cast<float>(colour[i].z)};
  }
  return colours;
}

}  // namespace kinescope
