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

RenderSettings render_settings(const RenderOptions& options) {
  RenderSettings settings;
  settings.shading = options.shading;
  settings.wireframe = options.wireframe;
  return settings;
}

}  // namespace

void fit_depth(Camera& camera, const Bounds& bounds) {
  const float distance = glm::length(camera.eye - bounds.centre());
  const float radius = std::max(bounds.radius() * 1.01f, 1e-6f);
  camera.far_plane = distance + radius;
  camera.near_plane = std::max(distance - radius, camera.far_plane * 1e-4f);
}

void walk_around(Camera& camera, double turn_rad, const Bounds& bounds) {
  const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), static_cast<float>(turn_rad), kUp);
  camera.eye = camera.look_at + glm::vec3(turn * glm::vec4(camera.eye - camera.look_at, 0));
  fit_depth(camera, bounds);
}

Scene upright_scene(Scene scene, const RenderOptions& options) {
  return stand_up(std::move(scene), up_of(options));
}

Camera model_camera(const Scene& upright, const RenderOptions& options, double aspect, bool turns) {
  const glm::mat4 rotation = upright_from_model(up_of(options));
  const auto place = [&](const glm::vec3& p) { return glm::vec3(rotation * glm::vec4(p, 1)); };
  Camera camera = (turns ? frame_turntable : frame_scene)(
      upright, static_cast<float>(aspect), radians_or(options.azimuth_deg, 34),
      radians_or(options.elevation_deg, 20), radians_or(options.fov_deg, 40));
  if (!options.eye && !options.look) return camera;
  const glm::vec3 look = options.look ? place(*options.look) : camera.look_at;
  camera.eye = options.eye ? place(*options.eye) : camera.eye + look - camera.look_at;
  camera.look_at = look;
  if (camera.eye == look) {
    throw Error(ErrorKind::kUsage, "the camera stands where it looks at", "--eye");
  }
  fit_depth(camera, world_bounds(upright));
  return camera;
}

ModelView::ModelView(Scene scene, const RenderOptions& options, double aspect, bool turns,
                     Workers& workers)
    : scene_(upright_scene(std::move(scene), options)),
      bounds_(world_bounds(scene_)),
      camera_(model_camera(scene_, options, aspect, turns)),
      settings_(render_settings(options)),
      own_lights_(scene_.lights.empty()),
      renderer_(workers) {}

RenderStats ModelView::draw(double turn_rad, RenderTarget& target, bool want_visibility_hash) {
  Camera camera = camera_;
  if (turn_rad != 0) walk_around(camera, turn_rad, bounds_);
  if (own_lights_) {
    scene_.lights.clear();
    add_default_lights(scene_, camera);
  }
  return renderer_.render(scene_, camera, settings_, target, want_visibility_hash);
}

}  // namespace kinescope
