#include "engine/projection/oblique.h"

#include <cmath>
#include <numbers>

#include "engine/transform/exact_angle.h"
#include "engine/transform/transform3d.h"

namespace kinescope {

glm::dmat4 picture_from_world(const Oblique& view) {
  const auto [s, c] = sine_cosine_deg(view.receding_deg);
  ShearFactors factors;
  factors.b = -view.depth_scale * c;
  factors.d = -view.depth_scale * s;
  return shear(factors);
}

double projector_angle_deg(const Oblique& view) {
  return std::atan2(1.0, std::abs(view.depth_scale)) * (180.0 / std::numbers::pi);
}

}  // namespace kinescope
