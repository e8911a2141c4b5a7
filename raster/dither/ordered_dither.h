// Ordered dithering: each pixel against a threshold of its own, from a tile that repeats.
// Source: R. Ulichney, "Digital Halftoning", 1987.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/dither/grey.h"
#include "raster/dither/threshold_matrix.h"

namespace kinescope {

/// A matrix made ready. Of n cells, a tile of the even value v lights the number nearest to
/// n v / 255: black none, white all.
class OrderedDither {
 public:
  explicit OrderedDither(const ThresholdMatrix& matrix);

  /// What the remainder of a value must exceed, 0 to 254.
  int threshold(int x, int y) const {
    return thresholds_[static_cast<std::size_t>(y % side_) * row_size_ +
                       static_cast<std::size_t>(x) % row_size_];
  }
  /// The level of a value, of `levels` evenly spaced ones, 2 to 256.
  int level(int x, int y, std::uint8_t value, int levels) const {
    const int scaled = value * (levels - 1);
    return scaled / 255 + (scaled % 255 > threshold(x, y));
  }
  /// A row to two levels, 0 and 255: the same, many pixels at a time.
  void row(int y, std::span<const std::uint8_t> in, std::span<std::uint8_t> out) const;

 private:
  int side_;
  std::size_t row_size_;  // the matrix' rows, repeated to whole chunks
  std::vector<std::uint8_t> thresholds_;
};

/// Calls sink(x, y, level) for each pixel.
template <typename Sink>
void ordered_dither(const GreyImage& image, const ThresholdMatrix& matrix, int levels,
                    Sink&& sink) {
  const OrderedDither dither(matrix);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      sink(x, y, dither.level(x, y, image.at(x, y), levels));
    }
  }
}

/// To 0 and 255.
GreyImage ordered_dither(const GreyImage& image, const ThresholdMatrix& matrix);

}  // namespace kinescope
