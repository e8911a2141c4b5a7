#include "raster/path/line_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raster/path/stroke_coverage.h"

#include <hwy/cache_control.h>

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
  using D = hn::CappedTag<double, kCount>;
  using F = hn::Rebind<float, D>;
  static constexpr double kNowhere = 1e300;

  alignas(32) std::array<double, kCount> left, right, middle;
  alignas(16) std::array<float, kCount> run, weight, first, flat, rate, bend, inv_bend, start;

  /// edge_in_row() for all four; left and right of what is not there is nowhere.
  HWY_INLINE void find(const OutlineEdges& edges, int y) {
    const D d;
    const F f;
    const auto row = hn::Set(d, static_cast<double>(y));
    const auto next = hn::Add(row, hn::Set(d, 1.0));
    for (std::size_t i = 0; i < kCount; i += hn::Lanes(d)) {
      const auto top = hn::LoadU(d, edges.top.data() + i);
      const auto x = hn::LoadU(d, edges.x.data() + i);
      const auto slope = hn::LoadU(d, edges.slope.data() + i);
      const auto from = hn::Max(top, row);
      const auto to = hn::Min(hn::LoadU(d, edges.bottom.data() + i), next);
      const auto x0 = hn::Add(x, hn::Mul(hn::Sub(from, top), slope));
      const auto x1 = hn::Add(x, hn::Mul(hn::Sub(to, top), slope));
      const auto low = hn::Min(x0, x1), high = hn::Max(x0, x1);
      const auto there = hn::Gt(to, from);
      const auto height = hn::DemoteTo(f, hn::IfThenElseZero(there, hn::Sub(to, from)));
      hn::Store(hn::IfThenElse(there, low, hn::Set(d, kNowhere)), d, left.data() + i);
      hn::Store(hn::IfThenElse(there, high, hn::Set(d, -kNowhere)), d, right.data() + i);
      hn::Store(hn::Mul(hn::Set(d, 0.5), hn::Add(x0, x1)), d, middle.data() + i);
      hn::StoreU(hn::DemoteTo(f, hn::Sub(high, low)), f, run.data() + i);
      hn::StoreU(hn::Mul(height, hn::LoadU(f, edges.sign.data() + i)), f, weight.data() + i);
    }
  }

  HWY_INLINE double leftmost() const {
    return std::min(std::min(left[0], left[1]), std::min(left[2], left[3]));
  }
  HWY_INLINE double rightmost() const {
    return std::max(std::max(right[0], right[1]), std::max(right[2], right[3]));
  }

  /// Makes the ramps, and the distances from the middles to pixel x's.
  HWY_INLINE void set_ramps(int x) {
    const D d;
    const F f;
    const auto pixel = hn::Set(d, x + 0.5);
    const auto one = hn::Set(f, 1.0f), half = hn::Set(f, 0.5f);
    for (std::size_t i = 0; i < kCount; i += hn::Lanes(d)) {
      const auto distance = hn::Sub(pixel, hn::Load(d, middle.data() + i));
      const auto r = hn::LoadU(f, run.data() + i);
      const auto longer = hn::Max(r, one);
      const auto shorter = hn::Max(hn::Min(r, one), hn::Set(f, 1e-6f));
      const auto per_pixel = hn::Div(one, longer), inverse = hn::Div(one, shorter);
      const auto ends = hn::Mul(half, hn::Add(longer, shorter));
      hn::StoreU(hn::DemoteTo(f, distance), f, first.data() + i);
      hn::StoreU(hn::Mul(half, hn::Sub(longer, shorter)), f, flat.data() + i);
      hn::StoreU(per_pixel, f, rate.data() + i);
      hn::StoreU(hn::Mul(hn::Mul(half, shorter), per_pixel), f, bend.data() + i);
      hn::StoreU(inverse, f, inv_bend.data() + i);
      hn::StoreU(hn::Mul(ends, inverse), f, start.data() + i);
    }
  }

  /// What edge i adds to pixels that lie `step` right of the first.
  HWY_INLINE Cover share(std::size_t i, Cover step) const {
    const CoverTag f;
    const RampLanes ramp(flat[i], rate[i], bend[i], inv_bend[i], start[i]);
    const Cover right_of = ramp.at(hn::Add(hn::Set(f, first[i]), step));
    return hn::Mul(hn::Set(f, weight[i]), hn::Add(hn::Set(f, 0.5f), right_of));
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

/// Lays `coverage(lanes' distance from pixel first)` on pixels [first, last) of a row. Lanes beyond
/// `last` must not be covered.
template <class Pixel, class Coverage>
HWY_INLINE void lay_row(const InkLanes<Pixel>& ink, Pixel* row, int width, int first, int last,
                        const Coverage& coverage) {
  const CoverTag f;
  const Cover lane = hn::Iota(f, 0.0f);
  for (int x = first; x < last; x += kCoverLanes) {
    const Cover c = coverage(hn::Add(lane, hn::Set(f, static_cast<float>(x - first))));
    if (x + kCoverLanes <= width) {
      ink.lay(c, row + x);
    } else {
      lay_part(ink, c, row + x, width - x);
    }
  }
}

/// Lays what edges cover; beyond their last pixel the shares need not cancel to the last bit.
template <class Pixel, class Coverage>
HWY_INLINE void lay_edges(const InkLanes<Pixel>& ink, Pixel* row, int width, const PixelRange& x,
                          const Coverage& coverage) {
  const Cover count = hn::Set(CoverTag(), static_cast<float>(x.last - x.first));
  lay_row(ink, row, width, x.first, x.last, [&](Cover step) {
    return hn::IfThenElseZero(hn::Lt(step, count), unit(coverage(step)));
  });
}

/// A row at one flat end of a line: both sides, and the edge with index kEnd.
template <std::size_t kEnd, class Pixel>
HWY_INLINE void draw_flat_end(const OutlineEdges& edges, int y, const InkLanes<Pixel>& ink,
                              const Rows<Pixel>& rows) {
  RowEdges row;
  row.find(edges, y);
  const PixelRange x(row.leftmost(), row.rightmost(), 0, rows.x_end());
  row.set_ramps(x.first);
  lay_edges(ink, rows.at(0, y), rows.x_end(), x, [&](Cover step) {
    return hn::Add(hn::Add(row.share(0, step), row.share(1, step)), row.share(kEnd, step));
  });
}

/// A row with any number of edges.
class EdgesOfRow {
 public:
  template <class Pixel>
  HWY_INLINE void draw(const StrokeOutline& outline, int y, const InkLanes<Pixel>& ink,
                       const Rows<Pixel>& rows) {
    double left = RowEdges::kNowhere, right = -RowEdges::kNowhere;
    count_ = 0;
    for (const OutlineEdges& edges : outline.edges) {
      if (count_ == groups_.size()) groups_.emplace_back();
      RowEdges& group = groups_[count_];
      group.find(edges, y);
      if (group.rightmost() == -RowEdges::kNowhere) continue;
      ++count_;
      left = std::min(left, group.leftmost());
      right = std::max(right, group.rightmost());
    }
    const PixelRange x(left, right, 0, rows.x_end());
    for (std::size_t g = 0; g < count_; ++g) groups_[g].set_ramps(x.first);
    lay_edges(ink, rows.at(0, y), rows.x_end(), x, [&](Cover step) {
      Cover sum = hn::Zero(CoverTag());
      for (std::size_t g = 0; g < count_; ++g) {
        for (std::size_t i = 0; i < RowEdges::kCount; ++i) {
          sum = hn::Add(sum, groups_[g].share(i, step));
        }
      }
      return sum;
    });
  }

 private:
  std::vector<RowEdges> groups_;
  std::size_t count_ = 0;
};

/// Where the sides lie in several rows: the first pixel touched and the one after the last, and the
/// distances to the first one's middle from the middles of both.
struct BodyRows {
  static constexpr int kCount = 4;
  alignas(32) std::array<std::int32_t, kCount> first, last;
  alignas(32) std::array<float, kCount> from_left, from_right;

  HWY_INLINE void find(const StrokeOutline& o, int y, int x_end) {
    const hn::CappedTag<double, kCount> d;
    const hn::Rebind<float, decltype(d)> f;
    const hn::Rebind<std::int32_t, decltype(d)> i32;
    const auto half = hn::Set(d, 0.5);
    const auto reach = hn::Set(d, 0.5 * std::abs(o.slope));
    const auto across = hn::Set(d, o.across), zero = hn::Zero(d);
    const auto width = hn::Set(d, static_cast<double>(x_end));
    const auto within = [&](auto x) { return hn::Min(hn::Max(x, zero), width); };
    for (std::size_t i = 0; i < kCount; i += hn::Lanes(d)) {
      const auto row = hn::Iota(d, static_cast<double>(y + static_cast<int>(i)));
      const auto down = hn::Sub(hn::Add(row, half), hn::Set(d, o.left_y));
      const auto middle = hn::Add(hn::Set(d, o.left_x), hn::Mul(hn::Set(d, o.slope), down));
      const auto x = within(hn::Floor(hn::Sub(middle, reach)));
      const auto end = within(hn::Ceil(hn::Add(hn::Add(middle, across), reach)));
      const auto left = hn::Sub(hn::Add(x, half), middle);
      hn::StoreU(hn::DemoteTo(i32, x), i32, first.data() + i);
      hn::StoreU(hn::DemoteTo(i32, end), i32, last.data() + i);
      hn::StoreU(hn::DemoteTo(f, left), f, from_left.data() + i);
      hn::StoreU(hn::DemoteTo(f, hn::Sub(left, across)), f, from_right.data() + i);
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
      prefetch_below(at, y, y_end);
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

  HWY_INLINE void prefetch_below(const BodyRows& at, int y, int y_end) const {
    constexpr int kAhead = 12;
    if (y + kAhead + BodyRows::kCount > y_end) return;
    const double aside = std::clamp<double>(kAhead * outline_.slope, -rows_.width, rows_.width);
    for (std::size_t r = 0; r < BodyRows::kCount; ++r) {
      const int x = at.first[r] + static_cast<int>(aside);
      if (x >= 0 && x < rows_.x_end()) {
        hwy::Prefetch(rows_.at(x, y + kAhead + static_cast<int>(r)));
      }
    }
  }

  HWY_INLINE void draw_row(const BodyRows& at, int y, int row) const {
    const CoverTag f;
    const auto r = static_cast<std::size_t>(row);
    lay_row(ink_, rows_.at(0, y + row), rows_.x_end(), at.first[r], at.last[r], [&](Cover step) {
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

/// Asks for the pixels along a line before it is drawn: lines lie anywhere, and a row of the
/// picture is far from the next.
template <class Pixel>
HWY_INLINE void prefetch(const Segment& segment, const Rows<Pixel>& rows) {
  glm::vec2 a = segment.from, b = segment.to;
  if (a.y > b.y) std::swap(a, b);
  // The limits come first, so that they also stand in for what is not a number.
  const auto top = static_cast<float>(rows.y_begin), bottom = static_cast<float>(rows.y_end);
  const int begin = static_cast<int>(std::min(bottom, std::max(top, a.y)));
  constexpr int kRows = 16;
  const int end =
      std::min(begin + kRows, static_cast<int>(std::min(bottom, std::max(top, b.y + 1))));
  const float slope = (b.x - a.x) / std::max(b.y - a.y, 1e-3f);
  const auto most = static_cast<float>(rows.x_end() - 1);
  for (int y = begin; y < end; ++y) {
    const float x = a.x + slope * (static_cast<float>(y) - a.y);
    hwy::Prefetch(rows.at(static_cast<int>(std::min(most, std::max(0.0f, x))), y));
  }
}

template <class Pixel>
HWY_INLINE void draw_line(const StrokeOutline& outline, const InkLanes<Pixel>& ink,
                          const Rows<Pixel>& rows, EdgesOfRow& edges) {
  const int begin = std::max(outline.y_begin, rows.y_begin);
  const int end = std::min(outline.y_end, rows.y_end);
  // With a body between them, each row at an end has one end's edge in it.
  const bool flat = outline.edges.size() == 1 && outline.body_begin < outline.body_end;
  if (!flat) {
    for (int y = begin; y < std::min(end, outline.body_begin); ++y) {
      edges.draw(outline, y, ink, rows);
    }
  } else {
    for (int y = begin; y < std::min(end, outline.body_begin); ++y) {
      draw_flat_end<2>(outline.edges[0], y, ink, rows);
    }
  }
  const int body_begin = std::max(begin, outline.body_begin);
  const int body_end = std::min(end, outline.body_end);
  if (body_begin < body_end) Body<Pixel>(outline, ink, rows).draw(body_begin, body_end);
  if (!flat) {
    for (int y = std::max(begin, outline.body_end); y < end; ++y) {
      edges.draw(outline, y, ink, rows);
    }
  } else {
    for (int y = std::max(begin, outline.body_end); y < end; ++y) {
      draw_flat_end<3>(outline.edges[0], y, ink, rows);
    }
  }
}

template <class Pixel>
HWY_INLINE void draw_in_rows(std::span<const InkedLine> lines, std::span<const std::uint32_t> order,
                             const Stroke& stroke, Mixing mixing, const Rows<Pixel>& rows) {
  StrokeOutline outline;
  EdgesOfRow edges;
  for (std::size_t i = 0; i < order.size(); ++i) {
    // The lines of a band lie apart as well.
    constexpr std::size_t kAhead = 6;
    if (i + kAhead < order.size()) hwy::Prefetch(&lines[order[i + kAhead]]);
    if (i + 1 < order.size()) prefetch(lines[order[i + 1]].segment, rows);
    const InkedLine& line = lines[order[i]];
    outline.set(line.segment, stroke);
    draw_line(outline, InkLanes<Pixel>(Ink{line.colour, mixing}), rows, edges);
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
