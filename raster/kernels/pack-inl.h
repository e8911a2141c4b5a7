// Moves the lanes that a mask chooses to the front, several vectors with one mask.
// Highway 1.0.3 has Compress for this, but g++ 12 copies its table of 1 KB to the stack at each
// use. Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_KERNELS_PACK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_PACK_INL_H_
#undef KINESCOPE_RASTER_KERNELS_PACK_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_PACK_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>

#include "raster/kernels/pack_table.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The lanes whose bits are set, at most eight.
template <class D>
HWY_INLINE hn::Mask<D> mask_of_bits(D d, std::uint8_t bits) {
  const std::uint8_t bytes[8] = {bits};
  return hn::LoadMaskBits(d, bytes);
}

/// Packs vectors of 32 bits a lane.
template <class D>
class Packer {
  using U = hn::RebindToUnsigned<D>;
  static constexpr bool kHasCompress = HWY_TARGET <= HWY_AVX3 || HWY_TARGET == HWY_SCALAR;

 public:
  HWY_INLINE explicit Packer(hn::Mask<D> chosen) : chosen_(chosen) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(D(), chosen, bits);
    bits_ = bits[0];
    find_lanes();
  }
  HWY_INLINE explicit Packer(std::uint8_t bits) : bits_(bits) {
    if constexpr (kHasCompress) chosen_ = mask_of_bits(D(), bits);
    find_lanes();
  }

  HWY_INLINE std::size_t count() const { return count_; }
  /// Of the first eight lanes.
  HWY_INLINE std::uint8_t bits() const { return bits_; }

  /// The chosen lanes in order, then others.
  template <class V>
  HWY_INLINE V operator()(V v) const {
    const hn::DFromV<V> d;
    if constexpr (kHasCompress) {
      return hn::Compress(v, hn::RebindMask(d, chosen_));
    } else {
      return hn::TableLookupLanes(v, hn::IndicesFromVec(d, lanes_));
    }
  }
  /// Stores a whole vector: what lies behind the chosen lanes is overwritten.
  template <class V>
  HWY_INLINE void store(V v, hn::TFromV<V>* to) const {
    hn::StoreU((*this)(v), hn::DFromV<V>(), to);
  }

 private:
  HWY_INLINE void find_lanes() {
    count_ = static_cast<std::size_t>(std::popcount(bits_));
#if HWY_TARGET != HWY_SCALAR
    if constexpr (!kHasCompress) {
      const hn::Rebind<std::uint8_t, U> u8;
      lanes_ = hn::PromoteTo(U(), hn::LoadU(u8, kChosenLanes[bits_].data()));
    }
#endif
  }

  hn::Mask<D> chosen_;
  std::size_t count_;
  std::uint8_t bits_;
  hn::Vec<U> lanes_;
};

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_PACK_INL_H_
