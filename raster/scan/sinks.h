// Sinks for points and spans, and what may stand between an algorithm and its sink.
#pragma once

#include <algorithm>

#include "raster/image/image.h"
#include "raster/pixel_rect.h"
#include "raster/scan/row_span.h"

namespace kinescope {

/// Writes one value into an image; what lies outside is left out.
template <typename Value>
class ImageSink {
 public:
  ImageSink(Image<Value>& image, Value value) : image_(image), value_(value) {}

  void operator()(int x, int y) const {
    if (image_.contains(x, y)) image_.at(x, y) = value_;
  }
  void operator()(const RowSpan& span) const {
    if (span.y < 0 || span.y >= image_.height()) return;
    const int begin = std::max(span.x_begin, 0), end = std::min(span.x_end, image_.width());
    if (begin < end) std::fill_n(image_.row(span.y) + begin, end - begin, value_);
  }

 private:
  Image<Value>& image_;
  Value value_;
};

/// Lets through what lies within a rectangle.
template <typename Sink>
class ClippedSink {
 public:
  ClippedSink(const PixelRect& window, Sink& sink) : window_(window), sink_(sink) {}

  template <typename... Weight>
  void operator()(int x, int y, Weight... weight) const {
    if (x >= window_.x0 && x < window_.x1 && y >= window_.y0 && y < window_.y1) {
      sink_(x, y, weight...);
    }
  }
  void operator()(RowSpan span) const {
    span.x_begin = std::max(span.x_begin, window_.x0);
    span.x_end = std::min(span.x_end, window_.x1);
    if (span.y >= window_.y0 && span.y < window_.y1 && span.x_begin < span.x_end) sink_(span);
  }

 private:
  PixelRect window_;
  Sink& sink_;
};

/// Takes spans and hands on each of their points.
template <typename Sink>
class PointsOfSpans {
 public:
  explicit PointsOfSpans(Sink& sink) : sink_(sink) {}
  void operator()(const RowSpan& span) const {
    for (int x = span.x_begin; x < span.x_end; ++x) sink_(x, span.y);
  }

 private:
  Sink& sink_;
};

}  // namespace kinescope
