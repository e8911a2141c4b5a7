#include "engine/vertex_transform.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/vertex_transform.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef KINESCOPE_VERTEX_TRANSFORM_ONCE
#define KINESCOPE_VERTEX_TRANSFORM_ONCE
namespace kinescope {
namespace {
constexpr std::size_t kBlock = 64;  // vertices moved to world space at a time
}  // namespace
}  // namespace kinescope
#endif

// Every sum is ordered ((a x + b y) + c z) + d, without fused steps, on every instruction set: so
// a vertex lands on the same device position everywhere.
HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
// No more lanes than the padding holds.
using Floats = hn::CappedTag<float, Positions::kPadding>;
using Vec = hn::Vec<Floats>;

HWY_INLINE Vec weighted_sum(Vec x, Vec y, Vec z, float a, float b, float c) {
  const Floats d;
  return hn::Add(hn::Add(hn::Mul(x, hn::Set(d, a)), hn::Mul(y, hn::Set(d, b))),
                 hn::Mul(z, hn::Set(d, c)));
}

HWY_INLINE Vec sum_of_squares(Vec x, Vec y, Vec z) {
  return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
}

HWY_INLINE Vec affine(const glm::mat4& m, int row, Vec x, Vec y, Vec z) {
  return hn::Add(weighted_sum(x, y, z, m[0][row], m[1][row], m[2][row]),
                 hn::Set(Floats(), m[3][row]));
}

HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, Floats>> bit_where(hn::Mask<Floats> mask, int bit) {
  const hn::Rebind<std::int32_t, Floats> di;
  return hn::IfThenElseZero(hn::RebindMask(di, mask), hn::Set(di, bit));
}

HWY_INLINE hn::Mask<Floats> within(Vec v, Vec low, Vec high) {
  return hn::And(hn::Ge(v, low), hn::Le(v, high));
}

/// Comparisons are written so that NaN counts as outside.
HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, Floats>> outcodes_of(const Projector& p, Vec x, Vec y,
                                                                 Vec z, Vec w) {
  const Floats d;
  const Vec zero = hn::Zero(d), minus_w = hn::Neg(w);
  const auto fits = hn::And(
      hn::And(
          within(x, hn::Mul(w, hn::Set(d, p.guard_min.x)), hn::Mul(w, hn::Set(d, p.guard_max.x))),
          within(y, hn::Mul(w, hn::Set(d, p.guard_min.y)), hn::Mul(w, hn::Set(d, p.guard_max.y)))),
      hn::Ge(w, hn::Set(d, kLeastW)));
  // A number times 0 is 0 unless it is infinite or NaN, for which Ne() need not hold.
  const Vec zeros =
      hn::Mul(hn::Add(hn::Add(hn::Abs(x), hn::Abs(y)), hn::Add(hn::Abs(z), hn::Abs(w))), zero);
  auto code = bit_where(hn::Lt(x, minus_w), outcode::kLeft);
  code = hn::Or(code, bit_where(hn::Gt(x, w), outcode::kRight));
  code = hn::Or(code, bit_where(hn::Lt(y, minus_w), outcode::kBottom));
  code = hn::Or(code, bit_where(hn::Gt(y, w), outcode::kTop));
  code = hn::Or(code, bit_where(hn::Lt(z, zero), outcode::kNear));
  code = hn::Or(code, bit_where(hn::Gt(z, w), outcode::kFar));
  code = hn::Or(code, bit_where(hn::Not(fits), outcode::kGuard));
  return hn::Or(code, bit_where(hn::Not(hn::Eq(zeros, zero)), outcode::kNotFinite));
}

void project_range(const Projector& p, const Positions& world, std::size_t begin, std::size_t end,
                   DevicePositions& out) {
  const Floats d;
  const hn::Rebind<std::int32_t, Floats> di;
  const hn::Rebind<std::uint8_t, Floats> d8;
  const Vec one = hn::Set(d, 1.0f);
  for (std::size_t i = begin; i < end; i += hn::Lanes(d)) {
    const Vec wx = hn::LoadU(d, &world.x[i]), wy = hn::LoadU(d, &world.y[i]),
              wz = hn::LoadU(d, &world.z[i]);
    const Vec x = affine(p.clip_from_world, 0, wx, wy, wz);
    const Vec y = affine(p.clip_from_world, 1, wx, wy, wz);
    const Vec z = affine(p.clip_from_world, 2, wx, wy, wz);
    const Vec w = affine(p.clip_from_world, 3, wx, wy, wz);
    const auto code = outcodes_of(p, x, y, z, w);
    const auto kept =
        hn::RebindMask(d, hn::Eq(hn::And(code, hn::Set(di, outcode::kMustCut)), hn::Zero(di)));
    const Vec inv_w = hn::Div(one, hn::IfThenElse(kept, w, one));
    const auto& to_px = p.device_from_ndc;
    const Vec x_px =
        hn::Add(hn::Mul(hn::Mul(x, inv_w), hn::Set(d, to_px.scale.x)), hn::Set(d, to_px.offset.x));
    const Vec y_px =
        hn::Add(hn::Mul(hn::Mul(y, inv_w), hn::Set(d, to_px.scale.y)), hn::Set(d, to_px.offset.y));
    // z <= w, yet z times the rounded reciprocal may exceed 1 by a bit.
    const Vec depth = hn::Min(hn::Mul(z, inv_w), one);
    hn::StoreInterleaved4(hn::IfThenElseZero(kept, x_px), hn::IfThenElseZero(kept, y_px),
                          hn::IfThenElseZero(kept, depth), inv_w, d, &out.vertices[i].x_px);
    hn::StoreU(hn::DemoteTo(d8, code), d8, &out.outcodes[i]);
  }
}

