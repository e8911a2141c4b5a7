// A mesh and a view volume carried from one coordinate space to another, and somebody to look.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "demos/space_view.h"
#include "engine/camera.h"
#include "engine/scene.h"

namespace kinescope {

/// A projective image of a mesh: points divided by w, normals as the planes they stand for.
Mesh mapped(const Mesh& mesh, const glm::mat4& m);

/// Vertex colours: copper inside the view volume, slate outside it.
void colour_by_volume(Mesh& mesh, const glm::mat4& clip_from_mesh);

/// Corners of the view volume: corner i at x = i & 1, y = i & 2, z = i & 4.
std::array<glm::vec3, 8> mapped_volume(const glm::mat4& space_from_clip);

/// To the logical screen from (0, 0) to (1, 1): flat, but for as much depth as hides what lies
/// behind.
glm::mat4 logical_from_clip();

/// A camera's view volume in some space, and lines to its eye if it lies in that space.
void draw_view_volume(SpaceView& pane, const Camera& camera, const glm::mat4& space_from_world,
                      bool with_eye);

/// A camera that looks at `centre` from a distance and two angles.
Camera observer(glm::vec3 centre, float distance, float azimuth_rad, float elevation_rad);

}  // namespace kinescope
