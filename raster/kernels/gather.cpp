#include "raster/kernels/gather.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/gather.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using U = hn::CappedTag<std::uint32_t, 8>;

/// One pixel with several triangles among its samples.
HWY_INLINE void gather_pixel(const TileBuffer& tile, std::size_t at, std::uint32_t xy,
                             VisibleFragments& out) {
  const auto plane = static_cast<std::size_t>(tile.plane);
  const auto first = static_cast<std::size_t>(out.size);
  std::size_t end = first;
  for (int s = 0; s < tile.samples; ++s) {
    const std::uint32_t id = tile.id[at + static_cast<std::size_t>(s) * plane];
    if (id == TileBuffer::kNothing) continue;
    std::size_t i = first;
    while (i < end && out.id[i] != id) ++i;
    if (i < end) {
      ++out.weight[i];
      continue;
    }
    out.id[i] = id;
    out.xy[i] = xy;
    out.weight[i] = 1;
    ++end;
  }
  out.size = static_cast<int>(end);
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

void Gather(const TileBuffer& tile, VisibleFragments& out) {
  const U u;
  const int lanes = static_cast<int>(hn::Lanes(u));
  const int width = tile.rect.x1 - tile.rect.x0, height = tile.rect.y1 - tile.rect.y0;
  for (int r = 0; r < height; ++r) {
    out.row_first[static_cast<std::size_t>(r)] = out.size;
    const auto row = static_cast<std::size_t>(r) * static_cast<std::size_t>(tile.stride);
    const std::uint32_t xy = static_cast<std::uint32_t>(tile.rect.y0 + r) << 16 |
                             static_cast<std::uint32_t>(tile.rect.x0);
    for (int x = 0; x < width; x += lanes) {
      const std::size_t at = row + static_cast<std::size_t>(x);
      const auto within = hn::FirstN(u, static_cast<std::size_t>(width - x));
      const auto id = hn::Load(u, tile.id.data() + at);
      auto differ = hn::Zero(u);
      for (int s = 1; s < tile.samples; ++s) {
        const auto other =
            hn::Load(u, tile.id.data() + at +
                            static_cast<std::size_t>(s) * static_cast<std::size_t>(tile.plane));
        differ = hn::Or(differ, hn::Xor(id, other));
      }
      if (tile.samples == 1 || hn::AllFalse(u, hn::And(within, hn::Ne(differ, hn::Zero(u))))) {
        append(id, within, xy + static_cast<std::uint32_t>(x), tile.samples, out);
        continue;
      }
      for (int k = 0; k < std::min(lanes, width - x); ++k) {
        gather_pixel(tile, at + static_cast<std::size_t>(k), xy + static_cast<std::uint32_t>(x + k),
                     out);
      }
    }
  }
  out.row_first[static_cast<std::size_t>(height)] = out.size;
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(Gather);

void gather_visible(const TileBuffer& tile, VisibleFragments& out) {
  out.size = 0;
  out.reserve(tile.plane * tile.samples);
  HWY_DYNAMIC_DISPATCH(Gather)(tile, out);
}

}  // namespace kinescope
#endif
