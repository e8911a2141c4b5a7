// Depth-tests finished fragments, as the small triangles leave them.
// Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_KERNELS_MERGE_FRAGMENTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_MERGE_FRAGMENTS_INL_H_
#undef KINESCOPE_RASTER_KERNELS_MERGE_FRAGMENTS_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_MERGE_FRAGMENTS_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "raster/kernels/small_triangles.h"
#include "raster/tile.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A pixel's samples are tested four at a time, whatever the vectors' length.
using F4 = hn::CappedTag<float, 4>;
using U4 = hn::RebindToUnsigned<F4>;

/// Samples [at, at + lanes) against one triangle; an infinite depth never wins.
HWY_INLINE void test_samples(hn::Vec<F4> z, std::uint32_t id, std::size_t at, TileBuffer& tile) {
  const F4 f;
  const U4 u;
  float* const depth = tile.depth.data() + at;
  std::uint32_t* const shown = tile.id.data() + at;
  const auto old_z = hn::Load(f, depth);
  const auto old_id = hn::Load(u, shown), new_id = hn::Set(u, id);
  const auto earlier = hn::RebindMask(f, hn::Lt(new_id, old_id));
  const auto wins = hn::Or(hn::Lt(z, old_z), hn::And(hn::Eq(z, old_z), earlier));
  hn::Store(hn::IfThenElse(wins, z, old_z), f, depth);
  hn::Store(hn::IfThenElse(hn::RebindMask(u, wins), new_id, old_id), u, shown);
}

/// Samples s to s + 3 of fragments [k, end), at most four of them.
HWY_INLINE void merge_four(const FragmentBuffer& from, std::size_t k, std::size_t end,
                           std::size_t s, TileBuffer& tile) {
  const F4 f;
  const auto samples = static_cast<std::size_t>(tile.samples);
#if HWY_TARGET == HWY_SCALAR  // has no vectors of four
  for (std::size_t i = k; i < end; ++i) {
    for (std::size_t j = s; j < s + 4; ++j) {
      test_samples(hn::Set(f, from.depth[j][i]), from.id[i], from.pixel[i] * samples + j, tile);
    }
  }
#else
  const hn::RepartitionToWide<F4> pairs;
  const auto load = [&](std::size_t j) HWY_ATTR { return hn::LoadU(f, from.depth[j].data() + k); };
  const auto r0 = load(s), r1 = load(s + 1), r2 = load(s + 2), r3 = load(s + 3);
  const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(f, r0, r1));
  const auto low23 = hn::BitCast(pairs, hn::InterleaveLower(f, r2, r3));
  const auto high01 = hn::BitCast(pairs, hn::InterleaveUpper(f, r0, r1));
  const auto high23 = hn::BitCast(pairs, hn::InterleaveUpper(f, r2, r3));
  const auto test = [&](std::size_t i, auto z) HWY_ATTR {
    if (i < end) test_samples(hn::BitCast(f, z), from.id[i], from.pixel[i] * samples + s, tile);
  };
  test(k, hn::InterleaveLower(pairs, low01, low23));
  test(k + 1, hn::InterleaveUpper(pairs, low01, low23));
  test(k + 2, hn::InterleaveLower(pairs, high01, high23));
  test(k + 3, hn::InterleaveUpper(pairs, high01, high23));
#endif
}

/// A pixel of one sample. Depths are not negative, so that their bits compare as they do; written
/// either way, since a store costs less than a branch that nobody can predict.
HWY_INLINE void test_pixel(float z, std::uint32_t id, std::size_t at, float* depth,
                           std::uint32_t* shown) {
  const auto key = [](float of, std::uint32_t triangle) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(of)} << 32 | triangle;
  };
  const std::uint64_t least = std::min(key(z, id), key(depth[at], shown[at]));
  depth[at] = std::bit_cast<float>(static_cast<std::uint32_t>(least >> 32));
  shown[at] = static_cast<std::uint32_t>(least);
}

/// Pixels of one sample.
HWY_INLINE void merge_pixels(const FragmentBuffer& from, TileBuffer& tile) {
  float* const depth = tile.depth.data();
  std::uint32_t* const id = tile.id.data();
  for (std::size_t i = 0; i < from.size; ++i) {
    test_pixel(from.depth[0][i], from.id[i], from.pixel[i], depth, id);
  }
}

/// Empties the buffer.
template <std::size_t kSamples>
HWY_NOINLINE void merge_fragments(FragmentBuffer& from, TileBuffer& tile) {
  static_assert(FragmentBuffer::kCapacity % 4 == 0);
  if constexpr (kSamples == 1) {
    merge_pixels(from, tile);
  } else {
    for (std::size_t k = 0; k < from.size; k += 4) {
      const std::size_t end = std::min(from.size, k + 4);
      for (std::size_t s = 0; s < kSamples; s += 4) merge_four(from, k, end, s, tile);
    }
  }
  from.size = 0;
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_MERGE_FRAGMENTS_INL_H_
