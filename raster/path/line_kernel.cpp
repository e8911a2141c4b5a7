#include "raster/path/line_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raster/path/stroke_coverage.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/path/line_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/path/ink-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Ramp::at() in lanes.
class RampLanes {
 public:
  HWY_INLINE explicit RampLanes(const Ramp& ramp)
      : RampLanes(ramp.flat, ramp.rate, ramp.bend, ramp.inv_bend, ramp.start) {}
  HWY_INLINE RampLanes(float flat, float rate, float bend, float inv_bend, float start)
      : flat_(hn::Set(CoverTag(), flat)),
        rate_(hn::Set(CoverTag(), rate)),
        bend_(hn::Set(CoverTag(), bend)),
        inv_bend_(hn::Set(CoverTag(), inv_bend)),
        start_(hn::Set(CoverTag(), start)) {}

  HWY_INLINE Cover at(Cover distance) const {
    const CoverTag f;
    const Cover t = hn::Abs(distance);
    const Cover rest =
        hn::Min(hn::Max(hn::Sub(start_, hn::Mul(t, inv_bend_)), hn::Zero(f)), hn::Set(f, 1.0f));
    const Cover curved = hn::Sub(bend_, hn::Mul(bend_, hn::Mul(rest, rest)));
    return hn::CopySign(hn::Add(hn::Mul(hn::Min(t, flat_), rate_), curved), distance);
  }

 private:
  Cover flat_, rate_, bend_, inv_bend_, start_;
};

HWY_INLINE Cover unit(Cover c) {
  return hn::Min(hn::Max(c, hn::Zero(CoverTag())), hn::Set(CoverTag(), 1.0f));
}

/// Edges of an outline within one row, ready for lanes.
struct RowEdges {
  static constexpr std::size_t kCount = OutlineEdges::kCount;
  alignas(32) std::array<double, kCount> left, right, middle;
  alignas(16) std::array<float, kCount> weight, first, flat, rate, bend, inv_bend, start;

  /// edge_in_row() for all four. @return whether any is there
  HWY_INLINE bool find(const OutlineEdges& edges, int y) {
    const hn::CappedTag<double, kCount> d;
    const auto row = hn::Set(d, static_cast<double>(y));
    const auto next = hn::Add(row, hn::Set(d, 1.0));
    const auto half = hn::Set(d, 0.5);
    alignas(32) std::array<double, kCount> height;
    bool any = false;
    for (std::size_t i = 0; i < kCount; i += hn::Lanes(d)) {
      const auto top = hn::LoadU(d, edges.top.data() + i);
      const auto x = hn::LoadU(d, edges.x.data() + i);
      const auto slope = hn::LoadU(d, edges.slope.data() + i);
      const auto from = hn::Max(top, row);
      const auto to = hn::Min(hn::LoadU(d, edges.bottom.data() + i), next);
      const auto x0 = hn::Add(x, hn::Mul(hn::Sub(from, top), slope));
      const auto x1 = hn::Add(x, hn::Mul(hn::Sub(to, top), slope));
      hn::Store(hn::Min(x0, x1), d, left.data() + i);
      hn::Store(hn::Max(x0, x1), d, right.data() + i);
      hn::Store(hn::Mul(half, hn::Add(x0, x1)), d, middle.data() + i);
      hn::Store(hn::Max(hn::Sub(to, from), hn::Zero(d)), d, height.data() + i);
    }
    for (std::size_t i = 0; i < kCount; ++i) {
      weight[i] = static_cast<float>(height[i]) * edges.sign[i];
      any |= height[i] > 0;
    }
    return any;
  }

