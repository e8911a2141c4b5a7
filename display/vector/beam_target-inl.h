// Where the light of strokes and spots goes, and how it is spread. Included once for
// each instruction set, hence the unusual guard.
#if defined(KINESCOPE_DISPLAY_BEAM_TARGET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_DISPLAY_BEAM_TARGET_INL_H_
#undef KINESCOPE_DISPLAY_BEAM_TARGET_INL_H_
#else
#define KINESCOPE_DISPLAY_BEAM_TARGET_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>

#include "display/eight_floats-inl.h"
#include "display/vector/stroke_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// A normal distribution's share below z deviations, less a half; cut at kSpotReach and scaled to
/// reach it: to 8e-6, by a Chebyshev series in z^2.
template <class D>
HWY_INLINE hn::Vec<D> normal_below(D tag, hn::Vec<D> z) {
  const auto number = [&](float v) { return hn::Set(tag, v); };
  z = hn::Min(hn::Max(z, number(-kSpotReach)), number(kSpotReach));
  const hn::Vec<D> q = hn::Mul(z, z);
  hn::Vec<D> p = hn::MulAdd(number(9.56817037e-11f), q, number(-8.02693226e-09f));
  p = hn::MulAdd(p, q, number(3.00281915e-07f));
  p = hn::MulAdd(p, q, number(-6.72111987e-06f));
  p = hn::MulAdd(p, q, number(0.00010251739f));
  p = hn::MulAdd(p, q, number(-0.00115129315f));
  p = hn::MulAdd(p, q, number(0.00992215142f));
  p = hn::MulAdd(p, q, number(-0.0664651646f));
  p = hn::MulAdd(p, q, number(0.398964777f));
  return hn::Mul(p, z);
}
HWY_INLINE Floats normal_below(Floats z) { return normal_below(d, z); }

/// The planes that a mark leaves light on, and how much.
struct LitPlanes {
  std::size_t count = 0;
  std::array<int, kMostBeamPlanes> offset;
  std::array<float, kMostBeamPlanes> weight;

  HWY_INLINE LitPlanes(const BeamTile& tile, const float* weights) {
    for (int p = 0; p < tile.planes; ++p) {
      offset[count] = p * kBeamTilePlane;
      weight[count] = weights[p];
      count += weights[p] != 0;
    }
  }
};

/// Where a mark's light goes.
struct Target {
  BeamTile tile;
  const LitPlanes& planes;
  std::size_t count = planes.count;
  float* first = tile.light + planes.offset[0];
  Floats first_weight = set(planes.weight[0]);

  HWY_INLINE void add(int at, Floats share) const {
    float* const light = first + at;
    hn::StoreU(hn::MulAdd(first_weight, share, hn::LoadU(d, light)), d, light);
    for (std::size_t i = 1; i < count; ++i) {
      float* const other = tile.light + planes.offset[i] + at;
      hn::StoreU(hn::MulAdd(set(planes.weight[i]), share, hn::LoadU(d, other)), d, other);
    }
  }
};

}  // namespace
}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
