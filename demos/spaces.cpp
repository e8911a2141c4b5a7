#include "demos/spaces.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "demos/orbit.h"
#include "demos/ui/theme.h"

namespace kinescope {

Mesh mapped(const Mesh& mesh, const glm::mat4& m) {
  Mesh out = mesh;
  const glm::mat4 plane_map = glm::transpose(glm::inverse(m));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 p = mesh.positions[i], n = mesh.normals[i];
    const glm::vec4 q = m * glm::vec4(p, 1);
    out.positions[i] = glm::vec3(q) / std::max(q.w, 1e-3f);
    out.normals[i] = glm::normalize(glm::vec3(plane_map * glm::vec4(n, -glm::dot(n, p))));
  }
  return out;
}

void colour_by_volume(Mesh& mesh, const glm::mat4& clip_from_mesh) {
  mesh.colours.resize(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec4 q = clip_from_mesh * glm::vec4(mesh.positions[i], 1);
    const bool inside = std::abs(q.x) <= q.w && std::abs(q.y) <= q.w && q.z >= 0 && q.z <= q.w;
    mesh.colours[i] = inside ? glm::vec3(0.62f, 0.21f, 0.075f) : glm::vec3(0.16f, 0.2f, 0.3f);
  }
}

std::array<glm::vec3, 8> mapped_volume(const glm::mat4& space_from_clip) {
  std::array<glm::vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::vec4 q =
        space_from_clip * glm::vec4((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : 0, 1);
    corners[i] = glm::vec3(q) / q.w;
  }
  return corners;
}

glm::mat4 logical_from_clip() {
  const glm::mat4 halved = glm::translate(glm::mat4(1), glm::vec3(0.5f, 0.5f, 0));
  return glm::scale(halved, glm::vec3(0.5f, 0.5f, -0.02f));
}

void draw_view_volume(SpaceView& pane, const Camera& camera, const glm::mat4& space_from_world,
                      bool with_eye) {
  const auto corners = mapped_volume(space_from_world * glm::inverse(camera.clip_from_world()));
  pane.box(corners, 1.4f, theme::with_alpha(theme::kCool, 200));
  pane.label(corners[1] * 1.02f, "near", theme::kCool);
  pane.label(corners[7] * 1.02f, "far", theme::kCool);
  if (!with_eye) return;
  const glm::vec4 q = space_from_world * glm::vec4(camera.eye, 1);
  const glm::vec3 eye = glm::vec3(q) / q.w;
  for (std::size_t i = 0; i < 4; ++i) {
    pane.line(eye, corners[i], 1, theme::with_alpha(theme::kCool, 110));
  }
  pane.label(eye + glm::vec3(0, 0.35f, 0), "eye", theme::kText);
}

Camera observer(glm::vec3 centre, float distance, float azimuth_rad, float elevation_rad) {
  Orbit orbit;
  orbit.distance = distance;
  orbit.azimuth_rad = azimuth_rad;
  orbit.elevation_rad = elevation_rad;
  Camera camera;
  orbit.aim(camera, centre);
  camera.set_field_of_view(0.6f, 1);
  return camera;
}

}  // namespace kinescope
