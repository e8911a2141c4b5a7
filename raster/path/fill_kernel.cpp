#include "raster/path/fill_kernel.h"

#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/path/fill_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/path/ink-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Windings = hn::RebindToUnsigned<CoverTag>;

/// Each lane becomes the sum of itself and all before it.
HWY_INLINE hn::Vec<Windings> running_sum(hn::Vec<Windings> v) {
#if HWY_TARGET != HWY_SCALAR
  const Windings u;
  v = hn::Add(v, hn::ShiftLeftLanes<1>(u, v));
  v = hn::Add(v, hn::ShiftLeftLanes<2>(u, v));
  if constexpr (kCoverLanes == 8) {
    v = hn::Add(v, hn::ConcatLowerLower(u, hn::Broadcast<3>(v), hn::Zero(u)));
  }
#endif
  return v;
}

/// ExactArea::covered() as a share of a pixel.
HWY_INLINE Cover coverage_of(hn::Vec<Windings> winding, FillRule rule) {
  const CoverTag f;
  const Windings u;
  const hn::RebindToSigned<CoverTag> i;
  const auto whole = hn::Set(i, static_cast<std::int32_t>(ExactArea::kWhole));
  auto area = hn::Abs(hn::BitCast(i, winding));
  if (rule == FillRule::kNonZero) {
    // As unsigned numbers: the least negative one has no counterpart.
    const auto least = hn::Min(hn::BitCast(u, area), hn::BitCast(u, whole));
    area = hn::BitCast(i, least);
  } else {
    const auto rest = hn::And(area, hn::Set(i, 2 * static_cast<int>(ExactArea::kWhole) - 1));
    area = hn::Min(rest, hn::Sub(hn::Add(whole, whole), rest));
  }
  return hn::Mul(hn::ConvertTo(f, area), hn::Set(f, 1.0f / ExactArea::kWhole));
}

template <class Pixel>
class RowFiller {
 public:
  HWY_INLINE RowFiller(const Ink& ink, FillRule rule) : ink_(ink), rule_(rule) {}

  /// Takes the row's blocks that are marked; between them the winding stands still.
  /// @param room  pixels from the first to the end of the picture's row, at least `width`
  HWY_INLINE void fill(const ExactArea::Row& row, int width, int room, Pixel* pixels) const {
    std::uint32_t winding = 0;
    int x = 0;
    for (std::size_t word = 0; word < row.mark_words; ++word) {
      std::uint64_t marks = row.marks[word];
      row.marks[word] = 0;
      for (; marks != 0; marks &= marks - 1) {
        const int block = static_cast<int>(word) * 64 + std::countr_zero(marks);
        const int begin = block * ExactArea::kBlock;
        if (winding != 0 && x < begin) fill_still(winding, x, begin, pixels);
        for (x = begin; x < begin + ExactArea::kBlock; x += kCoverLanes) {
          winding = fill_lanes(winding, row.cells + x, x, width, room, pixels);
        }
      }
    }
    if (winding != 0 && x < width) fill_still(winding, x, width, pixels);
  }

 private:
  HWY_INLINE void fill_still(std::uint32_t winding, int x, int end, Pixel* pixels) const {
    const Cover coverage = coverage_of(hn::Set(Windings(), winding), rule_);
    if (hn::GetLane(coverage) != 0) ink_.lay_evenly(coverage, pixels + x, end - x);
  }

  /// @return the winding after the lanes' last
  HWY_INLINE std::uint32_t fill_lanes(std::uint32_t winding, std::uint32_t* cells, int x, int width,
                                      int room, Pixel* pixels) const {
    const Windings u;
    const auto sum = hn::Add(running_sum(hn::Load(u, cells)), hn::Set(u, winding));
    hn::Store(hn::Zero(u), u, cells);
    const Cover coverage = coverage_of(sum, rule_);
    if (x + kCoverLanes <= width) {
      ink_.lay(coverage, pixels + x);
    } else if (x + kCoverLanes <= room) {
      const CoverTag f;
      const auto inside = hn::Lt(hn::Iota(f, 0.0f), hn::Set(f, static_cast<float>(width - x)));
      ink_.lay(hn::IfThenElseZero(inside, coverage), pixels + x);
    } else if (x < width) {
      lay_part(ink_, coverage, pixels + x, width - x);
    }
    return hn::ExtractLane(sum, kCoverLanes - 1);
  }

  const InkLanes<Pixel> ink_;
  const FillRule rule_;
};

template <class Pixel>
HWY_INLINE void fill_rows(ExactArea& area, FillRule rule, const Ink& ink, int x, int y,
                          Image<Pixel>& picture) {
  const RowFiller<Pixel> filler(ink, rule);
  for (int r = 0; r < area.height(); ++r) {
    filler.fill(area.row(r), area.width(), picture.width() - x, picture.row(y + r) + x);
  }
}

void FillArea8(ExactArea& area, FillRule rule, const Ink& ink, int x, int y,
               Image<Linear8>& picture) {
  fill_rows(area, rule, ink, x, y, picture);
}

void FillAreaFloat(ExactArea& area, FillRule rule, const Ink& ink, int x, int y,
                   Image<LinearRgba>& picture) {
  fill_rows(area, rule, ink, x, y, picture);
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(FillArea8);
HWY_EXPORT(FillAreaFloat);

void fill_area(ExactArea& area, FillRule rule, const Ink& ink, int x, int y,
               Image<Linear8>& picture) {
  HWY_DYNAMIC_DISPATCH(FillArea8)(area, rule, ink, x, y, picture);
}

void fill_area(ExactArea& area, FillRule rule, const Ink& ink, int x, int y,
               Image<LinearRgba>& picture) {
  HWY_DYNAMIC_DISPATCH(FillAreaFloat)(area, rule, ink, x, y, picture);
}

}  // namespace kinescope
#endif