  /// Makes the ramps, and the distances from the middles to pixel x's.
  HWY_INLINE void set_ramps(int x) {
    const hn::CappedTag<float, kCount> f;
    alignas(16) std::array<float, kCount> run;
    for (std::size_t i = 0; i < kCount; ++i) {
      run[i] = static_cast<float>(right[i] - left[i]);
      first[i] = static_cast<float>(x + 0.5 - middle[i]);
    }
    const auto one = hn::Set(f, 1.0f), half = hn::Set(f, 0.5f);
    for (std::size_t i = 0; i < kCount; i += hn::Lanes(f)) {
      const auto r = hn::Load(f, run.data() + i);
      const auto longer = hn::Max(r, one);
      const auto shorter = hn::Max(hn::Min(r, one), hn::Set(f, 1e-6f));
      const auto per_pixel = hn::Div(one, longer), inverse = hn::Div(one, shorter);
      hn::Store(hn::Mul(half, hn::Sub(longer, shorter)), f, flat.data() + i);
      hn::Store(per_pixel, f, rate.data() + i);
      hn::Store(hn::Mul(hn::Mul(half, shorter), per_pixel), f, bend.data() + i);
      hn::Store(inverse, f, inv_bend.data() + i);
      hn::Store(hn::Mul(hn::Mul(half, hn::Add(longer, shorter)), inverse), f, start.data() + i);
    }
  }
};

template <class Pixel>
struct Rows {
  Pixel* pixels;
  std::ptrdiff_t width;
  int y_begin, y_end;

  HWY_INLINE Pixel* at(int x, int y) const { return pixels + y * width + x; }
  HWY_INLINE int x_end() const { return static_cast<int>(width); }
};

/// Lays `coverage(lanes' distance from pixel first)` on pixels [first, last).
template <class Pixel, class Coverage>
HWY_INLINE void lay_row(const InkLanes<Pixel>& ink, Pixel* pixels, int first, int last,
                        const Coverage& coverage) {
  const CoverTag f;
  const Cover lane = hn::Iota(f, 0.0f);
  int x = first;
  for (; x + kCoverLanes <= last; x += kCoverLanes) {
    ink.lay(coverage(hn::Add(lane, hn::Set(f, static_cast<float>(x - first)))), pixels + x);
  }
  if (x < last) {
    lay_part(ink, coverage(hn::Add(lane, hn::Set(f, static_cast<float>(x - first)))), pixels + x,
             last - x);
  }
}

/// A row with ends of the line in it: any number of edges.
class EndRow {
 public:
  template <class Pixel>
  HWY_INLINE void draw(const StrokeOutline& outline, int y, const InkLanes<Pixel>& ink,
                       const Rows<Pixel>& rows) {
    double left = rows.x_end(), right = 0;
    count_ = 0;
    for (const OutlineEdges& edges : outline.edges) {
      if (count_ == groups_.size()) groups_.emplace_back();
      RowEdges& group = groups_[count_];
      if (!group.find(edges, y)) continue;
      ++count_;
      for (std::size_t i = 0; i < RowEdges::kCount; ++i) {
        if (group.weight[i] == 0) continue;
        left = std::min(left, group.left[i]);
        right = std::max(right, group.right[i]);
      }
    }
    const PixelRange x(left, right, 0, rows.x_end());
    for (std::size_t g = 0; g < count_; ++g) groups_[g].set_ramps(x.first);
    lay_row(ink, rows.at(0, y), x.first, x.last, [&](Cover step) { return coverage(step); });
  }

 private:
  HWY_INLINE Cover coverage(Cover step) const {
    const CoverTag f;
    Cover sum = hn::Zero(f);
    for (std::size_t g = 0; g < count_; ++g) {
      const RowEdges& e = groups_[g];
      for (std::size_t i = 0; i < RowEdges::kCount; ++i) {
        const RampLanes ramp(e.flat[i], e.rate[i], e.bend[i], e.inv_bend[i], e.start[i]);
        const Cover share =
            hn::Add(hn::Set(f, 0.5f), ramp.at(hn::Add(hn::Set(f, e.first[i]), step)));
        sum = hn::Add(sum, hn::Mul(hn::Set(f, e.weight[i]), share));
      }
    }
    return unit(sum);
  }

