#include "demos/model_view.h"

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <utility>

#include "demos/arrange.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr glm::vec3 kUp{0, 1, 0};

glm::vec3 up_of(const RenderOptions& options) {
  const glm::vec3 up = options.up.value_or(kUp);
  if (!(glm::length(up) > 0)) throw Error(ErrorKind::kUsage, "must not be 0,0,0", "--up");
  return up;
}

float radians_or(std::optional<double> degrees, double otherwise_deg) {
  return static_cast<float>(glm::radians(degrees.value_or(otherwise_deg)));
}

}  // namespace

ModelView::ModelView(Scene scene, const RenderOptions& options, double aspect, Workers& workers)
    : scene_(stand_up(std::move(scene), up_of(options))),
      bounds_(world_bounds(scene_)),
      camera_(first_camera(options, aspect)),
      own_lights_(scene_.lights.empty()),
      renderer_(workers) {
  settings_.shading = options.shading;
  settings_.wireframe = options.wireframe;
}

Camera ModelView::first_camera(const RenderOptions& options, double aspect) const {
  const glm::mat4 upright = upright_from_model(up_of(options));
  const auto place = [&](const glm::vec3& p) { return glm::vec3(upright * glm::vec4(p, 1)); };
  Camera camera =
      frame_scene(scene_, static_cast<float>(aspect), radians_or(options.azimuth_deg, 34),
                  radians_or(options.elevation_deg, 20), radians_or(options.fov_deg, 40));
  if (!options.eye && !options.look) return camera;
  const glm::vec3 look = options.look ? place(*options.look) : camera.look_at;
  camera.eye = options.eye ? place(*options.eye) : camera.eye + look - camera.look_at;
  camera.look_at = look;
  if (camera.eye == look) {
    throw Error(ErrorKind::kUsage, "the camera stands where it looks at", "--eye");
  }
  fit_depth(camera);
  return camera;
}

void ModelView::fit_depth(Camera& camera) const {
  const float distance = glm::length(camera.eye - bounds_.centre());
  const float radius = std::max(bounds_.radius() * 1.01f, 1e-6f);
  camera.far_plane = distance + radius;
  camera.near_plane = std::max(distance - radius, camera.far_plane * 1e-4f);
}

RenderStats ModelView::draw(double turn_rad, RenderTarget& target, bool want_visibility_hash) {
  Camera camera = camera_;
  if (turn_rad != 0) {
    const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), static_cast<float>(turn_rad), kUp);
    camera.eye = camera.look_at + glm::vec3(turn * glm::vec4(camera.eye - camera.look_at, 0));
    fit_depth(camera);
  }
  if (own_lights_) {
    scene_.lights.clear();
    add_default_lights(scene_, camera);
  }
  return renderer_.render(scene_, camera, settings_, target, want_visibility_hash);
}

}  // namespace kinescope
