// One triangle through the pipeline's clipper: dropped, kept as it is, or cut.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/clip_homogeneous.h"
#include "engine/vertex_transform.h"
#include "raster/thick_primitives.h"

namespace kinescope {

/// Projects a clipped point. What rounding left outside is put on the edge of [-limit_px, limit_px]
/// and of the range of depth.
DeviceVertex device_vertex(const Projector& projector, const glm::dvec4& clip, float limit_px);

/// Rows of vertex attributes, `count` floats of each, `stride` floats apart.
struct RowView {
  const float* rows;
  int stride;
  int count;
};

/// What the cutter reads.
struct CutSource {
  const Projector& projector;
  float guard_band_px;
  const Positions& world;
  const DevicePositions& device;
  std::span<const std::uint32_t> indices;
  RowView rows;
};

/// A run of triangles after the cut. Its new vertices are numbered from world.count on.
struct CutPart {
  std::vector<std::uint32_t> indices, source_triangle;
  std::vector<DeviceVertex> vertices;
  std::vector<float> rows;  ///< of the new vertices, as far apart as the old ones
  std::uint64_t cut_count = 0;
  void clear();
};

class TriangleCutter {
 public:
  TriangleCutter(const CutSource& source, CutPart& part);
  void add(std::uint32_t triangle);

 private:
  void keep(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t triangle);
  void cut(const std::uint32_t* corners, std::uint32_t triangle);
  ClipVertex clip_vertex(std::uint32_t index, int corner) const;
  std::uint32_t new_vertex(const ClipVertex& v);

  const CutSource& source_;
  CutPart& part_;
  std::array<ClipPlane, 7> planes_;
  PolygonClipper clipper_;
  std::vector<std::uint32_t> polygon_;
};

}  // namespace kinescope
