// The control points of the Utah teapot, as Martin Newell published them (public data): z up,
// lengths as in the original, spout towards +x. Stored by symmetry.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace kinescope::teapot_data {

/// Four control points of a quarter of a ring about the z axis, from +x to -y:
/// (radius, 0), (radius, -bulge), (bulge, -radius), (0, -radius). The bulge is 0.56 radius, and so
/// the ring nearly a circle, but for one ring of the lid.
struct Ring {
  double radius, bulge, height;
};
/// Rows of a patch from the top down; the quarter is mirrored in x, in y and in both.
using RingPatch = std::array<Ring, 4>;
/// Control points of half a tube, y <= 0; the half is mirrored in y.
using HalfTubePatch = std::array<std::array<glm::dvec3, 4>, 4>;

extern const std::array<RingPatch, 4> kShell;  ///< rim, body above, body below, bottom
extern const std::array<RingPatch, 2> kLid;    ///< knob, cover
extern const std::array<HalfTubePatch, 2> kHandle;
extern const std::array<HalfTubePatch, 2> kSpout;

}  // namespace kinescope::teapot_data
