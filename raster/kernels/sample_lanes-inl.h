// How the samples of a tile's row lie in vectors: those of a pixel side by side.
// Included once for each instruction set, hence the unusual guard.
#if defined(KINESCOPE_RASTER_KERNELS_SAMPLE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_RASTER_KERNELS_SAMPLE_LANES_INL_H_
#undef KINESCOPE_RASTER_KERNELS_SAMPLE_LANES_INL_H_
#else
#define KINESCOPE_RASTER_KERNELS_SAMPLE_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "raster/kernels/set_up-inl.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The lanes of a vector of samples. It holds all samples of kPixels pixels or, where vectors are
/// short, one of the kParts parts of a single pixel.
template <int kSampleCount>
struct SampleLanes {
  static constexpr int kSamples = kSampleCount;
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(F()));
  static constexpr int kPixels = kLanes > kSamples ? kLanes / kSamples : 1;
  static constexpr int kParts = kSamples > kLanes ? kSamples / kLanes : 1;

  VI column;        ///< of each lane's pixel, counted from the first lane's
  VI raw_x, raw_y;  ///< the sample's offset in its pixel, Fixed24_8
  VF x_px, y_px;    ///< the same in pixels
  int part;

  SampleLanes(std::span<const SampleOffset> pattern, int part_index) : part(part_index) {
    const I i;
    const F f;
    alignas(64) std::array<std::int32_t, kLanes> columns, x, y;
    for (int lane = 0; lane < kLanes; ++lane) {
      const auto at = static_cast<std::size_t>(lane);
      const SampleOffset o = pattern[static_cast<std::size_t>((part * kLanes + lane) % kSamples)];
      columns[at] = lane / kSamples;
      x[at] = o.x.raw();
      y[at] = o.y.raw();
    }
    column = hn::Load(i, columns.data());
    raw_x = hn::Load(i, x.data());
    raw_y = hn::Load(i, y.data());
    const VF to_px = hn::Set(f, 1.0f / 256.0f);
    x_px = hn::Mul(hn::ConvertTo(f, raw_x), to_px);
    y_px = hn::Mul(hn::ConvertTo(f, raw_y), to_px);
  }

  /// Where in the tile the vector lies that begins at pixel x, a multiple of kPixels.
  std::size_t place(const TileBuffer& tile, int x, int y) const {
    const int pixel = (y - tile.rect.y0) * tile.stride + x - tile.rect.x0;
    return static_cast<std::size_t>(pixel * kSamples + part * kLanes);
  }
};

/// All parts: together they hold the samples of kPixels pixels.
template <int kSamples>
struct LaneParts {
  using Lanes = SampleLanes<kSamples>;
  Lanes part[Lanes::kParts];

  explicit LaneParts(std::span<const SampleOffset> pattern)
      : LaneParts(pattern, std::make_index_sequence<Lanes::kParts>()) {}

 private:
  template <std::size_t... kIndex>
  LaneParts(std::span<const SampleOffset> pattern, std::index_sequence<kIndex...>)
      : part{Lanes(pattern, static_cast<int>(kIndex))...} {}
};

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // KINESCOPE_RASTER_KERNELS_SAMPLE_LANES_INL_H_
