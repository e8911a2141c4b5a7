#include "engine/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace kinescope {
namespace {

using Vec = glm::dvec3;

bool usable(const Vec& v) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length);
}

/// An upward direction for a camera whose own is missing or lies along the line of sight: +y, or
/// where that will not do, what puts +x to the right.
Vec default_up(const Vec& forward) {
  return std::abs(forward.y) < 0.9 ? Vec(0, 1, 0) : Vec(0, 0, forward.y > 0 ? 1 : -1);
}

/// Unit vector to the right of the line of sight; any one if `up` does not say.
Vec right_of(const Vec& forward, const Vec& up) {
  if (usable(up)) {
    const Vec right = glm::cross(forward, glm::normalize(up));
    if (glm::length(right) > 1e-6) return glm::normalize(right);
  }
  return glm::normalize(glm::cross(forward, default_up(forward)));
}

struct DepthRange {
  double near, far;
};

/// Planes in order and, for perspective, in front of the eye.
DepthRange safe_depth_range(const Camera& camera) {
  double near = camera.near_plane;
  double far = camera.far_plane;
  if (!std::isfinite(near)) near = 0.1;
  if (camera.projection == Projection::kPerspective) near = std::max(near, 1e-30);
  if (!(far > near)) far = near + std::max(1.0, std::abs(near));
  return {near, far};
}

}  // namespace

void Camera::set_field_of_view(float fov_y_rad, float aspect) {
  const float half = view_distance * std::tan(fov_y_rad * 0.5f);
  window_min = {-half * aspect, -half};
  window_max = {half * aspect, half};
}

void Camera::set_aspect(float aspect) {
  const float centre = (window_min.x + window_max.x) * 0.5f;
  const float half = (window_max.y - window_min.y) * 0.5f * aspect;
  window_min.x = centre - half;
  window_max.x = centre + half;
}

glm::mat4 Camera::view_from_world() const {
  const Vec from(eye);
  Vec forward = Vec(look_at) - from;
  forward = usable(forward) ? glm::normalize(forward) : Vec(0, 0, -1);
  const Vec right = right_of(forward, Vec(up));
  const Vec top = glm::cross(right, forward);
  glm::dmat4 view(1.0);
  for (int i = 0; i < 3; ++i) {
    view[i] = {right[i], top[i], -forward[i], 0.0};
  }
  view[3] = {-glm::dot(right, from), -glm::dot(top, from), glm::dot(forward, from), 1.0};
  return glm::mat4(view);
}

glm::mat4 Camera::clip_from_view() const {
  const glm::dvec2 low(window_min), high(window_max);
  const glm::dvec2 size = high - low;
  const glm::dvec2 middle = (high + low) / size;
  const auto [near, far] = safe_depth_range(*this);
  // far / (far - near) tends to 1 as the far plane goes to infinity.
  const bool endless = !std::isfinite(far);
  glm::dmat4 clip(0.0);
  if (projection == Projection::kPerspective) {
    const double slope = endless ? 1.0 : far / (far - near);
    clip[0][0] = 2.0 * view_distance / size.x;
    clip[1][1] = 2.0 * view_distance / size.y;
    clip[2] = {middle.x, middle.y, -slope, -1.0};
    clip[3][2] = -slope * near;
  } else {
    const double depth = endless ? 1e30 : far - near;
    clip[0][0] = 2.0 / size.x;
    clip[1][1] = 2.0 / size.y;
    clip[2][2] = -1.0 / depth;
    clip[3] = {-middle.x, -middle.y, -near / depth, 1.0};
  }
  return glm::mat4(clip);
}

ViewportTransform device_from_ndc(const Viewport& viewport) {
  const glm::vec2 half(viewport.width * 0.5f, viewport.height * 0.5f);
  return {{half.x, -half.y}, {viewport.x + half.x, viewport.y + half.y}};
}

}  // namespace kinescope
