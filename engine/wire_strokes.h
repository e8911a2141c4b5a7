// A scene as strokes: its edges as a camera sees them.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "engine/camera.h"
#include "engine/wire_scene.h"
#include "raster/base/workers.h"

namespace kinescope {

/// Ends in the view window, -1 to 1 each, y up.
struct WireStroke {
  glm::dvec2 from, to;
};

struct WireStyle {
  bool hidden_removed = false;  ///< only what no face lies before
  /// Edges where the surface bends less are left out, but for outlines: where it turns away from
  /// the eye. 0: every edge.
  float crease_rad = 0;
};

/// In the order of the scene's edges, whatever the number of workers.
std::vector<WireStroke> wire_strokes(const WireScene& scene, const Camera& camera,
                                     const WireStyle& style, Workers& workers);

}  // namespace kinescope
