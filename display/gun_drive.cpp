#include "display/gun_drive.h"

#include <algorithm>
#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace kinescope {
namespace {

glm::dvec3 vector_of(LinearRgb c) { return {c.r, c.g, c.b}; }

}  // namespace

std::vector<const Phosphor*> faceplate_phosphors(const std::string& name) {
  if (name != "P22") return {&find_phosphor(name)};
  return {&find_phosphor("P22R"), &find_phosphor("P22G"), &find_phosphor("P22B")};
}

std::array<std::array<float, 3>, 3> layer_colours(std::span<const Phosphor* const> layers) {
  std::array<std::array<float, 3>, 3> colours{};
  const auto set = [&](std::size_t layer, glm::dvec3 c) {
    colours[layer] = {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)};
  };
  if (layers.size() == 1) {
    const glm::dvec3 hue = vector_of(layers[0]->colour);
    set(0, hue / std::max({hue.x, hue.y, hue.z}));
    return colours;
  }
  const glm::dmat3 rgb_from_guns(vector_of(layers[0]->colour), vector_of(layers[1]->colour),
                                 vector_of(layers[2]->colour));
  const glm::dvec3 luminance = glm::inverse(rgb_from_guns) * glm::dvec3(1, 1, 1);
  for (int i = 0; i < 3; ++i) set(static_cast<std::size_t>(i), rgb_from_guns[i] * luminance[i]);
  return colours;
}

GunCurve::GunCurve(double gamma) {
  for (std::size_t i = 0; i < 256; ++i) {
    light_[i] = static_cast<float>(std::pow(static_cast<double>(i) / 255, gamma));
  }
}

void GunCurve::colour_doses(std::span<const GunDrive> drives, int layer, float* doses) const {
  const auto fill = [&](std::uint8_t GunDrive::*gun) {
    for (const GunDrive& drive : drives) *doses++ = light_[drive.*gun];
  };
  fill(layer == 0 ? &GunDrive::r : layer == 1 ? &GunDrive::g : &GunDrive::b);
}

void GunCurve::grey_doses(std::span<const GunDrive> drives, float* doses) const {
  for (const GunDrive& d : drives) {
    *doses++ = light_[static_cast<std::size_t>((77 * d.r + 150 * d.g + 29 * d.b + 128) >> 8)];
  }
}

}  // namespace kinescope
