#include "raster/kernels/blend_samples.h"

#include <algorithm>
#include <bit>

#ifndef KINESCOPE_BLEND_SAMPLES_ONCE
#define KINESCOPE_BLEND_SAMPLES_ONCE
namespace kinescope {
namespace {

/// Some fragments of one mode.
struct Slice {
  const std::uint32_t* xy;
  const std::uint8_t* samples;
  const LinearRgba* colour;
  std::size_t size;
};

}  // namespace
}  // namespace kinescope
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/blend_samples.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/blend_colour-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Where a pixel of the target lies in the tile, or in rows of it.
struct Places {
  HWY_INLINE Places(const PixelRect& rows, const TileBuffer& tile)
      : x0(static_cast<std::uint32_t>(tile.rect.x0)),
        y0(static_cast<std::uint32_t>(rows.y0)),
        stride(static_cast<std::uint32_t>(tile.stride)) {}
  HWY_INLINE std::size_t operator()(std::uint32_t xy) const {
    return ((xy >> 16) - y0) * stride + (xy & 0xffff) - x0;
  }
  std::uint32_t x0, y0, stride;
};

/// So many pixels side by side are blended without a look at each.
constexpr std::size_t kRun = 8;
HWY_INLINE bool is_run(const std::uint32_t* xy) {
  const hn::CappedTag<std::uint32_t, kRun> u;
  for (std::size_t k = 0; k < kRun; k += hn::Lanes(u)) {
    const auto wanted = lanes_from(u, xy[0] + static_cast<std::uint32_t>(k));
    if (!hn::AllTrue(u, hn::Eq(hn::LoadU(u, xy + k), wanted))) return false;
  }
  return true;
}

template <BlendMode kMode>
HWY_INLINE void blend_pixels(const Slice& from, const Places& place, TileColours& to) {
  LinearRgba* const samples = to.samples.data();
  std::uint8_t* const touched = to.touched.data();
  for (std::size_t i = 0; i < from.size; ++i) {
    const std::size_t at = place(from.xy[i]);
#if HWY_TARGET != HWY_SCALAR
    if (i + kRun <= from.size && is_run(from.xy + i)) {
      const Two two;
      for (std::size_t k = 0; k < kRun; k += hn::Lanes(two) / 4) {
        blend_two<kMode>(hn::LoadU(two, &from.colour[i + k].r), samples + at + k);
      }
      std::fill_n(touched + at, kRun, std::uint8_t{1});
      i += kRun - 1;
      continue;
    }
#endif
    touched[at] = 1;
    blend_one<kMode>(from.colour[i], samples[at]);
  }
}

template <BlendMode kMode, std::size_t kSamples>
HWY_INLINE void blend_sampled(const Slice& from, const Places& place, TileColours& to) {
  for (std::size_t i = 0; i < from.size; ++i) {
    const std::size_t pixel = place(from.xy[i]);
    to.touched[pixel] = 1;
    LinearRgba* const samples = to.samples.data() + pixel * kSamples;
    std::uint32_t bits = from.samples[i];
#if HWY_TARGET != HWY_SCALAR
    if (bits == (1u << kSamples) - 1) {
      const Two two;
      const auto source = hn::LoadDup128(two, &from.colour[i].r);
      for (std::size_t s = 0; s < kSamples; s += hn::Lanes(two) / 4) {
        blend_two<kMode>(source, samples + s);
      }
      continue;
    }
#endif
    for (; bits != 0; bits &= bits - 1) {
      blend_one<kMode>(from.colour[i], samples[std::countr_zero(bits)]);
    }
  }
}

template <BlendMode kMode>
HWY_INLINE void blend_all(const Slice& from, const TileBuffer& tile, TileColours& to) {
  const Places place(tile.rect, tile);
  switch (tile.samples) {
    case 1:
      return blend_pixels<kMode>(from, place, to);
    case 4:
      return blend_sampled<kMode, 4>(from, place, to);
    default:
      return blend_sampled<kMode, 8>(from, place, to);
  }
}

