#include "raster/thick_primitives.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "raster/base/fixed.h"

namespace kinescope {
namespace {

/// A place or a way on the screen, raw Fixed24_8.
struct RawPair {
  std::int32_t x, y;
};

constexpr std::int32_t kRawPixel = Fixed24_8::kOne;

bool is_drawable(const DeviceVertex& v) {
  // Written so that NaN fails.
  return std::abs(v.x_px) <= DeviceVertex::kGuardBand &&
         std::abs(v.y_px) <= DeviceVertex::kGuardBand;
}

RawPair snap(float x_px, float y_px) {
  return {Fixed24_8::from_float(x_px).raw(), Fixed24_8::from_float(y_px).raw()};
}

/// In pixels, and within the guard band.
float to_px(std::int32_t raw) {
  constexpr std::int32_t kLimit = static_cast<std::int32_t>(DeviceVertex::kGuardBand) * kRawPixel;
  return Fixed24_8::from_raw(std::clamp(raw, -kLimit, kLimit)).to_float();
}

DeviceVertex corner(const DeviceVertex& end, RawPair at, int x, int y) {
  return {to_px(at.x + x), to_px(at.y + y), end.z, end.inv_w};
}

float at_least_a_pixel(float width_px) {
  return std::min(std::max(1.0f, width_px), DeviceVertex::kGuardBand);
}

/// Half of the way across a line that runs along `way`: `half_width_px` at right angles, lengthened
/// where rounding left less than a pixel across along x or y.
RawPair across(RawPair way, float half_width_px) {
  const double length = std::hypot(way.x, way.y);
  const double scale = double{half_width_px} * kRawPixel / length;
  RawPair out = {static_cast<std::int32_t>(std::lrint(-way.y * scale)),
                 static_cast<std::int32_t>(std::lrint(way.x * scale))};
  const std::int64_t along = std::max(std::abs(way.x), std::abs(way.y));
  const std::int64_t area = std::int64_t{way.x} * out.y - std::int64_t{way.y} * out.x;
  if (2 * area < kRawPixel * along) {
    if (std::abs(way.x) >= std::abs(way.y)) {
      out.y += way.x > 0 ? 1 : -1;
    } else {
      out.x += way.y > 0 ? -1 : 1;
    }
  }
  return out;
}

}  // namespace

DeviceQuad thick_line(const DeviceVertex& a, const DeviceVertex& b, float width_px) {
  if (!is_drawable(a) || !is_drawable(b)) return {};
  const RawPair from = snap(a.x_px, a.y_px), to = snap(b.x_px, b.y_px);
  const RawPair way = {to.x - from.x, to.y - from.y};
  if (way.x == 0 && way.y == 0) return thick_point(a, width_px);
  const float half = 0.5f * at_least_a_pixel(width_px);
  const double length = std::hypot(way.x, way.y);
  const double scale = double{half} * kRawPixel / length;
  const RawPair cap = {static_cast<std::int32_t>(std::lrint(way.x * scale)),
                       static_cast<std::int32_t>(std::lrint(way.y * scale))};
  const RawPair side = across({way.x + 2 * cap.x, way.y + 2 * cap.y}, half);
  return {corner(a, from, side.x - cap.x, side.y - cap.y),
          corner(a, from, -side.x - cap.x, -side.y - cap.y),
          corner(b, to, -side.x + cap.x, -side.y + cap.y),
          corner(b, to, side.x + cap.x, side.y + cap.y)};
}

DeviceQuad thick_point(const DeviceVertex& centre, float size_px) {
  if (!is_drawable(centre)) return {};
  const RawPair at = snap(centre.x_px, centre.y_px);
  const int half = Fixed24_8::from_float(0.5f * at_least_a_pixel(size_px)).raw();
  return {corner(centre, at, -half, -half), corner(centre, at, -half, half),
          corner(centre, at, half, half), corner(centre, at, half, -half)};
}

void ThickPrimitives::add_line(const DeviceVertex& a, const DeviceVertex& b, float width_px,
                               std::span<const float> row_a, std::span<const float> row_b) {
  add(thick_line(a, b, width_px), row_a, row_b);
}

void ThickPrimitives::add_point(const DeviceVertex& centre, float size_px,
                                std::span<const float> row) {
  add(thick_point(centre, size_px), row, row);
}

void ThickPrimitives::clear() {
  vertices_.clear();
  rows_.clear();
  indices_.clear();
  source_.clear();
}

void ThickPrimitives::add(const DeviceQuad& quad, std::span<const float> row_a,
                          std::span<const float> row_b) {
  assert(row_a.size() == static_cast<std::size_t>(attribute_count_) &&
         row_b.size() == row_a.size());
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  const auto number = static_cast<std::uint32_t>(source_.size() / 2);
  for (std::size_t i = 0; i < quad.size(); ++i) {
    vertices_.push_back(quad[i]);
    const std::span<const float> row = i < 2 ? row_a : row_b;
    rows_.insert(rows_.end(), row.begin(), row.end());
  }
  for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) indices_.push_back(first + i);
  source_.insert(source_.end(), 2, number);
}

DrawCall ThickPrimitives::draw_call(ShadeFunction shade, const void* constants) const {
  DrawCall call;
  call.vertices = vertices_;
  call.indices = indices_;
  call.source_triangle = source_;
  call.attributes = rows_;
  call.attribute_count = call.attribute_stride = attribute_count_;
  call.cull = CullMode::kNone;
  call.shade = shade;
  call.constants = constants;
  return call;
}

}  // namespace kinescope
