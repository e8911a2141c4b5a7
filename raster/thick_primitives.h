// Lines and points with width, as triangles that face the screen: so that wireframes share depth,
// samples and shaders with surfaces.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/draw_call.h"

namespace kinescope {

/// Corners in order around: two belong to the first end, then two to the second. Triangles
/// (0, 1, 2) and (0, 2, 3).
using DeviceQuad = std::array<DeviceVertex, 4>;

/// A line as a quad `width_px` wide, at least one pixel. Both ends reach half a width further, so
/// that lines which share an end leave no gap there. The quad is an exact parallelogram of snapped
/// corners, at least a pixel across along the axis that is the more perpendicular: so at one sample
/// a pixel the line is continuous. Nothing (four equal corners) if an end is not finite or lies
/// beyond the guard band.
DeviceQuad thick_line(const DeviceVertex& a, const DeviceVertex& b, float width_px);

/// A square around a point, `size_px` wide, at least one pixel.
DeviceQuad thick_point(const DeviceVertex& centre, float size_px);

/// Collects lines and points, with attributes, for one draw call.
class ThickPrimitives {
 public:
  /// @param attribute_count floats a vertex, 0 to Batch::kMaxAttributes
  explicit ThickPrimitives(int attribute_count = 0) : attribute_count_(attribute_count) {}

  /// Rows hold attribute_count floats, not divided by w.
  void add_line(const DeviceVertex& a, const DeviceVertex& b, float width_px,
                std::span<const float> row_a = {}, std::span<const float> row_b = {});
  void add_point(const DeviceVertex& centre, float size_px, std::span<const float> row = {});
  void clear();

  /// Both faces, and Batch::primitive counts lines and points in the order they were added. Valid
  /// until the next change.
  DrawCall draw_call(ShadeFunction shade, const void* constants = nullptr) const;

 private:
  void add(const DeviceQuad& quad, std::span<const float> row_a, std::span<const float> row_b);

  int attribute_count_;
  std::vector<DeviceVertex> vertices_;
  std::vector<float> rows_;
  std::vector<std::uint32_t> indices_, source_;
};

}  // namespace kinescope
