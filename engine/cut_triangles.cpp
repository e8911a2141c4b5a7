#include "engine/cut_triangles.h"

#include <algorithm>

namespace kinescope {
namespace {

constexpr std::size_t kTaskTriangles = 8192;

/// Where a part's share begins in the joined arrays.
struct Offset {
  std::size_t triangle = 0, vertex = 0;
};

/// @param old_vertices indices from here on are the part's own, and move up by its offset
void copy_part(const CutPart& part, Offset offset, std::size_t old_vertices, std::uint32_t* indices,
               std::uint32_t* source_triangle, DevicePositions& device, float* new_rows,
               std::size_t row_stride) {
  const auto move = static_cast<std::uint32_t>(offset.vertex);
  std::transform(part.indices.begin(), part.indices.end(), indices + offset.triangle * 3,
                 [&](std::uint32_t i) { return i < old_vertices ? i : i + move; });
  std::copy(part.source_triangle.begin(), part.source_triangle.end(),
            source_triangle + offset.triangle);
  std::copy(part.rows.begin(), part.rows.end(), new_rows + offset.vertex * row_stride);
  std::copy(part.vertices.begin(), part.vertices.end(),
            device.vertices.data() + old_vertices + offset.vertex);
}

}  // namespace

void CutTriangles::cut(Workers& workers, const Projector& projector, float guard_band_px,
                       const Positions& world, std::span<const std::uint32_t> indices,
                       DevicePositions& device, std::vector<float>& rows, int row_stride,
                       int row_count) {
  const std::size_t triangles = indices.size() / 3;
  const std::size_t tasks = (triangles + kTaskTriangles - 1) / kTaskTriangles;
  const CutSource source{projector, guard_band_px, world,
                         device,    indices,       {rows.data(), row_stride, row_count}};
  parts_.resize(tasks);
  workers.run(static_cast<int>(tasks), [&](int task, int) {
    const std::size_t begin = static_cast<std::size_t>(task) * kTaskTriangles;
    const std::size_t end = std::min(triangles, begin + kTaskTriangles);
    CutPart& part = parts_[static_cast<std::size_t>(task)];
    part.clear();
    TriangleCutter cutter(source, part);
    for (std::size_t t = begin; t < end; ++t) cutter.add(static_cast<std::uint32_t>(t));
  });
  join(workers, world.count, device, rows, row_stride);
}

void CutTriangles::join(Workers& workers, std::size_t old_vertices, DevicePositions& device,
                        std::vector<float>& rows, int row_stride) {
  std::vector<Offset> offsets;
  Offset total;
  cut_count_ = 0;
  for (const CutPart& part : parts_) {
    offsets.push_back(total);
    total.triangle += part.source_triangle.size();
    total.vertex += part.vertices.size();
    cut_count_ += part.cut_count;
  }
  new_vertices_ = total.vertex;
  indices_.resize(total.triangle * 3);
  source_triangle_.resize(total.triangle);
  const auto stride = static_cast<std::size_t>(row_stride);
  rows.resize((old_vertices + total.vertex) * stride);
  device.resize(std::max(device.vertices.size(), old_vertices + total.vertex));
  workers.run(static_cast<int>(parts_.size()), [&](int task, int) {
    const auto p = static_cast<std::size_t>(task);
    copy_part(parts_[p], offsets[p], old_vertices, indices_.data(), source_triangle_.data(), device,
              rows.data() + old_vertices * stride, stride);
  });
}

}  // namespace kinescope
