// Vertices from local to world space, and from world space through clip space to the device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/camera.h"
#include "raster/device_vertex.h"

namespace kinescope {

/// Positions as structure of arrays, padded with zeros so that whole vectors may be read.
struct Positions {
  static constexpr std::size_t kPadding = 16;
  std::vector<float> x, y, z;
  std::size_t count = 0;
  void resize(std::size_t n);
};

/// Which planes a vertex of clip space lies outside of; a vertex of code 0 needs no clipping.
namespace outcode {
inline constexpr std::uint8_t kLeft = 1, kRight = 2, kBottom = 4, kTop = 8, kNear = 16, kFar = 32;
/// Outside the guard band, or not in front of the eye: the device cannot hold it.
inline constexpr std::uint8_t kGuard = 64;
inline constexpr std::uint8_t kNotFinite = 128;
/// The six planes of the view volume; triangles whose corners share one of these are not seen.
inline constexpr std::uint8_t kVolume = 63;
/// A triangle with one of these on a corner must be cut (or dropped, if not finite).
inline constexpr std::uint8_t kMustCut = kNear | kFar | kGuard | kNotFinite;
}  // namespace outcode

/// The least w that is projected; what lies closer to the eye's plane is cut off.
inline constexpr float kLeastW = 1e-30f;

/// What device coordinates are made of: a vertex of clip space stays uncut while
/// guard_min * w <= x, y <= guard_max * w.
struct Projector {
  glm::mat4 clip_from_world{1.0f};
  ViewportTransform device_from_ndc{};
  glm::vec2 guard_min{-1.0f};
  glm::vec2 guard_max{1.0f};
};
/// @param guard_band_px  device coordinates are kept within [-guard_band_px, guard_band_px], less
///                       a pixel for rounding; the band always holds the viewport
Projector make_projector(const glm::mat4& clip_from_world, const Viewport& viewport,
                         float guard_band_px);

/// Projected vertices, in the layout that the rasterizer takes, with their outcodes.
struct DevicePositions {
  std::vector<DeviceVertex> vertices;
  std::vector<std::uint8_t> outcodes;
  void resize(std::size_t n);
};

/// Which outcodes occur among vertices: on any of them, and on all.
struct OutcodeSummary {
  std::uint8_t any = 0;
  std::uint8_t all = 255;
};

/// Projects positions [begin, end); begin is a multiple of Positions::kPadding. Where an outcode
/// has a bit of kMustCut, the coordinates are 0 and inv_w is 1. `out` holds a whole vector more.
OutcodeSummary project(const Projector& projector, const Positions& world, std::size_t begin,
                       std::size_t end, DevicePositions& out);

/// A node's transform, as positions and as normals take it: their matrix is the cofactor matrix,
/// which is the inverse transpose but for a positive factor, and exists for flat scalings too.
struct WorldTransform {
  glm::mat4 world_from_local{1.0f};
  glm::mat3 normal_matrix{1.0f};
  bool mirrors = false;  ///< determinant below 0: the winding of triangles turns round
};
WorldTransform make_world_transform(const glm::mat4& world_from_local);

/// Moves vertices [begin, end) to world space: into `positions`, and as position and unit normal
/// into rows `stride` floats apart. begin is a multiple of Positions::kPadding.
void to_world(const WorldTransform& transform, std::span<const glm::vec3> local_positions,
              std::span<const glm::vec3> local_normals, std::size_t begin, std::size_t end,
              Positions& positions, std::span<float> rows, int stride);

}  // namespace kinescope
