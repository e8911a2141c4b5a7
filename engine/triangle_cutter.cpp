#include "engine/triangle_cutter.h"

#include <algorithm>

namespace kinescope {
namespace {

/// Near plane first: behind the eye the others mean nothing.
std::array<ClipPlane, 7> pipeline_planes(const Projector& p) {
  return {{{{0, 0, 1, 0}},
           {{0, 0, -1, 1}},
           {{0, 0, 0, 1}, kLeastW},
           {{1, 0, 0, -p.guard_min.x}},
           {{-1, 0, 0, p.guard_max.x}},
           {{0, 1, 0, -p.guard_min.y}},
           {{0, -1, 0, p.guard_max.y}}}};
}

}  // namespace

DeviceVertex device_vertex(const Projector& p, const glm::dvec4& clip, float limit_px) {
  const double inv_w = 1.0 / std::max<double>(clip.w, kLeastW), limit = limit_px;
  const auto& to_px = p.device_from_ndc;
  const double x = clip.x * inv_w * to_px.scale.x + to_px.offset.x;
  const double y = clip.y * inv_w * to_px.scale.y + to_px.offset.y;
  return {static_cast<float>(std::clamp(x, -limit, limit)),
          static_cast<float>(std::clamp(y, -limit, limit)),
          static_cast<float>(std::clamp(clip.z * inv_w, 0.0, 1.0)), static_cast<float>(inv_w)};
}

void CutPart::clear() {
  indices.clear();
  source_triangle.clear();
  vertices.clear();
  rows.clear();
  cut_count = 0;
}

TriangleCutter::TriangleCutter(const CutSource& source, CutPart& part)
    : source_(source), part_(part), planes_(pipeline_planes(source.projector)) {}

void TriangleCutter::add(std::uint32_t triangle) {
  const std::vector<std::uint8_t>& codes = source_.device.outcodes;
  const std::uint32_t* corners = &source_.indices[std::size_t{triangle} * 3];
  const int a = codes[corners[0]], b = codes[corners[1]], c = codes[corners[2]];
  const int any = a | b | c;
  if ((a & b & c & outcode::kVolume) != 0 || (any & outcode::kNotFinite) != 0) return;
  if ((any & outcode::kMustCut) == 0) {
    keep(corners[0], corners[1], corners[2], triangle);
  } else {
    cut(corners, triangle);
  }
}

void TriangleCutter::keep(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                          std::uint32_t triangle) {
  part_.indices.insert(part_.indices.end(), {a, b, c});
  part_.source_triangle.push_back(triangle);
}

void TriangleCutter::cut(const std::uint32_t* corners, std::uint32_t triangle) {
  ++part_.cut_count;
  const std::array<ClipVertex, 3> polygon{clip_vertex(corners[0], 0), clip_vertex(corners[1], 1),
                                          clip_vertex(corners[2], 2)};
  polygon_.clear();
  for (const ClipVertex& v : clipper_.clip(polygon, planes_, source_.rows.count)) {
    // A corner that the kernel projected keeps its place to the last bit.
    const bool projected =
        v.corner >= 0 && (source_.device.outcodes[corners[v.corner]] & outcode::kMustCut) == 0;
    polygon_.push_back(projected ? corners[v.corner] : new_vertex(v));
  }
  for (std::size_t i = 2; i < polygon_.size(); ++i) {
    keep(polygon_[0], polygon_[i - 1], polygon_[i], triangle);
  }
}

ClipVertex TriangleCutter::clip_vertex(std::uint32_t index, int corner) const {
  ClipVertex v;
  // In single precision and the kernel's order: the outcode was made from these very numbers.
  const glm::mat4& m = source_.projector.clip_from_world;
  const Positions& p = source_.world;
  for (int row = 0; row < 4; ++row) {
    v.position[row] =
        ((m[0][row] * p.x[index] + m[1][row] * p.y[index]) + m[2][row] * p.z[index]) + m[3][row];
  }
  const std::size_t begin = std::size_t{index} * static_cast<std::size_t>(source_.rows.stride);
  std::copy_n(source_.rows.rows + begin, source_.rows.count, v.attributes.begin());
  v.corner = corner;
  return v;
}

std::uint32_t TriangleCutter::new_vertex(const ClipVertex& v) {
  const std::size_t index = source_.world.count + part_.vertices.size();
  part_.vertices.push_back(device_vertex(source_.projector, v.position, source_.guard_band_px));
  const std::size_t begin = part_.rows.size();
  part_.rows.resize(begin + static_cast<std::size_t>(source_.rows.stride), 0.0f);
  std::copy_n(v.attributes.begin(), source_.rows.count, &part_.rows[begin]);
  return static_cast<std::uint32_t>(index);
}

}  // namespace kinescope
