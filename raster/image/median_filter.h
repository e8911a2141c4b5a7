// The median of the pixels about each one: takes away specks and keeps edges. A histogram slides
// along the row; a column enters it and one leaves. Beyond its edges a picture goes on as its last
// row or column.
// Source: T. S. Huang, G. J. Yang and G. Y. Tang, "A fast two-dimensional median filtering
// algorithm", 1979.
#pragma once

#include <algorithm>
#include <array>

#include "raster/dither/grey.h"

namespace kinescope {

/// Moves from pixel to pixel, row by row.
class MedianFilter {
 public:
  /// @param radius pixels to each side, 0 to 255
  MedianFilter(const GreyImage& image, int radius) : image_(image), radius_(radius) {}

  bool next() {
    if (image_.empty() || y_ >= image_.height()) return false;
    if (++x_ == image_.width()) {
      x_ = 0;
      if (++y_ == image_.height()) return false;
    }
    if (x_ == 0) {
      counts_.fill(0);
      median_ = below_ = 0;
      for (int x = -radius_; x <= radius_; ++x) count_column(x, 1);
    } else {
      count_column(x_ - radius_ - 1, -1);
      count_column(x_ + radius_, 1);
    }
    settle();
    return true;
  }
  int x() const { return x_; }
  int y() const { return y_; }
  std::uint8_t median() const { return static_cast<std::uint8_t>(median_); }
  /// Pixels in the window that are darker than the median.
  int below() const { return below_; }

 private:
  void count_column(int x, int by) {
    x = std::clamp(x, 0, image_.width() - 1);
    for (int dy = -radius_; dy <= radius_; ++dy) {
      const int tone = image_.at(x, std::clamp(y_ + dy, 0, image_.height() - 1));
      counts_[static_cast<std::size_t>(tone)] += by;
      if (tone < median_) below_ += by;
    }
  }
  void settle() {
    const int half = (2 * radius_ + 1) * (2 * radius_ + 1) / 2;
    while (below_ > half) below_ -= counts_[static_cast<std::size_t>(--median_)];
    while (below_ + counts_[static_cast<std::size_t>(median_)] <= half) {
      below_ += counts_[static_cast<std::size_t>(median_++)];
    }
  }

  const GreyImage& image_;
  int radius_;
  std::array<int, 256> counts_{};
  int median_ = 0, below_ = 0, x_ = -1, y_ = 0;
};

/// Calls sink(x, y, code) for each pixel, row by row.
template <typename Sink>
void median_filter(const GreyImage& image, int radius, Sink&& sink) {
  for (MedianFilter filter(image, radius); filter.next();) {
    sink(filter.x(), filter.y(), filter.median());
  }
}

}  // namespace kinescope
