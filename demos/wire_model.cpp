#include "demos/wire_model.h"

#include <glm/vec2.hpp>

#include "demos/model_view.h"

namespace kinescope {

std::vector<VectorSegment> WireModel::strokes(double turn_rad, const WireStyle& style,
                                              const VectorMachine& machine,
                                              Workers& workers) const {
  Camera camera = camera_;
  if (turn_rad != 0) walk_around(camera, turn_rad, bounds_);
  return machine_strokes(wire_strokes(wire_, camera, style, workers), machine);
}

std::vector<VectorSegment> machine_strokes(std::span<const WireStroke> strokes,
                                           const VectorMachine& machine) {
  const glm::dvec2 half{0.5 * (machine.width - 1), 0.5 * (machine.height - 1)};
  std::vector<VectorSegment> out;
  out.reserve(strokes.size());
  for (const WireStroke& stroke : strokes) {
    const glm::vec2 a(half + half * stroke.from), b(half + half * stroke.to);
    out.push_back({a.x, a.y, b.x, b.y});
  }
  return out;
}

}  // namespace kinescope