  std::vector<RowEdges> groups_;
  std::size_t count_ = 0;
};

/// Where the sides lie in several rows: the first pixel touched, and the distances to its middle
/// from the middles of both.
struct BodyRows {
  static constexpr int kCount = 4;
  alignas(32) std::array<std::int32_t, kCount> first;
  alignas(32) std::array<float, kCount> from_left, from_right;

  HWY_INLINE void find(const StrokeOutline& o, int y, int x_end) {
    const hn::CappedTag<double, kCount> d;
    const hn::Rebind<float, decltype(d)> f;
    const hn::Rebind<std::int32_t, decltype(d)> i32;
    const auto half = hn::Set(d, 0.5);
    const double reach = 0.5 * std::abs(o.slope);
    for (std::size_t i = 0; i < kCount; i += hn::Lanes(d)) {
      const auto row = hn::Iota(d, static_cast<double>(y + static_cast<int>(i)));
      const auto down = hn::Sub(hn::Add(row, half), hn::Set(d, o.left_y));
      const auto middle = hn::Add(hn::Set(d, o.left_x), hn::Mul(hn::Set(d, o.slope), down));
      const auto begin = hn::Floor(hn::Sub(middle, hn::Set(d, reach)));
      const auto x = hn::Min(hn::Max(begin, hn::Zero(d)), hn::Set(d, x_end));
      const auto left = hn::Sub(hn::Add(x, half), middle);
      hn::StoreU(hn::DemoteTo(i32, x), i32, first.data() + i);
      hn::StoreU(hn::DemoteTo(f, left), f, from_left.data() + i);
      hn::StoreU(hn::DemoteTo(f, hn::Sub(left, hn::Set(d, o.across))), f, from_right.data() + i);
    }
  }
};

/// Rows between both ends.
template <class Pixel>
class Body {
 public:
  HWY_INLINE Body(const StrokeOutline& outline, const InkLanes<Pixel>& ink, const Rows<Pixel>& rows)
      : outline_(outline), ink_(ink), rows_(rows), ramp_(outline.ramp) {}

  HWY_INLINE void draw(int y_begin, int y_end) const {
    // So little from side to side that no row touches more than four pixels.
    [[maybe_unused]] const bool narrow = outline_.across + std::abs(outline_.slope) < 3;
    BodyRows at;
    for (int y = y_begin; y < y_end; y += BodyRows::kCount) {
      at.find(outline_, y, rows_.x_end());
      const int count = std::min(BodyRows::kCount, y_end - y);
      int row = 0;
#if HWY_TARGET != HWY_SCALAR
      if constexpr (kCoverLanes == 8) {
        for (; narrow && row + 2 <= count; row += 2) draw_two_rows(at, y, row);
      }
#endif
      for (; row < count; ++row) draw_row(at, y, row);
    }
  }

 private:
  HWY_INLINE Cover coverage(Cover from_left, Cover from_right) const {
    return unit(hn::Sub(ramp_.at(from_left), ramp_.at(from_right)));
  }