void BlendInOrder(BlendMode mode, const Slice& from, const TileBuffer& tile, TileColours& to) {
  with_mode(mode,
            [&](auto constant) HWY_ATTR { blend_all<decltype(constant)::value>(from, tile, to); });
}

/// Few keys by insertion.
HWY_INLINE void sort_keys(std::uint64_t* keys, std::size_t size) {
  constexpr std::size_t kFew = 24;
  if (size > kFew) return std::sort(keys, keys + size);
  for (std::size_t i = 1; i < size; ++i) {
    const std::uint64_t key = keys[i];
    std::size_t k = i;
    for (; k > 0 && keys[k - 1] > key; --k) keys[k] = keys[k - 1];
    keys[k] = key;
  }
}

#if HWY_TARGET != HWY_SCALAR
/// Whether the order of one sample serves them all.
template <std::size_t kSamples>
HWY_INLINE bool serves_all(const float* depths, const std::uint64_t* keys, std::size_t size) {
  const hn::CappedTag<float, kSamples> f;
  auto in_order = first_lanes(f, hn::Lanes(f));
  for (std::size_t k = 1; k < size; ++k) {
    const std::uint64_t i = keys[k - 1] & 0xffffffffu, j = keys[k] & 0xffffffffu;
    for (std::size_t s = 0; s < kSamples; s += hn::Lanes(f)) {
      const auto far = hn::LoadU(f, depths + i * kSamples + s);
      const auto near = hn::LoadU(f, depths + j * kSamples + s);
      in_order = hn::And(in_order, i < j ? hn::Ge(far, near) : hn::Gt(far, near));
    }
  }
  return hn::AllTrue(f, in_order);
}

template <std::size_t kSamples>
HWY_INLINE void blend_all_samples(const BlendMode* modes, const OrderedFragments& fragments,
                                  const LinearRgba* colours, const std::uint64_t* keys,
                                  std::size_t size, LinearRgba* samples) {
  AllBelow<kSamples> below(samples);
  for (std::size_t k = 0; k < size; ++k) {
    const auto i = static_cast<std::size_t>(keys[k] & 0xffffffffu);
    with_mode(modes[i], [&](auto mode) HWY_ATTR {
      below.template lay<decltype(mode)::value>(colours[i], fragments.samples[i]);
    });
  }
  below.store(samples);
}
#endif

/// One pixel: sorts and blends its fragments, sample by sample.
/// @param keys  room for one a fragment, whose low halves are the fragments
template <std::size_t kSamples>
HWY_INLINE void blend_pixel_by_depth(const BlendMode* modes, const OrderedFragments& fragments,
                                     const LinearRgba* colours, std::uint64_t* keys,
                                     std::size_t size, LinearRgba* samples) {
  const float* const depths = fragments.depth.data();
  const std::uint8_t* const covered = fragments.samples.data();
  for (std::size_t s = 0; s < kSamples; ++s) {
    std::uint64_t before = 0;
    bool is_sorted = true;  // often: one order serves all samples, or there is one fragment
    for (std::size_t k = 0; k < size; ++k) {
      // Depths are not negative, so their bits rise as they do; the farthest comes first. Where the
      // triangle does not cover the sample the depth is not looked at. Equal ones keep their order.
      const std::uint64_t i = keys[k] & 0xffffffffu;
      const float depth = depths[static_cast<std::size_t>(i) * kSamples + s];
      const std::uint64_t key = std::uint64_t{~std::bit_cast<std::uint32_t>(depth)} << 32 | i;
      keys[k] = key;
      is_sorted &= key >= before;
      before = key;
    }
    if (!is_sorted) sort_keys(keys, size);
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kSamples > 1) {
      if (s == 0 && serves_all<kSamples>(depths, keys, size)) {
        return blend_all_samples<kSamples>(modes, fragments, colours, keys, size, samples);
      }
    }
#endif
    Below below(samples[s]);
    for (std::size_t k = 0; k < size; ++k) {
      const auto i = static_cast<std::size_t>(keys[k] & 0xffffffffu);
      if (kSamples > 1 && (covered[i] >> s & 1) == 0) continue;
      with_mode(modes[i],
                [&](auto mode) HWY_ATTR { below.template lay<decltype(mode)::value>(colours[i]); });
    }
    below.store(samples[s]);
  }
}

