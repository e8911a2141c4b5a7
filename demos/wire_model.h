// A scene that turns before a camera, as strokes and as display files.
#pragma once

#include <span>
#include <vector>

#include "display/vector/display_memory.h"
#include "display/vector/machine.h"
#include "display/vector/segment.h"
#include "engine/framing.h"
#include "engine/wire_strokes.h"

namespace kinescope {

class WireModel {
 public:
  /// @param camera sees the scene from anywhere on its way around
  WireModel(const Scene& scene, const Camera& camera)
      : wire_(wire_scene(scene)), bounds_(world_bounds(scene)), camera_(camera) {}

  /// In the machine's units; the camera has walked around the scene by `turn_rad`.
  std::vector<VectorSegment> strokes(double turn_rad, const WireStyle& style,
                                     const VectorMachine& machine, Workers& workers) const;

 private:
  WireScene wire_;
  Bounds bounds_;
  Camera camera_;
};

/// Strokes of a view window's whole width and height as those of the machine's points.
std::vector<VectorSegment> machine_strokes(std::span<const WireStroke> strokes,
                                           const VectorMachine& machine);

}  // namespace kinescope
