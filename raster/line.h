// Straight lines in integers.
// Source: J. E. Bresenham, "Algorithm for computer control of a digital plotter", 1965.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace kinescope {

/// A line as Bresenham's algorithm steps it: one pixel along the major axis each time, and one
/// along the minor axis whenever the error term says that the line is half a pixel or more away.
/// A copy of it is a state, so a demo can show one step at a time. Coordinates within +-2^29.
class BresenhamLine {
 public:
  BresenhamLine(int x0, int y0, int x1, int y1)
      : x_(x0),
        y_(y0),
        major_(std::abs(x1 - x0)),
        minor_(std::abs(y1 - y0)),
        x_step_(x1 < x0 ? -1 : 1),
        y_step_(y1 < y0 ? -1 : 1),
        steep_(minor_ > major_) {
    [[maybe_unused]] constexpr int kLimit = 1 << 29;
    assert(std::abs(x0) <= kLimit && std::abs(y0) <= kLimit);
    assert(std::abs(x1) <= kLimit && std::abs(y1) <= kLimit);
    if (steep_) std::swap(major_, minor_);
    error_ = 2 * minor_ - major_;
  }

  int x() const { return x_; }
  int y() const { return y_; }
  bool steep() const { return steep_; }  ///< y is the major axis
  std::int64_t steps() const { return major_; }
  /// Twice the major length times (the line's distance beyond the midpoint of the next two pixels).
  std::int64_t error() const { return error_; }

  void step() {
    const bool aside = error_ >= 0;
    (steep_ ? y_ : x_) += steep_ ? y_step_ : x_step_;
    if (aside) (steep_ ? x_ : y_) += steep_ ? x_step_ : y_step_;
    error_ += 2 * minor_ - (aside ? 2 * major_ : 0);
  }

  /// How far aside the line lies after n steps, and the first n (up to steps() + 1) with a given
  /// distance aside.
  std::int64_t aside_after(std::int64_t n) const {
    return major_ ? (2 * n * minor_ + major_) / (2 * major_) : 0;
  }
  std::int64_t first_step_aside(std::int64_t distance) const {
    if (distance <= 0) return 0;
    if (minor_ < distance) return major_ + 1;
    return ((2 * distance - 1) * major_ + 2 * minor_ - 1) / (2 * minor_);
  }
  /// From the line's start only: as if step() had been called n times.
  void skip(std::int64_t n) {
    const std::int64_t aside = aside_after(n);
    const int along = static_cast<int>(n), across = static_cast<int>(aside);
    x_ += x_step_ * (steep_ ? across : along);
    y_ += y_step_ * (steep_ ? along : across);
    error_ += 2 * n * minor_ - 2 * aside * major_;
  }

 private:
  int x_, y_;
  std::int64_t major_, minor_;
  int x_step_, y_step_;
  bool steep_;
  std::int64_t error_ = 0;
};

/// Calls sink(x, y) for each pixel from one end to the other, both ends included.
template <typename Sink>
void bresenham(int x0, int y0, int x1, int y1, Sink&& sink) {
  BresenhamLine line(x0, y0, x1, y1);
  sink(line.x(), line.y());
  for (std::int64_t i = line.steps(); i > 0; --i) {
    line.step();
    sink(line.x(), line.y());
  }
}

/// The same, without the pixels outside [0, width) x [0, height); those inside are the same ones,
/// found at once however long the line is.
template <typename Sink>
void bresenham_clipped(int x0, int y0, int x1, int y1, int width, int height, Sink&& sink) {
  BresenhamLine line(x0, y0, x1, y1);
  // Steps along one axis during which its coordinate lies in [0, size).
  struct Range {
    std::int64_t begin, end;
  };
  const auto inside = [](std::int64_t start, bool backwards, std::int64_t size) {
    return backwards ? Range{start - size + 1, start + 1} : Range{-start, size - start};
  };
  const Range in_x = inside(x0, x1 < x0, width), in_y = inside(y0, y1 < y0, height);
  const Range along = line.steep() ? in_y : in_x, across = line.steep() ? in_x : in_y;
  const std::int64_t begin =
      std::max({std::int64_t{0}, along.begin, line.first_step_aside(across.begin)});
  const std::int64_t end =
      std::min({line.steps() + 1, along.end,
                across.end > 0 ? line.first_step_aside(across.end) : std::int64_t{0}});
  if (begin >= end) return;
  line.skip(begin);
  sink(line.x(), line.y());
  for (std::int64_t i = begin + 1; i < end; ++i) {
    line.step();
    sink(line.x(), line.y());
  }
}

}  // namespace kinescope
