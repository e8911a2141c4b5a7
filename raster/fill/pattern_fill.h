// Pattern fill: a tile repeated over any filled area.
// Source: J. D. Foley et al., "Computer Graphics: Principles and Practice", 1990, 3.8.
#pragma once

#include <glm/vec2.hpp>

#include "raster/image/image.h"
#include "raster/scan/row_span.h"

namespace kinescope {

/// A tile that repeats without end. Anchored to the screen (origin 0), areas side by side show one
/// pattern; anchored to a corner of the figure, the pattern moves with it.
template <typename Value>
class TilePattern {
 public:
  /// An empty tile has the value Value{} everywhere.
  explicit TilePattern(Image<Value> tile, glm::ivec2 origin = {0, 0})
      : tile_(std::move(tile)), origin_(origin) {}

  Value at(int x, int y) const {
    if (tile_.empty()) return Value{};
    return tile_.at(wrapped(x, origin_.x, tile_.width()), wrapped(y, origin_.y, tile_.height()));
  }

 private:
  static int wrapped(int v, int origin, int size) {
    const std::int64_t rest = (std::int64_t{v} - origin) % size;
    return static_cast<int>(rest < 0 ? rest + size : rest);
  }

  Image<Value> tile_;
  glm::ivec2 origin_;
};

/// Takes the runs of any fill and calls sink(x, y, value) for each pixel.
template <typename Value, typename Sink>
class PatternedSink {
 public:
  PatternedSink(const TilePattern<Value>& pattern, Sink& sink) : pattern_(pattern), sink_(sink) {}
  void operator()(const RowSpan& span) const {
    for (int x = span.x_begin; x < span.x_end; ++x) sink_(x, span.y, pattern_.at(x, span.y));
  }

 private:
  const TilePattern<Value>& pattern_;
  Sink& sink_;
};

}  // namespace kinescope
