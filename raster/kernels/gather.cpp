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
    n += ((before == 0) & (ids[s] != TileBuffer::kNothing)) ? 1 : 0;
  }
  out.size = static_cast<int>(n);
}

#if HWY_TARGET != HWY_SCALAR  // has no vectors of four
/// Pixels [x, x + lanes) of four samples each: as gather_pixel, a vector of samples at a time.
HWY_INLINE void gather_fours(const std::uint32_t* ids, std::size_t within, std::uint32_t xy,
                             VisibleFragments& out) {
  const U u;
  const hn::RebindToSigned<U> i;
  const hn::Rebind<std::uint8_t, U> u8;
  const std::size_t lanes = hn::Lanes(u), pixels = lanes / 4;
  const auto sample = hn::And(hn::Iota(u, 0), hn::Set(u, 3));
  const auto pixel = hn::ShiftRight<2>(hn::Iota(u, 0));
  const auto one = hn::Set(u, 1), zero = hn::Zero(u);
  const auto later = [&](std::uint32_t first)
                         HWY_ATTR { return hn::Gt(sample, hn::Set(u, first - 1)); };
  auto n = static_cast<std::size_t>(out.size);
  for (std::size_t k = 0; k < within; k += pixels) {
    const auto id = hn::Load(u, ids + 4 * k);
    // The samples one, two and three further, counted round in their pixel.
    const auto same1 = hn::Eq(id, hn::Shuffle0321(id));
    const auto same2 = hn::Eq(id, hn::Shuffle1032(id));
    const auto same3 = hn::Eq(id, hn::Shuffle2103(id));
    const auto seen = hn::Or(hn::And(same3, later(1)),
                             hn::Or(hn::And(same2, later(2)), hn::And(same1, later(3))));
    const auto hidden = hn::Or(seen, hn::Eq(id, hn::Set(u, TileBuffer::kNothing)));
    const auto shown = hn::AndNot(hidden, hn::FirstN(u, 4 * (within - k)));
    const auto weight =
        hn::Add(hn::Add(one, hn::IfThenElse(same1, one, zero)),
                hn::Add(hn::IfThenElse(same2, one, zero), hn::IfThenElse(same3, one, zero)));
    const auto place = hn::Add(pixel, hn::Set(u, xy + static_cast<std::uint32_t>(k)));
    hn::StoreU(hn::Compress(id, shown), u, out.id.data() + n);
    hn::StoreU(hn::Compress(place, shown), u, out.xy.data() + n);
    hn::StoreU(hn::DemoteTo(u8, hn::BitCast(i, hn::Compress(weight, shown))), u8,
               out.weight.data() + n);
    n += hn::CountTrue(u, shown);
  }
  out.size = static_cast<int>(n);
}
#endif

/// Pixels [0, count) of a row, whose samples may disagree.
template <int kSamples>
HWY_INLINE void gather_pixels(const std::uint32_t* ids, int count, std::uint32_t xy,
                              VisibleFragments& out) {
#if HWY_TARGET != HWY_SCALAR
  if constexpr (kSamples == 4) {
    gather_fours(ids, static_cast<std::size_t>(count), xy, out);
    return;
  }
#endif
  for (int k = 0; k < count; ++k) {
    gather_pixel<kSamples>(ids + k * kSamples, xy + static_cast<std::uint32_t>(k), out);
  }
}

/// Several pixels, each of which shows one triangle or nothing at all of its samples.
HWY_INLINE void append(hn::Vec<U> id, hn::Mask<U> within, std::uint32_t xy, int samples,
                       VisibleFragments& out) {
  const U u;
  const auto n = static_cast<std::size_t>(out.size);
  const auto shown = hn::And(within, hn::Ne(id, hn::Set(u, TileBuffer::kNothing)));
  if (hn::AllFalse(u, shown)) return;
  hn::StoreU(hn::Compress(id, shown), u, out.id.data() + n);
  hn::StoreU(hn::Compress(hn::Iota(u, xy), shown), u, out.xy.data() + n);
  const hn::Rebind<std::uint8_t, U> u8;
  hn::StoreU(hn::Set(u8, static_cast<std::uint8_t>(samples)), u8, out.weight.data() + n);
  out.size += static_cast<int>(hn::CountTrue(u, shown));
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
    bool whole = true;
    for (int x = 0; x < width; x += lanes) {
      const auto within = hn::FirstN(u, static_cast<std::size_t>(width - x));
      bool agree = true;
      const auto id = first_samples<kSamples>(row + x * kSamples, within, agree);
      if (agree) {
        append(id, within, xy + static_cast<std::uint32_t>(x), kSamples, out);
        continue;
      }
      whole = false;
      gather_pixels<kSamples>(row + x * kSamples, std::min(lanes, width - x),
                              xy + static_cast<std::uint32_t>(x), out);
    }
    const auto at = static_cast<std::size_t>(r);
    out.row_is_whole[at] = whole && out.size - out.row_first[at] == width;
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
