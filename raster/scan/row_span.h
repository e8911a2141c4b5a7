// What scan conversion yields. A sink is anything callable with it: a point as (x, y), a weighted
// point as (x, y, weight in [0, 1]), a run of pixels as a RowSpan.
#pragma once

namespace kinescope {

/// Pixels [x_begin, x_end) of row y.
struct RowSpan {
  int y = 0, x_begin = 0, x_end = 0;
  int length() const { return x_end - x_begin; }
  bool operator==(const RowSpan&) const = default;
};

}  // namespace kinescope
