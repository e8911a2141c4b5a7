#include "raster/kernels/gather.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/gather.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using U = hn::CappedTag<std::uint32_t, 8>;

/// One pixel with several triangles among its samples: each of them once.
template <int kSamples>
HWY_INLINE void gather_pixel(const std::uint32_t* ids, std::uint32_t xy, VisibleFragments& out) {
  auto n = static_cast<std::size_t>(out.size);
  for (int s = 0; s < kSamples; ++s) {
    int before = 0, after = 1;  // samples with the same triangle
    for (int other = 0; other < s; ++other) before += ids[other] == ids[s] ? 1 : 0;
    for (int other = s + 1; other < kSamples; ++other) after += ids[other] == ids[s] ? 1 : 0;
    // Written either way: nobody can predict which samples agree.
    out.id[n] = ids[s];
    out.xy[n] = xy;
    out.weight[n] = static_cast<std::uint8_t>(after);
    n += (before == 0) & (ids[s] != TileBuffer::kNothing) ? 1 : 0;
  }
  out.size = static_cast<int>(n);
}

/// Several pixels, each of which shows one triangle or nothing at all of its samples.
HWY_INLINE void append(hn::Vec<U> id, hn::Mask<U> within, std::uint32_t xy, int samples,
                       VisibleFragments& out) {
  const U u;
  const auto n = static_cast<std::size_t>(out.size);
  const auto shown = hn::And(within, hn::Ne(id, hn::Set(u, TileBuffer::kNothing)));
  hn::StoreU(hn::Compress(id, shown), u, out.id.data() + n);
  hn::StoreU(hn::Compress(hn::Iota(u, xy), shown), u, out.xy.data() + n);
  const std::size_t count = hn::CountTrue(u, shown);
  if (samples > 1) std::fill_n(out.weight.data() + n, count, static_cast<std::uint8_t>(samples));
  out.size += static_cast<int>(count);
}

/// The first sample's triangles of several pixels, and whether all samples of each agree.
template <int kSamples>
HWY_INLINE hn::Vec<U> first_samples(const std::uint32_t* ids, hn::Mask<U> within, bool& agree) {
  const U u;
  if constexpr (kSamples == 1) {
    agree = true;
    return hn::Load(u, ids);
  } else if constexpr (kSamples == 4) {
    hn::Vec<U> a, b, c, d;
    hn::LoadInterleaved4(u, ids, a, b, c, d);
    const auto differ = hn::Or(hn::Or(hn::Xor(a, b), hn::Xor(a, c)), hn::Xor(a, d));
    agree = hn::AllFalse(u, hn::And(within, hn::Ne(differ, hn::Zero(u))));
    return a;
  } else {
    HWY_ALIGN std::array<std::uint32_t, 8> first;
    HWY_ALIGN std::array<std::uint32_t, 8> differ;
    for (std::size_t k = 0; k < hn::Lanes(u); ++k, ids += kSamples) {
      first[k] = ids[0];
      differ[k] = 0;
      for (int s = 1; s < kSamples; ++s) differ[k] |= ids[s] ^ ids[0];
    }
    agree = hn::AllFalse(u, hn::And(within, hn::Ne(hn::Load(u, differ.data()), hn::Zero(u))));
    return hn::Load(u, first.data());
  }
}

template <int kSamples>
HWY_INLINE void gather_all(const TileBuffer& tile, VisibleFragments& out) {
  const U u;
  const int lanes = static_cast<int>(hn::Lanes(u));
  const int width = tile.rect.x1 - tile.rect.x0, height = tile.rect.y1 - tile.rect.y0;
  for (int r = 0; r < height; ++r) {
    out.row_first[static_cast<std::size_t>(r)] = out.size;
    const std::uint32_t* const row = tile.id.data() + r * tile.stride * kSamples;
    const std::uint32_t xy = static_cast<std::uint32_t>(tile.rect.y0 + r) << 16 |
                             static_cast<std::uint32_t>(tile.rect.x0);
    for (int x = 0; x < width; x += lanes) {
      const auto within = hn::FirstN(u, static_cast<std::size_t>(width - x));
      bool agree = true;
      const auto id = first_samples<kSamples>(row + x * kSamples, within, agree);
      if (agree) {
        append(id, within, xy + static_cast<std::uint32_t>(x), kSamples, out);
        continue;
      }
      for (int k = x; k < std::min(x + lanes, width); ++k) {
        gather_pixel<kSamples>(row + k * kSamples, xy + static_cast<std::uint32_t>(k), out);
      }
    }
  }
  out.row_first[static_cast<std::size_t>(height)] = out.size;
}

void Gather(const TileBuffer& tile, VisibleFragments& out) {
  switch (tile.samples) {
    case 1:
      return gather_all<1>(tile, out);
    case 4:
      return gather_all<4>(tile, out);
    default:
      return gather_all<8>(tile, out);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(Gather);

void gather_visible(const TileBuffer& tile, VisibleFragments& out) {
  out.size = 0;
  out.reserve(tile.pixels * tile.samples);
  HWY_DYNAMIC_DISPATCH(Gather)(tile, out);
}

}  // namespace kinescope
#endif
