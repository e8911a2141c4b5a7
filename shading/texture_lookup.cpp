// Nearest, bilinear and trilinear lookup with a level of detail for every fragment (L. Williams,
// "Pyramidal parametrics", SIGGRAPH 1983). Places are computed a vector of fragments at a time;
// texels, whose four channels fill a vector, are then mixed one fragment at a time, without
// gathers.
#include "shading/texture_lookup.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/texture_lookup.cpp"
#include <hwy/foreach_target.h>
// after foreach_target
#include <hwy/highway.h>

#include <algorithm>

#include "shading/kernels/channels-inl.h"
#include "shading/kernels/fast_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Vec = hn::Vec<Floats>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Floats()));

/// Where one level is read: the top left of four texels, and the weights of right and bottom.
struct Place {
  hn::Vec<Ints> offset;  ///< from the first texel of the first level
  Vec right, bottom;
};

/// The same for the lanes of a vector, in memory.
struct PlaceArrays {
  alignas(64) std::int32_t offset[kLanes];
  alignas(64) float right[kLanes];
  alignas(64) float bottom[kLanes];

  HWY_INLINE void store(const Place& place) {
    hn::Store(place.offset, Ints(), offset);
    hn::Store(place.right, Floats(), right);
    hn::Store(place.bottom, Floats(), bottom);
  }
};

/// A coordinate brought into [0, 1] by its wrap mode; 0 if it is not finite.
HWY_INLINE Vec wrapped(Vec u, Wrap wrap) {
  const Floats d;
  if (wrap == Wrap::kRepeat) u = hn::Sub(u, hn::Floor(u));
  if (wrap == Wrap::kMirror) {
    const Vec half = hn::Set(d, 0.5f);
    const Vec period = hn::Floor(hn::Add(hn::Mul(u, half), half));
    u = hn::Abs(hn::Sub(u, hn::Add(period, period)));
  }
  return hn::IfThenElseZero(hn::Ge(u, hn::Zero(d)), hn::Min(u, hn::Set(d, 1.0f)));
}

/// The first of the two texels beside u, as a whole number, and the second one's weight.
struct Neighbours {
  Vec first, fraction;
};

HWY_INLINE Neighbours neighbours(Vec u, int size, Wrap wrap) {
  const Floats d;
  const Vec sizes = hn::Set(d, static_cast<float>(size));
  const Vec last = hn::Set(d, static_cast<float>(size - 1));
  Vec x = hn::Sub(hn::Mul(u, sizes), hn::Set(d, 0.5f));
  if (wrap == Wrap::kRepeat) {
    x = hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Add(x, sizes), x);
  } else {
    x = hn::Min(hn::Max(x, hn::Zero(d)), last);
  }
  const Vec first = hn::Min(hn::Floor(x), last);
  return {first, hn::Sub(x, first)};
}

HWY_INLINE hn::Vec<Ints> offsets(const Texture& texture, int level, Vec x, Vec y) {
  const Ints di;
  const Texture::Level picture = texture.view(level);
  const auto base = static_cast<std::int32_t>(picture.row(0) - texture.view(0).row(0));
  const auto row = hn::Mul(hn::ConvertTo(di, y), hn::Set(di, picture.stride()));
  return hn::Add(hn::Add(row, hn::ConvertTo(di, x)), hn::Set(di, base));
}

HWY_INLINE Place bilinear_place(const Texture& texture, int level, Vec u, Vec v) {
  const Neighbours x = neighbours(u, texture.view(level).width(), texture.wrap_u);
  const Neighbours y = neighbours(v, texture.view(level).height(), texture.wrap_v);
  return {offsets(texture, level, x.first, y.first), x.fraction, y.fraction};
}

HWY_INLINE Vec level_of_detail(const Texture& texture, const Batch& batch, int i) {
  const Floats d;
  if (batch.du_dx == nullptr) return hn::Zero(d);
  const Vec width = hn::Set(d, static_cast<float>(texture.view(0).width()));
  const Vec height = hn::Set(d, static_cast<float>(texture.view(0).height()));
  const auto squared = [&](const float* du, const float* dv) HWY_ATTR {
    const Vec across = hn::Mul(hn::Load(d, du + i), width);
    const Vec down = hn::Mul(hn::Load(d, dv + i), height);
    return hn::MulAdd(down, down, hn::Mul(across, across));
  };
  const Vec longer = hn::Max(squared(batch.du_dx, batch.dv_dx), squared(batch.du_dy, batch.dv_dy));
  const Vec lod = hn::Mul(fast_log2(d, longer), hn::Set(d, 0.5f));
  const Vec last = hn::Set(d, static_cast<float>(texture.levels() - 1));
  return hn::IfThenElseZero(hn::Ge(lod, hn::Zero(d)), hn::Min(lod, last));
}

