// A sink that keeps pixels in order and as a set.
#pragma once

#include <glm/vec2.hpp>
#include <set>
#include <utility>
#include <vector>

#include "raster/scan/row_span.h"

namespace kinescope::testing {

using Pixels = std::set<std::pair<int, int>>;

class PixelSet {
 public:
  void operator()(int x, int y) {
    order_.emplace_back(x, y);
    twice_ += !set_.emplace(x, y).second;
  }
  void operator()(const RowSpan& span) {
    empty_spans_ += span.x_begin >= span.x_end;
    for (int x = span.x_begin; x < span.x_end; ++x) (*this)(x, span.y);
  }

  const Pixels& set() const { return set_; }
  const std::vector<std::pair<int, int>>& order() const { return order_; }
  int twice() const { return twice_; }  ///< pixels given more than once
  int empty_spans() const { return empty_spans_; }

  /// Each pixel touches the next one, by sides or corners; with `closed` the last the first.
  bool is_chain(bool closed) const {
    for (std::size_t i = 0; i + (closed ? 0 : 1) < order_.size(); ++i) {
      const auto [x, y] = order_[i];
      const auto [u, v] = order_[(i + 1) % order_.size()];
      if (std::abs(u - x) > 1 || std::abs(v - y) > 1) return false;
    }
    return true;
  }
  /// Each pixel has at least two neighbours in the set: a closed curve without gaps.
  bool is_loop() const {
    for (const auto& [x, y] : set_) {
      int neighbours = 0;
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) neighbours += (i || j) && set_.count({x + i, y + j});
      }
      if (neighbours < 2) return false;
    }
    return true;
  }

 private:
  Pixels set_;
  std::vector<std::pair<int, int>> order_;
  int twice_ = 0, empty_spans_ = 0;
};

}  // namespace kinescope::testing
