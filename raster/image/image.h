// A rectangle of pixels, rows from the top, without padding.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "raster/colour/colour.h"

namespace kinescope {

template <typename Pixel>
class Image {
 public:
  Image() = default;
  Image(int width, int height, Pixel fill = Pixel{})
      : width_(width), height_(height), pixels_(size_of(width, height), fill) {}

  /// Of the new size; what the pixels are then is not said.
  void resize(int width, int height) {
    pixels_.resize(size_of(width, height));
    width_ = width;
    height_ = height;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }

  Pixel* row(int y) { return pixels_.data() + offset(0, y); }
  const Pixel* row(int y) const { return pixels_.data() + offset(0, y); }
  Pixel& at(int x, int y) { return pixels_[offset(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels_[offset(x, y)]; }
  std::span<Pixel> pixels() { return pixels_; }
  std::span<const Pixel> pixels() const { return pixels_; }

  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  bool operator==(const Image&) const = default;

 private:
  static std::size_t size_of(int width, int height) {
    assert(width >= 0 && height >= 0);
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  std::size_t offset(int x, int y) const {
    assert(x >= 0 && x < width_ + (width_ == 0) && y >= 0 && y < height_);
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

// Filled and copied by optimized code in every build.
extern template class Image<Srgb8>;

}  // namespace kinescope
