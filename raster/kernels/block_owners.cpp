#include "raster/kernels/block_owners.h"

#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/block_owners.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/first_samples-inl.h"
#include "raster/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using U = hn::CappedTag<std::uint32_t, 8>;
using BlockIds = std::array<std::uint32_t, TileBuffer::kBlockPixels>;

/// @param row  the block's first sample
/// @return whether all samples of each pixel agree
template <int kSamples>
HWY_INLINE bool load_ids(const std::uint32_t* row, int stride, BlockIds& ids) {
  constexpr std::size_t kSide = TileBuffer::kBlock;
  const U u;
  const auto all = first_lanes(u, hn::Lanes(u));
  for (std::size_t r = 0; r < kSide; ++r, row += stride) {
    for (std::size_t x = 0; x < kSide; x += hn::Lanes(u)) {
      bool agree = true;
      const auto id = first_samples<kSamples>(u, row + x * kSamples, all, agree);
      if (!agree) return false;
      hn::Store(id, u, ids.data() + r * kSide + x);
    }
  }
  return true;
}

/// The pixels that show a triangle.
HWY_INLINE std::uint64_t pixels_of(std::uint32_t id, const BlockIds& ids) {
  const U u;
  const auto wanted = hn::Set(u, id);
  std::uint64_t pixels = 0;
  for (std::size_t k = 0; k < ids.size(); k += hn::Lanes(u)) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(u, hn::Eq(hn::Load(u, ids.data() + k), wanted), bits);
    pixels |= std::uint64_t{bits[0]} << k;
  }
  return pixels;
}

bool FindOwners(const TileBuffer& tile, int block, BlockOwners& out) {
  const PixelRect rect = tile.block_rect(block);
  const int first = (rect.y0 - tile.rect.y0) * tile.stride + rect.x0 - tile.rect.x0;
  const std::uint32_t* const row = tile.id.data() + first * tile.samples;
  const int stride = tile.stride * tile.samples;
  HWY_ALIGN BlockIds ids;
  const bool agree = tile.samples == 1   ? load_ids<1>(row, stride, ids)
                     : tile.samples == 4 ? load_ids<4>(row, stride, ids)
                                         : load_ids<8>(row, stride, ids);
  if (!agree) return false;
  out.size = 0;
  for (std::uint64_t left = ~std::uint64_t{0}; left != 0; left &= ~out.pixels[out.size++]) {
    const std::uint32_t id = ids[static_cast<std::size_t>(std::countr_zero(left))];
    if (id == TileBuffer::kNothing || out.size == BlockOwners::kMax) return false;
    out.id[out.size] = id;
    out.pixels[out.size] = pixels_of(id, ids);
  }
  return true;
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(FindOwners);

bool find_owners(const TileBuffer& tile, int block, BlockOwners& out) {
  if (tile.is_stored(block)) return HWY_DYNAMIC_DISPATCH(FindOwners)(tile, block, out);
  const TriangleRecord* const shown = tile.shown[static_cast<std::size_t>(block)];
  if (shown == nullptr) return false;
  out.size = 1;
  out.id[0] = shown->id;
  out.pixels[0] = ~std::uint64_t{0};
  return true;
}

}  // namespace kinescope
#endif
