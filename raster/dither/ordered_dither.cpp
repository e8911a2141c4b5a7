#include "raster/dither/ordered_dither.h"

#include <numeric>

namespace kinescope {
namespace {

constexpr std::size_t kChunk = 64;

}  // namespace

OrderedDither::OrderedDither(const ThresholdMatrix& matrix)
    : side_(matrix.side), row_size_(std::lcm(static_cast<std::size_t>(matrix.side), kChunk)) {
  const int cells = side_ * side_;
  for (int y = 0; y < side_; ++y) {
    for (std::size_t x = 0; x < row_size_; ++x) {
      const int rank = matrix.rank(static_cast<int>(x % static_cast<std::size_t>(side_)), y);
      thresholds_.push_back(static_cast<std::uint8_t>(255 * (2 * rank + 1) / (2 * cells)));
    }
  }
}

void OrderedDither::row(int y, std::span<const std::uint8_t> in,
                        std::span<std::uint8_t> out) const {
  const std::uint8_t* thresholds =
      thresholds_.data() + static_cast<std::size_t>(y % side_) * row_size_;
  std::size_t x = 0, t = 0;
  for (; x + kChunk <= in.size(); x += kChunk) {
    // A fixed count without aliases: the compiler makes vectors of it on any instruction set.
    const std::uint8_t* __restrict from = in.data() + x;
    const std::uint8_t* __restrict limit = thresholds + t;
    std::uint8_t* __restrict to = out.data() + x;
    for (std::size_t i = 0; i < kChunk; ++i) to[i] = from[i] > limit[i] ? 255 : 0;
    t = t + kChunk < row_size_ ? t + kChunk : 0;
  }
  for (std::size_t i = 0; x + i < in.size(); ++i) {
    out[x + i] = in[x + i] > thresholds[t + i] ? 255 : 0;
  }
}

GreyImage ordered_dither(const GreyImage& image, const ThresholdMatrix& matrix) {
  const OrderedDither dither(matrix);
  GreyImage result(image.width(), image.height());
  const auto width = static_cast<std::size_t>(image.width());
  if (image.empty()) return result;
  for (int y = 0; y < image.height(); ++y) {
    dither.row(y, {image.row(y), width}, {result.row(y), width});
  }
  return result;
}

}  // namespace kinescope