/// @param first_pixel  of the band, in the tile
template <std::size_t kSamples>
HWY_INLINE void blend_pixels_by_depth(const BlendMode* modes, const OrderedFragments& fragments,
                                      const LinearRgba* colours, std::size_t first_pixel,
                                      DepthOrder& order, TileColours& to) {
  for (std::size_t p = 0; p + 1 < order.first.size(); ++p) {
    const std::size_t first = order.first[p], size = order.first[p + 1] - first;
    if (size == 0) continue;
    to.touched[first_pixel + p] = 1;
    for (std::size_t k = 0; k < size; ++k) order.keys[k] = order.fragment[first + k];
    blend_pixel_by_depth<kSamples>(modes, fragments, colours, order.keys.data(), size,
                                   &to.samples[(first_pixel + p) * kSamples]);
  }
}

/// A stable counting sort by pixel.
HWY_INLINE void sort_by_pixel(const OrderedFragments& fragments, const Places& place,
                              std::size_t pixels, DepthOrder& order) {
  const auto size = static_cast<std::size_t>(fragments.size);
  // One entry further than the pixel: after the second pass each holds where its pixel begins.
  order.first.assign(pixels + 2, 0);
  if (order.fragment.size() < size) order.fragment.resize(size);
  const std::uint32_t* const xy = fragments.xy.data();
  std::uint32_t* const first = order.first.data();
  for (std::size_t i = 0; i < size; ++i) ++first[place(xy[i]) + 2];
  std::uint32_t most = 0;
  for (std::size_t p = 2; p < pixels + 2; ++p) {
    most = std::max(most, first[p]);
    first[p] += first[p - 1];
  }
  if (order.keys.size() < most) order.keys.resize(most);
  std::uint32_t* const fragment = order.fragment.data();
  for (std::size_t i = 0; i < size; ++i) {
    fragment[first[place(xy[i]) + 1]++] = static_cast<std::uint32_t>(i);
  }
  order.first.pop_back();
}

void BlendByDepth(const BlendMode* modes, const OrderedFragments& fragments,
                  const LinearRgba* colours, const PixelRect& band, const TileBuffer& tile,
                  DepthOrder& order, TileColours& to) {
  const Places place(band, tile);
  const auto rows = static_cast<std::size_t>(band.y1 - band.y0);
  sort_by_pixel(fragments, place, rows * place.stride, order);
  const auto first = static_cast<std::size_t>(band.y0 - tile.rect.y0) * place.stride;
  switch (tile.samples) {
    case 1:
      return blend_pixels_by_depth<1>(modes, fragments, colours, first, order, to);
    case 4:
      return blend_pixels_by_depth<4>(modes, fragments, colours, first, order, to);
    default:
      return blend_pixels_by_depth<8>(modes, fragments, colours, first, order, to);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(BlendInOrder);
HWY_EXPORT(BlendByDepth);

void blend_in_order(BlendMode mode, const OrderedFragments& fragments, int first,
                    std::span<const LinearRgba> colours, const TileBuffer& tile, TileColours& to) {
  const Slice slice = {fragments.xy.data() + first, fragments.samples.data() + first,
                       colours.data(), colours.size()};
  HWY_DYNAMIC_DISPATCH(BlendInOrder)(mode, slice, tile, to);
}

void blend_by_depth(std::span<const BlendMode> modes, const OrderedFragments& fragments,
                    std::span<const LinearRgba> colours, const PixelRect& band,
                    const TileBuffer& tile, DepthOrder& order, TileColours& to) {
  HWY_DYNAMIC_DISPATCH(BlendByDepth)
  (modes.data(), fragments, colours.data(), band, tile, order, to);
}

}  // namespace kinescope
#endif
