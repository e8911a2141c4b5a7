// Connected regions, a run of pixels at a time, with a stack of its own that holds ranges still to
// be looked at: no recursion, however the region winds.
// Source: A. R. Smith, "Tint fill", 1979; P. S. Heckbert, "A seed fill algorithm", 1990.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/pixel_rect.h"
#include "raster/scan/row_span.h"

namespace kinescope {

/// By sides, or by sides and corners.
enum class Connectivity { kFour, kEight };

/// A bit for each pixel of a rectangle.
class PixelBits {
 public:
  explicit PixelBits(const PixelRect& bounds)
      : bounds_(bounds),
        row_words_(static_cast<std::size_t>(std::max(bounds.x1 - bounds.x0, 0) + 63) / 64),
        words_(row_words_ * static_cast<std::size_t>(std::max(bounds.y1 - bounds.y0, 0))) {}

  bool get(int x, int y) const { return word(x, y) >> ((x - bounds_.x0) & 63) & 1; }
  void set(int x, int y) {
    const_cast<std::uint64_t&>(word(x, y)) |= std::uint64_t{1} << ((x - bounds_.x0) & 63);
  }

 private:
  const std::uint64_t& word(int x, int y) const {
    return words_[static_cast<std::size_t>(y - bounds_.y0) * row_words_ +
                  static_cast<std::size_t>(x - bounds_.x0) / 64];
  }

  PixelRect bounds_;
  std::size_t row_words_;
  std::vector<std::uint64_t> words_;
};

/// Yields the region around a seed, run by run. It remembers what it yielded, and does not ask the
/// picture: sinks may paint any pattern, or nothing.
/// @tparam Inside bool(int x, int y): whether a pixel within the bounds belongs; must not change
/// its answers for pixels not yet yielded
template <typename Inside>
class SpanFill {
 public:
  SpanFill(const PixelRect& bounds, Inside inside, int x, int y, Connectivity connectivity)
      : bounds_(bounds),
        inside_(inside),
        reach_(connectivity == Connectivity::kEight ? 1 : 0),
        filled_(bounds) {
    if (x < bounds.x0 || x >= bounds.x1 || y < bounds.y0 || y >= bounds.y1) return;
    stack_.push_back({y, x, x + 1});
  }

  /// Finds the next run; false when the region is full.
  bool next() {
    while (!stack_.empty()) {
      RowSpan& range = stack_.back();
      while (range.x_begin < range.x_end && !open(range.x_begin, range.y)) ++range.x_begin;
      if (range.x_begin == range.x_end) {
        stack_.pop_back();
        continue;
      }
      take(range);
      return true;
    }
    return false;
  }
  const RowSpan& span() const { return span_; }
  /// Ranges of rows in which openings are still to be looked for; the last is next.
  std::span<const RowSpan> stack() const { return stack_; }

 private:
  bool open(int x, int y) const { return !filled_.get(x, y) && inside_(x, y); }

  /// The whole run about the range's first pixel; what is left of the range stays.
  void take(RowSpan& range) {
    const int y = range.y;
    int begin = range.x_begin, end = begin + 1;
    while (begin > bounds_.x0 && open(begin - 1, y)) --begin;
    while (end < bounds_.x1 && open(end, y)) ++end;
    for (int x = begin; x < end; ++x) filled_.set(x, y);
    range.x_begin = std::min(end, range.x_end);
    span_ = {y, begin, end};
    const int low = std::max(begin - reach_, bounds_.x0), high = std::min(end + reach_, bounds_.x1);
    if (y > bounds_.y0) stack_.push_back({y - 1, low, high});
    if (y + 1 < bounds_.y1) stack_.push_back({y + 1, low, high});
  }

  PixelRect bounds_;
  Inside inside_;
  int reach_;
  PixelBits filled_;
  std::vector<RowSpan> stack_;
  RowSpan span_;
};

}  // namespace kinescope