/// `values` holds six arrays of kBlock floats: position and normal.
void to_world_block(const WorldTransform& t, float* values) {
  const Floats d;
  for (std::size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
    const auto at = [&](std::size_t array) { return values + array * kBlock + i; };
    const Vec x = hn::Load(d, at(0)), y = hn::Load(d, at(1)), z = hn::Load(d, at(2));
    hn::Store(affine(t.world_from_local, 0, x, y, z), d, at(0));
    hn::Store(affine(t.world_from_local, 1, x, y, z), d, at(1));
    hn::Store(affine(t.world_from_local, 2, x, y, z), d, at(2));
    const Vec nx = hn::Load(d, at(3)), ny = hn::Load(d, at(4)), nz = hn::Load(d, at(5));
    const glm::mat3& m = t.normal_matrix;
    const Vec wx = weighted_sum(nx, ny, nz, m[0][0], m[1][0], m[2][0]);
    const Vec wy = weighted_sum(nx, ny, nz, m[0][1], m[1][1], m[2][1]);
    const Vec wz = weighted_sum(nx, ny, nz, m[0][2], m[1][2], m[2][2]);
    const Vec length = hn::Sqrt(sum_of_squares(wx, wy, wz));
    const auto usable = hn::Gt(length, hn::Zero(d));
    hn::Store(hn::IfThenElseZero(usable, hn::Div(wx, length)), d, at(3));
    hn::Store(hn::IfThenElseZero(usable, hn::Div(wy, length)), d, at(4));
    hn::Store(hn::IfThenElseZero(usable, hn::Div(wz, length)), d, at(5));
  }
}

}  // namespace
}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {
namespace {

HWY_EXPORT(project_range);
HWY_EXPORT(to_world_block);

glm::dmat3 cofactors(const glm::dmat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

}  // namespace

void Positions::resize(std::size_t n) {
  count = n;
  for (std::vector<float>* array : {&x, &y, &z}) {
    array->resize(n);  // padding left by a longer list must read as zeros again
    array->resize(n + kPadding, 0.0f);
  }
}

void DevicePositions::resize(std::size_t n) {
  vertices.resize(n);
  outcodes.resize(n);
}

Projector make_projector(const glm::mat4& clip_from_world, const Viewport& viewport,
                         float guard_band_px) {
  Projector p;
  p.clip_from_world = clip_from_world;
  p.device_from_ndc = device_from_ndc(viewport);
  const float reach = guard_band_px - 1.0f;
  for (int i = 0; i < 2; ++i) {
    const float scale = p.device_from_ndc.scale[i], offset = p.device_from_ndc.offset[i];
    const float a = (-reach - offset) / scale, b = (reach - offset) / scale;
    p.guard_min[i] = std::min({a, b, -1.0f});
    p.guard_max[i] = std::max({a, b, 1.0f});
  }
  return p;
}

OutcodeSummary project(const Projector& projector, const Positions& world, std::size_t begin,
                       std::size_t end, DevicePositions& out) {
  assert(begin % Positions::kPadding == 0 && end <= world.count);
  assert(out.vertices.size() >= end + Positions::kPadding);
  HWY_DYNAMIC_DISPATCH(project_range)(projector, world, begin, end, out);
  OutcodeSummary summary;
  for (std::size_t i = begin; i < end; ++i) {
    summary.any |= out.outcodes[i];
    summary.all &= out.outcodes[i];
  }
  return summary;
}

WorldTransform make_world_transform(const glm::mat4& world_from_local) {
  WorldTransform t;
  t.world_from_local = world_from_local;
  const glm::dmat3 linear(world_from_local);
  const glm::dmat3 normals = cofactors(linear);
  const double determinant = glm::dot(linear[0], normals[0]);
  t.mirrors = determinant < 0.0;
  double largest = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(normals[i][j]));
  }
  const bool usable = largest > 0.0 && std::isfinite(largest);
  // Scaled so that squares neither overflow nor vanish.
  t.normal_matrix =
      glm::mat3(usable ? normals * ((t.mirrors ? -1.0 : 1.0) / largest) : glm::dmat3(1.0));
  return t;
}

void to_world(const WorldTransform& transform, std::span<const glm::vec3> local_positions,
              std::span<const glm::vec3> local_normals, std::size_t begin, std::size_t end,
              Positions& positions, std::span<float> rows, int stride) {
  assert(end <= positions.count && end <= local_positions.size() && end <= local_normals.size());
  alignas(64) std::array<float, 6 * kBlock> block{};
  const auto kernel = HWY_DYNAMIC_DISPATCH(to_world_block);
  for (std::size_t first = begin; first < end; first += kBlock) {
    const std::size_t n = std::min(kBlock, end - first);
    for (std::size_t i = 0; i < n; ++i) {
      for (int c = 0; c < 3; ++c) {
        const std::size_t at = static_cast<std::size_t>(c) * kBlock + i;
        block[at] = local_positions[first + i][c];
        block[at + 3 * kBlock] = local_normals[first + i][c];
      }
    }
    kernel(transform, block.data());
    std::copy_n(&block[0], n, &positions.x[first]);
    std::copy_n(&block[kBlock], n, &positions.y[first]);
    std::copy_n(&block[2 * kBlock], n, &positions.z[first]);
    float* row = &rows[first * static_cast<std::size_t>(stride)];
    for (std::size_t i = 0; i < n; ++i, row += stride) {
      for (std::size_t c = 0; c < 6; ++c) row[c] = block[c * kBlock + i];
    }
  }
}

}  // namespace kinescope
#endif
