#include "raster/kernels/interpolate_blocks.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/interpolate_blocks.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/weight_planes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kSide = TileBuffer::kBlock;
constexpr std::size_t kPixels = TileBuffer::kBlockPixels;
constexpr std::size_t kLanes = hn::MaxLanes(F());
constexpr std::size_t kVectors = kPixels / kLanes;

/// One triangle's pixels in a block, in whole vectors. Those of its pixels' rows that no triangle
/// before it has written hold nothing yet: they are written whole.
struct Share {
  std::size_t triangle;
  std::size_t first, fresh, end;  ///< vectors; from `fresh` on they are written whole
  /// Weights of the second and third vertex, and what they were divided by.
  hn::Vec<F> w1[kVectors], w2[kVectors], inverse[kVectors];
  hn::Mask<F> owned[kVectors];
};

HWY_INLINE hn::Mask<F> owned_lanes(std::uint64_t pixels, std::size_t vector) {
  // As many bytes as the widest vector needs.
  const std::uint8_t bits[8] = {static_cast<std::uint8_t>(pixels >> (vector * kLanes))};
  return hn::LoadMaskBits(F(), bits);
}

HWY_INLINE void begin_share(const BlockBatch::Share& from, std::size_t written, Share& s) {
  s.triangle = from.triangle;
  s.first = static_cast<std::size_t>(std::countr_zero(from.pixels)) / kLanes;
  s.end = static_cast<std::size_t>(63 - std::countl_zero(from.pixels)) / kLanes + 1;
  s.fresh = std::min(std::max(s.first, written), s.end);
  for (std::size_t v = s.first; v < s.fresh; ++v) s.owned[v] = owned_lanes(from.pixels, v);
}

HWY_INLINE void weigh(const BlockBatch::Block& block, const WeightPlanes& p, Share& s) {
  const F f;
  using V = hn::Vec<F>;
  const std::size_t t = s.triangle;
  const V zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  const V dx1 = hn::Set(f, p.dx1[t]), dx2 = hn::Set(f, p.dx2[t]), dxs = hn::Set(f, p.dx_sum[t]);
  const V dy1 = hn::Set(f, p.dy1[t]), dy2 = hn::Set(f, p.dy2[t]), dys = hn::Set(f, p.dy_sum[t]);
  const V w0 = hn::Set(f, p.w0[t]);
  // All of these are exact.
  const V left = lanes_from(f, static_cast<float>(block.x0) + 0.5f - p.x_px[t]);
  const float top = static_cast<float>(block.y0) + 0.5f - p.y_px[t];
  V dy = hn::Set(f, top + static_cast<float>(s.first * kLanes / kSide));
  for (std::size_t v = s.first; v < s.end; ++v) {
    V dx = left;
    if constexpr (kLanes < kSide) {
      dx = hn::Add(left, hn::Set(f, static_cast<float>(v * kLanes % kSide)));
      dy = hn::Set(f, top + static_cast<float>(v * kLanes / kSide));
    }
    const V sum = hn::MulAdd(dx, dxs, hn::MulAdd(dy, dys, w0));
    const V inverse = hn::Div(one, sum);
    const V raw1 = hn::MulAdd(dx, dx1, hn::Mul(dy, dy1));
    const V raw2 = hn::MulAdd(dx, dx2, hn::Mul(dy, dy2));
    s.inverse[v] = inverse;
    s.w1[v] = hn::Min(hn::Max(hn::Mul(raw1, inverse), zero), one);
    s.w2[v] = hn::Min(hn::Max(hn::Mul(raw2, inverse), zero), hn::Sub(one, s.w1[v]));
    dy = hn::Add(dy, one);
  }
}

/// Writes value(vector, n) to the triangle's pixels of each array.
template <std::size_t kArrays, class Value, typename T>
HWY_INLINE void write(const Share& s, const Value& value, T* const (&to)[kArrays]) {
  const hn::Rebind<T, F> d;
  for (std::size_t v = s.first; v < s.fresh; ++v) {
    const auto owned = hn::RebindMask(d, s.owned[v]);
    HWY_UNROLL(4)
    for (std::size_t n = 0; n < kArrays; ++n) {
      T* const at = to[n] + v * kLanes;
      hn::Store(hn::IfThenElse(owned, value(v, n), hn::Load(d, at)), d, at);
    }
  }
  for (std::size_t v = s.fresh; v < s.end; ++v) {
    HWY_UNROLL(4)
    for (std::size_t n = 0; n < kArrays; ++n) hn::Store(value(v, n), d, to[n] + v * kLanes);
  }
}

