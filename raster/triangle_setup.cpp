#include "raster/triangle_setup.h"

#include <cmath>
#include <limits>
#include <utility>

namespace kinescope {
namespace {

bool is_drawable(const DeviceVertex& v) {
  // Written so that NaN fails.
  return std::abs(v.x_px) <= DeviceVertex::kGuardBand &&
         std::abs(v.y_px) <= DeviceVertex::kGuardBand &&
         std::abs(v.z) <= std::numeric_limits<float>::max();
}

std::int64_t double_area(const std::array<std::int32_t, 3>& x,
                         const std::array<std::int32_t, 3>& y) {
  // Widened first: a side may be 2^24 raw units long.
  const auto side = [](std::int32_t a, std::int32_t b) { return std::int64_t{b} - a; };
  return side(x[0], x[1]) * side(y[0], y[2]) - side(x[0], x[2]) * side(y[0], y[1]);
}

void set_depth_plane(const std::array<float, 3>& z, SnappedTriangle& t) {
  const auto& x = t.x;
  const auto& y = t.y;
  const float z10 = z[1] - z[0];
  const float z20 = z[2] - z[0];
  const float inverse_area = 1.0f / static_cast<float>(t.double_area);
  const float num_x = z10 * static_cast<float>(y[2] - y[0]) - z20 * static_cast<float>(y[1] - y[0]);
  const float num_y = z20 * static_cast<float>(x[1] - x[0]) - z10 * static_cast<float>(x[2] - x[0]);
  t.depth.x_px = Fixed24_8::from_raw(x[0]).to_float();
  t.depth.y_px = Fixed24_8::from_raw(y[0]).to_float();
  t.depth.z = z[0];
  t.depth.dz_dx = num_x * inverse_area * 256.0f;
  t.depth.dz_dy = num_y * inverse_area * 256.0f;
  t.depth.nearest = std::min(std::min(z[0], z[1]), z[2]);
  t.depth.farthest = std::max(std::max(z[0], z[1]), z[2]);
}

}  // namespace

bool set_up_triangle(const DrawCall& call, std::size_t triangle, SnappedTriangle& out) {
  std::array<float, 3> z{};
  for (std::size_t i = 0; i < 3; ++i) {
    const DeviceVertex& from = call.vertices[call.indices[3 * triangle + i]];
    if (!is_drawable(from)) return false;
    out.x[i] = Fixed24_8::from_float(from.x_px).raw();
    out.y[i] = Fixed24_8::from_float(from.y_px).raw();
    // Adding zero turns -0 into 0, so that equal depths have equal bits.
    z[i] = std::min(std::max(from.z, 0.0f), 1.0f) + 0.0f;
  }
  out.double_area = double_area(out.x, out.y);
  const bool front = out.double_area < 0;  // counter-clockwise on the screen, y running down
  if (out.double_area == 0 || (front && call.cull == CullMode::kFront) ||
      (!front && call.cull == CullMode::kBack)) {
    return false;
  }
  if (front) {
    std::swap(out.x[1], out.x[2]);
    std::swap(out.y[1], out.y[2]);
    std::swap(z[1], z[2]);
    out.double_area = -out.double_area;
  }
  set_depth_plane(z, out);
  return true;
}

void set_up_snapped(const std::array<std::int32_t, 3>& x, const std::array<std::int32_t, 3>& y,
                    const std::array<float, 3>& z, SnappedTriangle& out) {
  out.x = x;
  out.y = y;
  out.double_area = double_area(x, y);
  set_depth_plane(z, out);
}

}  // namespace kinescope
