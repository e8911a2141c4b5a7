// Asking ahead for what bins hold. Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_KERNELS_PREFETCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_PREFETCH_INL_H_
#undef KINESCOPE_RASTER_KERNELS_PREFETCH_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_PREFETCH_INL_H_
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {

/// Asks for a part of a chunk that will be drawn soon: the bins of a frame outgrow the caches.
/// Inlined always: g++ 12 takes a call that only asks ahead for one that does nothing.
template <class Chunk>
HWY_INLINE void prefetch(const Chunk* chunk, std::size_t part, std::size_t parts) {
  if (chunk == nullptr) return;
  constexpr std::size_t kLine = 64, kLines = (sizeof(Chunk) + kLine - 1) / kLine;
  const auto* const bytes = reinterpret_cast<const std::byte*>(chunk);
  for (std::size_t n = kLines * part / parts; n < kLines * (part + 1) / parts; ++n) {
    hwy::Prefetch(bytes + n * kLine);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_PREFETCH_INL_H_
