#include "raster/kernels/gather.h"

#include <algorithm>
#include <array>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/gather.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/first_samples-inl.h"
#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/pack-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using U = hn::CappedTag<std::uint32_t, 8>;

/// One pixel with several triangles among its samples: each of them once, in their order.
template <int kSamples>
HWY_INLINE void gather_pixel(const std::uint32_t* ids, std::uint32_t xy, VisibleFragments& out) {
  const hn::CappedTag<std::uint32_t, kSamples> u;
  const auto same_as = [&](std::uint32_t id) HWY_ATTR {
    std::uint32_t bits = 0;
    HWY_UNROLL(8)
    for (std::size_t s = 0; s < kSamples; s += hn::Lanes(u)) {
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(u, hn::Eq(hn::Load(u, ids + s), hn::Set(u, id)), bytes);
      bits |= std::uint32_t{bytes[0]} << s;
    }
    return bits;
  };
  auto n = static_cast<std::size_t>(out.size);
  for (std::uint32_t left = (1u << kSamples) - 1; left != 0;) {
    const std::uint32_t id = ids[std::countr_zero(left)];
    const std::uint32_t same = same_as(id);
    out.id[n] = id;
    out.xy[n] = xy;
    out.weight[n] = static_cast<std::uint8_t>(std::popcount(same));
    n += id != TileBuffer::kNothing ? 1 : 0;
    left &= ~same;
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
  const auto sample = hn::And(lane_numbers(u), hn::Set(u, 3));
  const auto pixel = hn::ShiftRight<2>(lane_numbers(u));
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
    const auto shown = hn::AndNot(hidden, first_lanes(u, 4 * (within - k)));
    const auto weight =
        hn::Add(hn::Add(one, hn::IfThenElse(same1, one, zero)),
                hn::Add(hn::IfThenElse(same2, one, zero), hn::IfThenElse(same3, one, zero)));
    const auto place = hn::Add(pixel, hn::Set(u, xy + static_cast<std::uint32_t>(k)));
    const Packer<U> pack(shown);
    pack.store(id, out.id.data() + n);
    pack.store(place, out.xy.data() + n);
    hn::StoreU(hn::DemoteTo(u8, hn::BitCast(i, pack(weight))), u8, out.weight.data() + n);
    n += pack.count();
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
  const hn::Rebind<std::uint8_t, U> u8;
  if (samples > 1) {
    hn::StoreU(hn::Set(u8, static_cast<std::uint8_t>(samples)), u8, out.weight.data() + n);
  }
  if (hn::AllTrue(u, shown)) {
    hn::StoreU(id, u, out.id.data() + n);
    hn::StoreU(lanes_from(u, xy), u, out.xy.data() + n);
    out.size += static_cast<int>(hn::Lanes(u));
    return;
  }
  const Packer<U> pack(shown);
  pack.store(id, out.id.data() + n);
  pack.store(lanes_from(u, xy), out.xy.data() + n);
  out.size += static_cast<int>(pack.count());
}

/// A block that shows one triangle. Whole rows are stored, then those beyond the target dropped.
HWY_INLINE void gather_plane(const PixelRect& rect, std::uint32_t id, int samples,
                             VisibleFragments& out) {
  const U u;
  const hn::Rebind<std::uint8_t, U> u8;
  const int lanes = static_cast<int>(hn::Lanes(u)), width = rect.x1 - rect.x0;
  const auto ids = hn::Set(u, id);
  const auto weights = hn::Set(u8, static_cast<std::uint8_t>(samples));
  for (int y = rect.y0; y < rect.y1; ++y) {
    const std::uint32_t xy =
        static_cast<std::uint32_t>(y) << 16 | static_cast<std::uint32_t>(rect.x0);
    for (int x = 0; x < width; x += lanes) {
      const auto n = static_cast<std::size_t>(out.size + x);
      hn::StoreU(ids, u, out.id.data() + n);
      hn::StoreU(lanes_from(u, xy + static_cast<std::uint32_t>(x)), u, out.xy.data() + n);
      hn::StoreU(weights, u8, out.weight.data() + n);
    }
    out.size += width;
  }
}

/// A block whose samples are stored. @return whether each pixel shows one triangle
template <int kSamples>
HWY_INLINE bool gather_stored(const TileBuffer& tile, const PixelRect& rect,
                              VisibleFragments& out) {
  const U u;
  const int lanes = static_cast<int>(hn::Lanes(u)), width = rect.x1 - rect.x0;
  const int before = out.size;
  bool whole = true;
  for (int y = rect.y0; y < rect.y1; ++y) {
    const int first = (y - tile.rect.y0) * tile.stride + rect.x0 - tile.rect.x0;
    const std::uint32_t* const row = tile.id.data() + first * kSamples;
    const std::uint32_t xy =
        static_cast<std::uint32_t>(y) << 16 | static_cast<std::uint32_t>(rect.x0);
    for (int x = 0; x < width; x += lanes) {
      const auto within = first_lanes(u, static_cast<std::size_t>(width - x));
      bool agree = true;
      const auto id = first_samples<kSamples>(u, row + x * kSamples, within, agree);
      if (agree) {
        append(id, within, xy + static_cast<std::uint32_t>(x), kSamples, out);
        continue;
      }
      whole = false;
      gather_pixels<kSamples>(row + x * kSamples, std::min(lanes, width - x),
                              xy + static_cast<std::uint32_t>(x), out);
    }
  }
  return whole && out.size - before == width * (rect.y1 - rect.y0);
}

template <int kSamples>
HWY_INLINE std::uint64_t gather_blocks(const TileBuffer& tile, std::uint64_t blocks,
                                       VisibleFragments& out) {
  constexpr int kSide = TileBuffer::kBlock;
  out.size = out.blocks = 0;
  for (; blocks != 0 && out.size <= VisibleFragments::kEnough; blocks &= blocks - 1) {
    const int block = std::countr_zero(blocks);
    const auto at = static_cast<std::size_t>(out.blocks++);
    out.block[at] = block;
    out.block_first[at] = out.size;
    out.block_is_whole[at] = false;
    const TriangleRecord* const shown = tile.shown[static_cast<std::size_t>(block)];
    if (!tile.is_stored(block) && shown == nullptr) continue;
    const PixelRect rect = tile.block_rect(block);
    if (rect.empty()) continue;
    bool whole = true;
    if (tile.is_stored(block)) {
      whole = gather_stored<kSamples>(tile, rect, out);
    } else {
      gather_plane(rect, shown->id, kSamples, out);
    }
    out.block_is_whole[at] = whole && rect.x1 - rect.x0 == kSide && rect.y1 - rect.y0 == kSide;
  }
  out.block_first[static_cast<std::size_t>(out.blocks)] = out.size;
  return blocks;
}

std::uint64_t Gather(const TileBuffer& tile, std::uint64_t blocks, VisibleFragments& out) {
  switch (tile.samples) {
    case 1:
      return gather_blocks<1>(tile, blocks, out);
    case 4:
      return gather_blocks<4>(tile, blocks, out);
    default:
      return gather_blocks<8>(tile, blocks, out);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(Gather);

std::uint64_t gather_visible(const TileBuffer& tile, std::uint64_t blocks, VisibleFragments& out) {
  return HWY_DYNAMIC_DISPATCH(Gather)(tile, blocks, out);
}

}  // namespace kinescope
#endif
