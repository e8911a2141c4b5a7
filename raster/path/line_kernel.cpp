#include "raster/path/line_kernel.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "raster/path/stroke_coverage.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/path/line_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/path/ink-inl.h"
#include "raster/path/stroke_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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

/// Asks for the first rows of a line's pixels while another is drawn: lines lie anywhere, and rows
/// of a picture are far apart. No more than some, since such rows share few sets of the cache.
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

/// Rows [begin, end) of one end; kEnd is its edge if it is flat and lies in no row with the other.
template <std::size_t kEnd, class Pixel>
HWY_INLINE void draw_end(const StrokeOutline& outline, int begin, int end,
                         const InkLanes<Pixel>& ink, const Rows<Pixel>& rows, EdgesOfRow& edges) {
  if (outline.edges.size() == 1 && outline.body_begin < outline.body_end) {
    for (int y = begin; y < end; ++y) draw_flat_end<kEnd>(outline.edges[0], y, ink, rows);
  } else {
    for (int y = begin; y < end; ++y) edges.draw(outline, y, ink, rows);
  }
}

template <class Pixel>
HWY_INLINE void draw_line(const StrokeOutline& outline, const InkLanes<Pixel>& ink,
                          const Rows<Pixel>& rows, EdgesOfRow& edges) {
  const int begin = std::max(outline.y_begin, rows.y_begin);
  const int end = std::min(outline.y_end, rows.y_end);
  const int body_begin = std::max(begin, outline.body_begin);
  const int body_end = std::min(end, outline.body_end);
  draw_end<2>(outline, begin, std::min(end, outline.body_begin), ink, rows, edges);
  if (body_begin < body_end) Body<Pixel>(outline, ink, rows).draw(body_begin, body_end);
  draw_end<3>(outline, std::max(begin, outline.body_end), end, ink, rows, edges);
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