HWY_INLINE Channels bilinear(const Texel* texels, int stride, const PlaceArrays& place, int lane) {
  const Texel* top = texels + place.offset[lane];
  const Texel* bottom = top + stride;
  return mix(mix(channels(top), channels(bottom), place.bottom[lane]),
             mix(channels(top + 1), channels(bottom + 1), place.bottom[lane]), place.right[lane]);
}

HWY_INLINE void nearest_vector(const Texture& texture, Vec u, Vec v, int count, LinearRgba* out) {
  const Floats d;
  const auto whole = [&](Vec x, int size) HWY_ATTR {
    return hn::Min(hn::Floor(hn::Mul(x, hn::Set(d, static_cast<float>(size)))),
                   hn::Set(d, static_cast<float>(size - 1)));
  };
  const Texture::Level picture = texture.view(0);
  alignas(64) std::int32_t offset[kLanes];
  hn::Store(offsets(texture, 0, whole(u, picture.width()), whole(v, picture.height())), Ints(),
            offset);
  for (int k = 0; k < count; ++k) write(channels(picture.row(0) + offset[k]), out + k);
}

HWY_INLINE void bilinear_vector(const Texture& texture, Vec u, Vec v, int count, LinearRgba* out) {
  PlaceArrays place;
  place.store(bilinear_place(texture, 0, u, v));
  const Texture::Level picture = texture.view(0);
  for (int k = 0; k < count; ++k) {
    write(bilinear(picture.row(0), picture.stride(), place, k), out + k);
  }
}

HWY_INLINE void trilinear_vector(const Texture& texture, Vec u, Vec v, Vec lod, int count,
                                 LinearRgba* out) {
  const Floats d;
  const Vec fine = hn::Floor(lod);
  const Vec last = hn::Set(d, static_cast<float>(texture.levels() - 1));
  const Vec coarse = hn::Min(hn::Add(fine, hn::Set(d, 1.0f)), last);
  const int first_level = static_cast<int>(hn::GetLane(hn::MinOfLanes(d, fine)));
  const int last_level = static_cast<int>(hn::GetLane(hn::MaxOfLanes(d, coarse)));
  alignas(64) std::int32_t stride[2][kLanes];
  Place a = bilinear_place(texture, first_level, u, v);
  Place b = a;
  hn::Vec<Ints> stride_a = hn::Set(Ints(), texture.view(first_level).stride());
  hn::Vec<Ints> stride_b = stride_a;
  // Neighbouring fragments mostly lie on the same two levels.
  for (int level = first_level + 1; level <= last_level; ++level) {
    const Place place = bilinear_place(texture, level, u, v);
    const auto strides = hn::Set(Ints(), texture.view(level).stride());
    const Vec number = hn::Set(d, static_cast<float>(level));
    const auto merge = [&](Place& into, hn::Vec<Ints>& into_stride, auto mask) HWY_ATTR {
      const auto int_mask = hn::RebindMask(Ints(), mask);
      into.offset = hn::IfThenElse(int_mask, place.offset, into.offset);
      into.right = hn::IfThenElse(mask, place.right, into.right);
      into.bottom = hn::IfThenElse(mask, place.bottom, into.bottom);
      into_stride = hn::IfThenElse(int_mask, strides, into_stride);
    };
    merge(a, stride_a, hn::Eq(fine, number));
    merge(b, stride_b, hn::Eq(coarse, number));
  }
  PlaceArrays fine_place, coarse_place;
  fine_place.store(a);
  coarse_place.store(b);
  hn::Store(stride_a, Ints(), stride[0]);
  hn::Store(stride_b, Ints(), stride[1]);
  alignas(64) float between[kLanes];
  hn::Store(hn::Sub(lod, fine), d, between);
  const Texel* texels = texture.view(0).row(0);
  for (int k = 0; k < count; ++k) {
    write(mix(bilinear(texels, stride[0][k], fine_place, k),
              bilinear(texels, stride[1][k], coarse_place, k), between[k]),
          out + k);
  }
}

void look_up(const Texture& texture, const Batch& batch, int texcoord, LinearRgba* out) {
  const Floats d;
  const float* us = batch.attribute[static_cast<std::size_t>(texcoord)];
  const float* vs = batch.attribute[static_cast<std::size_t>(texcoord) + 1];
  for (int i = 0; i < batch.size; i += kLanes) {
    const Vec u = wrapped(hn::Load(d, us + i), texture.wrap_u);
    const Vec v = wrapped(hn::Load(d, vs + i), texture.wrap_v);
    const int count = std::min(kLanes, batch.size - i);
    if (texture.filter == Filter::kNearest) {
      nearest_vector(texture, u, v, count, out + i);
    } else if (texture.filter == Filter::kBilinear) {
      bilinear_vector(texture, u, v, count, out + i);
    } else {
      trilinear_vector(texture, u, v, level_of_detail(texture, batch, i), count, out + i);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(look_up);

void look_up(const Texture& texture, const Batch& batch, int texcoord, LinearRgba* out) {
  HWY_DYNAMIC_DISPATCH(look_up)(texture, batch, texcoord, out);
}

}  // namespace kinescope
#endif
