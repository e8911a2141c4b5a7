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
  hn::Vec<Ints> stride;
  Vec right, bottom;
};

/// The same for the lanes of a vector, in memory, with what the level as a whole is weighted by.
struct PlaceArrays {
  alignas(64) std::int32_t offset[kLanes];
  alignas(64) std::int32_t stride[kLanes];
  alignas(64) float left[kLanes];
  alignas(64) float right[kLanes];
  alignas(64) float bottom[kLanes];

  HWY_INLINE PlaceArrays(const Place& place, Vec weight) {
    const Floats d;
    hn::Store(place.offset, Ints(), offset);
    hn::Store(place.stride, Ints(), stride);
    const Vec right_part = hn::Mul(place.right, weight);
    hn::Store(right_part, d, right);
    hn::Store(hn::Sub(weight, right_part), d, left);
    hn::Store(place.bottom, d, bottom);
  }

  HWY_INLINE Pair look_up(const Texel* texels, int k) const {
    const Texel* top = texels + offset[k];
    return weighted(top, top + stride[k], bottom[k], left[k], right[k]);
  }
};

/// Texels hold 65535 for 1.
constexpr float kUnit = 1.0f / 65535.0f;

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

/// Whole numbers from 0 to 2^22, without the checks of a general conversion.
HWY_INLINE hn::Vec<Ints> to_ints(Vec whole) {
  const Vec shifter = hn::Set(Floats(), 8388608.0f);  // 2^23, whose last binary place is 1
  return hn::Sub(hn::BitCast(Ints(), hn::Add(whole, shifter)), hn::BitCast(Ints(), shifter));
}

HWY_INLINE hn::Vec<Ints> offsets(const Texture& texture, int level, Vec x, Vec y) {
  const Ints di;
  const Texture::Level picture = texture.view(level);
  const auto base = static_cast<std::int32_t>(picture.row(0) - texture.view(0).row(0));
  const auto row = hn::Mul(to_ints(y), hn::Set(di, picture.stride()));
  return hn::Add(hn::Add(row, to_ints(x)), hn::Set(di, base));
}

HWY_INLINE Place bilinear_place(const Texture& texture, int level, Vec u, Vec v) {
  const Texture::Level picture = texture.view(level);
  const Neighbours x = neighbours(u, picture.width(), texture.wrap_u);
  const Neighbours y = neighbours(v, picture.height(), texture.wrap_v);
  return {offsets(texture, level, x.first, y.first), hn::Set(Ints(), picture.stride()), x.fraction,
          y.fraction};
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
  for (int k = 0; k < count; ++k) {
    write(scale(channels(picture.row(0) + offset[k]), kUnit), out + k);
  }
}

HWY_INLINE void bilinear_vector(const Texture& texture, Vec u, Vec v, int count, LinearRgba* out) {
  const PlaceArrays place(bilinear_place(texture, 0, u, v), hn::Set(Floats(), kUnit));
  const Texel* texels = texture.view(0).row(0);
  for (int k = 0; k < count; ++k) write(fold(place.look_up(texels, k)), out + k);
}

/// The places of lanes that lie on different levels. Neighbours seldom do.
HWY_INLINE Place place_by_lane(const Texture& texture, Vec levels, Vec u, Vec v) {
  const Floats d;
  int level = static_cast<int>(hn::GetLane(levels));
  Place place = bilinear_place(texture, level, u, v);
  auto open = hn::Ne(levels, hn::Set(d, static_cast<float>(level)));
  while (!hn::AllFalse(d, open)) {
    level = static_cast<int>(hn::GetLane(hn::MinOfLanes(
        d, hn::IfThenElse(open, levels, hn::Set(d, static_cast<float>(texture.levels()))))));
    const auto here = hn::Eq(levels, hn::Set(d, static_cast<float>(level)));
    const auto int_here = hn::RebindMask(Ints(), here);
    const Place other = bilinear_place(texture, level, u, v);
    place.offset = hn::IfThenElse(int_here, other.offset, place.offset);
    place.stride = hn::IfThenElse(int_here, other.stride, place.stride);
    place.right = hn::IfThenElse(here, other.right, place.right);
    place.bottom = hn::IfThenElse(here, other.bottom, place.bottom);
    open = hn::AndNot(here, open);
  }
  return place;
}

HWY_INLINE void trilinear_vector(const Texture& texture, Vec u, Vec v, Vec lod, int count,
                                 LinearRgba* out) {
  const Floats d;
  const Vec fine_level = hn::Floor(lod);
  const Vec coarse_level = hn::Min(hn::Add(fine_level, hn::Set(d, 1.0f)),
                                   hn::Set(d, static_cast<float>(texture.levels() - 1)));
  const Vec unit = hn::Set(d, kUnit);
  const Vec coarse_weight = hn::Mul(hn::Sub(lod, fine_level), unit);
  const PlaceArrays fine(place_by_lane(texture, fine_level, u, v), hn::Sub(unit, coarse_weight));
  const PlaceArrays coarse(place_by_lane(texture, coarse_level, u, v), coarse_weight);
  const Texel* texels = texture.view(0).row(0);
  for (int k = 0; k < count; ++k) {
    write(fold(add(fine.look_up(texels, k), coarse.look_up(texels, k))), out + k);
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
      const Vec lod = level_of_detail(texture, batch, i);
      if (hn::AllTrue(d, hn::Eq(lod, hn::Zero(d)))) {  // magnified: the same with one level less
        bilinear_vector(texture, u, v, count, out + i);
      } else {
        trilinear_vector(texture, u, v, lod, count, out + i);
      }
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
