// Storage for a batch of fragments made by hand, and a run over every instruction set.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "raster/base/simd.h"
#include "raster/batch.h"
#include "raster/image/image.h"
#include "shading/surface.h"

namespace kinescope {

/// A batch whose arrays a test fills. Unused lanes hold NaN, which must not disturb the others.
struct BatchArrays {
  BatchArrays();
  Batch batch(int size, const Surface& surface, bool gradients = true) const;

  void set_position(int i, glm::vec3 p) { set3(vertex_row::kPosition, i, p); }
  void set_normal(int i, glm::vec3 n) { set3(vertex_row::kNormal, i, n); }
  void set_colour(int i, glm::vec3 c) { set3(vertex_row::kColour, i, c); }
  void set3(int attribute, int i, glm::vec3 v);
  glm::vec3 get3(int attribute, int i) const;

  alignas(64) float attribute[Batch::kMaxAttributes][Batch::kMaxSize];
  alignas(64) float gradient[4][Batch::kMaxSize];  ///< du_dx, dv_dx, du_dy, dv_dy
  alignas(64) std::uint32_t primitive[Batch::kMaxSize];
  alignas(64) std::uint16_t x[Batch::kMaxSize];
  alignas(64) std::uint16_t y[Batch::kMaxSize];
};

/// The colours that `shade` gives. Fails the test if it writes past the last whole vector.
std::vector<LinearRgba> shaded(ShadingModel model, const Batch& batch);

/// Calls body(target) with each instruction set in use in turn, then goes back to the best.
template <class Body>
void on_every_target(const Body& body) {
  for (const std::string& target : simd_targets()) {
    use_simd_target(target);
    body(target);
  }
  use_simd_target("best");
}

/// Random numbers that are the same on every machine.
class Random {
 public:
  explicit Random(std::uint32_t seed) : bits_(seed) {}
  float uniform(float low, float high) {
    return low + (high - low) * static_cast<float>(bits_() >> 8) * 0x1p-24f;
  }
  int below(int n) { return static_cast<int>(bits_() % static_cast<std::uint32_t>(n)); }
  glm::vec3 in_cube(float low, float high);
  glm::vec3 direction();

 private:
  std::mt19937 bits_;
};

/// A picture of random bytes, alpha too.
template <class Pixel>
Image<Pixel> noise(Random& random, int width, int height) {
  Image<Pixel> picture(width, height);
  for (Pixel& p : picture.pixels()) {
    const auto byte = [&] { return static_cast<std::uint8_t>(random.below(256)); };
    p.r = byte(), p.g = byte(), p.b = byte(), p.a = byte();
  }
  return picture;
}

}  // namespace kinescope