  HWY_INLINE void draw_row(const BodyRows& at, int y, int row) const {
    const CoverTag f;
    const auto r = static_cast<std::size_t>(row);
    const double middle = outline_.left_x + outline_.slope * (y + row + 0.5 - outline_.left_y);
    const double reach = 0.5 * std::abs(outline_.slope);
    const PixelRange x(middle - reach, middle + outline_.across + reach, 0, rows_.x_end());
    lay_row(ink_, rows_.at(0, y + row), x.first, x.last, [&](Cover step) {
      return coverage(hn::Add(hn::Set(f, at.from_left[r]), step),
                      hn::Add(hn::Set(f, at.from_right[r]), step));
    });
  }

#if HWY_TARGET != HWY_SCALAR
  HWY_INLINE void draw_two_rows(const BodyRows& at, int y, int row) const {
    const auto r = static_cast<std::size_t>(row);
    const int end = rows_.x_end() - 4;
    if (at.first[r] > end || at.first[r + 1] > end) {
      draw_row(at, y, row);
      draw_row(at, y, row + 1);
      return;
    }
    const CoverTag f;
    const hn::Half<CoverTag> half;
    const auto step = hn::Iota(half, 0.0f);
    const auto both = [&](const std::array<float, BodyRows::kCount>& distance) {
      return hn::Combine(f, hn::Add(hn::Set(half, distance[r + 1]), step),
                         hn::Add(hn::Set(half, distance[r]), step));
    };
    ink_.lay(coverage(both(at.from_left), both(at.from_right)), rows_.at(at.first[r], y + row),
             rows_.at(at.first[r + 1], y + row + 1));
  }
#endif

  const StrokeOutline& outline_;
  const InkLanes<Pixel>& ink_;
  const Rows<Pixel>& rows_;
  const RampLanes ramp_;
};

template <class Pixel>
HWY_INLINE void draw_in_rows(std::span<const InkedLine> lines, std::span<const std::uint32_t> order,
                             const Stroke& stroke, Mixing mixing, const Rows<Pixel>& rows) {
  StrokeOutline outline;
  EndRow end_row;
  for (const std::uint32_t index : order) {
    const InkedLine& line = lines[index];
    outline.set(line.segment, stroke);
    const InkLanes<Pixel> ink(Ink{line.colour, mixing});
    const int begin = std::max(outline.y_begin, rows.y_begin);
    const int end = std::min(outline.y_end, rows.y_end);
    const int body_begin = std::clamp(outline.body_begin, begin, std::max(begin, end));
    const int body_end = std::clamp(outline.body_end, body_begin, std::max(body_begin, end));
    for (int y = begin; y < std::min(body_begin, end); ++y) end_row.draw(outline, y, ink, rows);
    if (body_begin < body_end) Body<Pixel>(outline, ink, rows).draw(body_begin, body_end);
    for (int y = body_end; y < end; ++y) end_row.draw(outline, y, ink, rows);
  }
}

template <class Pixel>
HWY_INLINE Rows<Pixel> rows_of(Image<Pixel>& picture, int y_begin, int y_end) {
  return {picture.pixels().data(), picture.width(), y_begin, y_end};
}

void DrawLines8(std::span<const InkedLine> lines, std::span<const std::uint32_t> order,
                const Stroke& stroke, Mixing mixing, int y_begin, int y_end,
                Image<Linear8>& picture) {
  draw_in_rows(lines, order, stroke, mixing, rows_of(picture, y_begin, y_end));
}

void DrawLinesFloat(std::span<const InkedLine> lines, std::span<const std::uint32_t> order,
                    const Stroke& stroke, Mixing mixing, int y_begin, int y_end,
                    Image<LinearRgba>& picture) {
  draw_in_rows(lines, order, stroke, mixing, rows_of(picture, y_begin, y_end));
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(DrawLines8);
HWY_EXPORT(DrawLinesFloat);

void draw_lines(std::span<const InkedLine> lines, std::span<const std::uint32_t> order,
                const Stroke& stroke, Mixing mixing, int y_begin, int y_end,
                Image<Linear8>& picture) {
  HWY_DYNAMIC_DISPATCH(DrawLines8)(lines, order, stroke, mixing, y_begin, y_end, picture);
}

void draw_lines(std::span<const InkedLine> lines, std::span<const std::uint32_t> order,
                const Stroke& stroke, Mixing mixing, int y_begin, int y_end,
                Image<LinearRgba>& picture) {
  HWY_DYNAMIC_DISPATCH(DrawLinesFloat)(lines, order, stroke, mixing, y_begin, y_end, picture);
}

}  // namespace kinescope
#endif
