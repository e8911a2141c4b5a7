// The clipping stage of the pipeline: most triangles pass untouched, few are cut.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/triangle_cutter.h"
#include "raster/base/workers.h"

namespace kinescope {

/// The triangles left, as the rasterizer takes them. Keeps its buffers between frames.
class CutTriangles {
 public:
  /// Drops triangles that lie outside one plane of the view volume or are not finite; cuts those
  /// that leave the guard band or cross the near or far plane; keeps the others as they are; all in
  /// order. New vertices are appended to `device` and `rows`, from vertex world.count on.
  void cut(Workers& workers, const Projector& projector, float guard_band_px,
           const Positions& world, std::span<const std::uint32_t> indices, DevicePositions& device,
           std::vector<float>& rows, int row_stride, int row_count);

  std::span<const std::uint32_t> indices() const { return indices_; }
  std::span<const std::uint32_t> source_triangle() const { return source_triangle_; }
  std::size_t new_vertices() const { return new_vertices_; }
  std::uint64_t cut_count() const { return cut_count_; }  ///< triangles that were cut

 private:
  void join(Workers& workers, std::size_t old_vertices, DevicePositions& device,
            std::vector<float>& rows, int row_stride);

  std::vector<CutPart> parts_;
  std::vector<std::uint32_t> indices_, source_triangle_;
  std::size_t new_vertices_ = 0;
  std::uint64_t cut_count_ = 0;
};

}  // namespace kinescope
