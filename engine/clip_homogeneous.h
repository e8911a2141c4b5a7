// Polygons cut by planes in homogeneous coordinates, before the division by w.
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "raster/batch.h"

namespace kinescope {

/// A corner in clip space with the values that vary linearly over the polygon. Double precision:
/// w may be a millionth at one end of an edge and a million at the other.
struct ClipVertex {
  glm::dvec4 position{0.0};
  std::array<float, Batch::kMaxAttributes> attributes{};
  int corner = -1;  ///< the caller's number for it; -1 for corners that clipping makes
};

/// Keeps points p of clip space with dot(normal, p) >= least.
struct ClipPlane {
  glm::dvec4 normal{0.0};
  double least = 0.0;
  double inside_by(const glm::dvec4& p) const;
};

/// The six planes of the view volume: left, right, bottom, top, near, far.
std::array<ClipPlane, 6> view_volume_planes();

/// One of the clippers in a row: the part of a polygon that lies inside a plane. A new corner
/// depends on the edge alone, not on its direction, so neighbours that share an edge stay joined.
/// @param attribute_count how many of the attributes are carried along
/// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974.
void clip_against(const ClipPlane& plane, std::span<const ClipVertex> polygon, int attribute_count,
                  std::vector<ClipVertex>& clipped);

/// Sutherland-Hodgman against any planes, one after the other. Keeps its buffers.
class PolygonClipper {
 public:
  /// The clipped polygon, valid until the next call; empty if nothing is left, if fewer than three
  /// corners went in, or if a corner is not finite.
  std::span<const ClipVertex> clip(std::span<const ClipVertex> polygon,
                                   std::span<const ClipPlane> planes, int attribute_count);

 private:
  std::vector<ClipVertex> from_, to_;
};

}  // namespace kinescope