/// Several attributes at once, so that weights are loaded once for them.
template <std::size_t kCount>
HWY_INLINE void write_attributes(const Share& s, const std::size_t* index, std::size_t at,
                                 BatchStorage& batch) {
  const F f;
  hn::Vec<F> base[kCount], rise1[kCount], rise2[kCount];
  float* to[kCount];
  HWY_UNROLL(4)
  for (std::size_t n = 0; n < kCount; ++n) {
    base[n] = hn::Set(f, batch.planes.attribute[0][index[n]][s.triangle]);
    rise1[n] = hn::Set(f, batch.planes.attribute[1][index[n]][s.triangle]);
    rise2[n] = hn::Set(f, batch.planes.attribute[2][index[n]][s.triangle]);
    to[n] = batch.attribute[index[n]].data() + at;
  }
  const auto value = [&](std::size_t v, std::size_t n) HWY_ATTR {
    return hn::MulAdd(s.w2[v], rise2[n], hn::MulAdd(s.w1[v], rise1[n], base[n]));
  };
  write<kCount>(s, value, to);
}

/// Steps of a texture coordinate, a pixel to the right and a pixel down.
HWY_INLINE void write_gradients(const DrawCall& call, const Share& s, std::size_t coordinate,
                                std::size_t at, BatchStorage& batch) {
  const F f;
  const WeightPlanes& p = batch.planes;
  const auto uv = static_cast<std::size_t>(call.texcoord_attribute) + coordinate;
  const float* const place = batch.attribute[uv].data() + at;
  const hn::Vec<F> sum[2] = {hn::Set(f, p.dx_sum[s.triangle]), hn::Set(f, p.dy_sum[s.triangle])};
  const hn::Vec<F> at_zero[2] = {hn::Set(f, p.gradient[coordinate][s.triangle]),
                                 hn::Set(f, p.gradient[2 + coordinate][s.triangle])};
  const auto value = [&](std::size_t v, std::size_t n) HWY_ATTR {
    const auto u = hn::Load(f, place + v * kLanes);
    return hn::Mul(s.inverse[v], hn::NegMulAdd(u, sum[n], at_zero[n]));
  };
  write<2>(s, value,
           {batch.gradient[coordinate].data() + at, batch.gradient[2 + coordinate].data() + at});
}

HWY_INLINE void write_share(const DrawCall& call, const AttributeList& list, const Share& s,
                            std::size_t at, BatchStorage& batch) {
  const auto number = hn::Set(U(), batch.planes.triangle[s.triangle]);
  const auto of_number = [&](std::size_t, std::size_t) HWY_ATTR { return number; };
  write<1>(s, of_number, {batch.triangle.data() + at});
  const std::size_t* const index = list.index.data();
  std::size_t n = 0;
  for (; n + 3 <= list.count; n += 3) write_attributes<3>(s, index + n, at, batch);
  if (n + 2 <= list.count) write_attributes<2>(s, index + n, at, batch);
  if (n + 1 == list.count) write_attributes<1>(s, index + n, at, batch);
  if (call.cull == CullMode::kNone) {
    const auto facing = hn::Set(F(), batch.planes.facing[s.triangle]);
    const auto of_facing = [&](std::size_t, std::size_t) HWY_ATTR { return facing; };
    write<1>(s, of_facing, {batch.facing.data() + at});
  }
  if (call.texcoord_attribute < 0) return;
  write_gradients(call, s, 0, at, batch);
  write_gradients(call, s, 1, at, batch);
}

HWY_INLINE void write_places(const BlockBatch::Block& block, std::size_t at, BatchStorage& batch) {
  const hn::CappedTag<std::uint16_t, kSide> d;
  constexpr std::size_t kStep = hn::MaxLanes(hn::CappedTag<std::uint16_t, kSide>());
  std::uint16_t* const x = batch.x.data() + at;
  std::uint16_t* const y = batch.y.data() + at;
  auto row = hn::Set(d, static_cast<std::uint16_t>(block.y0));
  for (std::size_t r = 0; r < kSide; ++r, row = hn::Add(row, hn::Set(d, std::uint16_t{1}))) {
    for (std::size_t c = 0; c < kSide; c += kStep) {
      const auto column = static_cast<std::uint16_t>(static_cast<std::size_t>(block.x0) + c);
      hn::Store(lanes_from(d, column), d, x + r * kSide + c);
      hn::Store(row, d, y + r * kSide + c);
    }
  }
}

void InterpolateBlocks(const DrawCall& call, const BlockBatch& blocks, BatchStorage& batch) {
  const AttributeList list(call);
  if (blocks.ready < blocks.triangles) {
    set_up_triangles(call, blocks.ready, blocks.triangles, batch.planes);
  }
  Share share;
  std::size_t next = 0;
  for (std::size_t b = 0; b < blocks.size; ++b) {
    const BlockBatch::Block& block = blocks.block[b];
    write_places(block, b * kPixels, batch);
    // Each triangle is the owner of the first pixel that those before it left.
    std::size_t written = 0;
    for (; next < block.end; ++next) {
      begin_share(blocks.share[next], written, share);
      written = std::max(written, share.end);
      weigh(block, batch.planes, share);
      write_share(call, list, share, b * kPixels, batch);
    }
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(InterpolateBlocks);

void interpolate_blocks(const DrawCall& call, const BlockBatch& blocks, BatchStorage& batch) {
  HWY_DYNAMIC_DISPATCH(InterpolateBlocks)(call, blocks, batch);
}

}  // namespace kinescope
#endif
