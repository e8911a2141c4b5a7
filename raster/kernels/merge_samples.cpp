#include "raster/kernels/merge_samples.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/merge_samples.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A pixel's samples are tested four at a time, whatever the vectors' length.
using F = hn::CappedTag<float, 4>;
using U = hn::RebindToUnsigned<F>;

/// Samples [at, at + lanes) against one triangle; an infinite depth never wins.
HWY_INLINE void test_samples(hn::Vec<F> z, std::uint32_t id, std::size_t at, TileBuffer& tile) {
  const F f;
  const U u;
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
HWY_INLINE void merge_four(const SampledChunk& from, std::size_t k, std::size_t end, std::size_t s,
                           TileBuffer& tile) {
  const F f;
  const auto samples = static_cast<std::size_t>(tile.samples);
#if HWY_TARGET == HWY_SCALAR  // has no vectors of four
  for (std::size_t i = k; i < end; ++i) {
    for (std::size_t j = s; j < s + 4; ++j) {
      test_samples(hn::Set(f, from.depth[j][i]), from.id[i], from.pixel[i] * samples + j, tile);
    }
  }
#else
  const hn::RepartitionToWide<F> pairs;
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

void MergeSamples(const ChunkList<SampledChunk>& fragments, TileBuffer& tile) {
  static_assert(SampledChunk::kCapacity % 4 == 0);
  const auto samples = static_cast<std::size_t>(tile.samples);
  for (const SampledChunk* chunk = fragments.first; chunk != nullptr; chunk = chunk->next) {
    const auto size = static_cast<std::size_t>(chunk->size);
    for (std::size_t k = 0; k < size; k += 4) {
      const std::size_t end = std::min(size, k + 4);
      for (std::size_t s = 0; s < samples; s += 4) merge_four(*chunk, k, end, s, tile);
    }
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(MergeSamples);

void merge_samples(const ChunkList<SampledChunk>& fragments, TileBuffer& tile) {
  if (fragments.first == nullptr) return;
  HWY_DYNAMIC_DISPATCH(MergeSamples)(fragments, tile);
}

}  // namespace kinescope
#endif
