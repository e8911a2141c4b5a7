// Convolution: each pixel becomes a weighted sum of its neighbours. Beyond its edges a picture goes
// on as its last row or column.
// Source: R. C. Gonzalez and R. E. Woods, "Digital Image Processing", 1992, ch. 4 and 7.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "raster/dither/grey.h"

namespace kinescope {

/// Weights of a square about the pixel, row by row from the top left. As in mathematics the weight
/// at (dx, dy) from the middle is of the neighbour at (-dx, -dy).
struct Convolution {
  int side = 1;  ///< odd
  std::vector<double> weights{1};
  double offset = 0;  ///< codes, added to the sum

  double weight(int dx, int dy) const {
    const int half = side / 2;
    return weights[static_cast<std::size_t>((dy + half) * side + dx + half)];
  }
};

/// The mean of side x side pixels.
inline Convolution box_blur(int side) {
  const auto count = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  return {side, std::vector<double>(count, 1.0 / static_cast<double>(count))};
}
/// @param sigma pixels, above 0; cut at three of them
inline Convolution gaussian_blur(double sigma) {
  const int half = static_cast<int>(std::ceil(3 * sigma));
  Convolution blur{2 * half + 1, {}};
  double sum = 0;
  for (int dy = -half; dy <= half; ++dy) {
    for (int dx = -half; dx <= half; ++dx) {
      blur.weights.push_back(std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)));
      sum += blur.weights.back();
    }
  }
  for (double& weight : blur.weights) weight /= sum;
  return blur;
}
/// The picture and `amount` times its difference from its neighbours.
inline Convolution sharpening(double amount) {
  return {3, {0, -amount, 0, -amount, 1 + 4 * amount, -amount, 0, -amount, 0}};
}
inline Convolution laplacian() { return {3, {0, 1, 0, 1, -4, 1, 0, 1, 0}, 128}; }
/// A relief lit from the top left.
inline Convolution emboss() { return {3, {1, 0, 0, 0, 0, 0, 0, 0, -1}, 128}; }
/// Positive where it grows lighter to the right. Source: I. Sobel and G. Feldman, 1968.
inline Convolution sobel_across() { return {3, {1, 0, -1, 2, 0, -2, 1, 0, -1}}; }
/// Positive where it grows lighter downwards.
inline Convolution sobel_down() { return {3, {1, 2, 1, 0, 0, 0, -1, -2, -1}}; }

/// The sum at one pixel, neither rounded nor clamped.
inline double convolved(const GreyImage& image, const Convolution& by, int x, int y) {
  const int half = by.side / 2;
  double sum = by.offset;
  for (int dy = -half; dy <= half; ++dy) {
    const std::uint8_t* row = image.row(std::clamp(y - dy, 0, image.height() - 1));
    for (int dx = -half; dx <= half; ++dx) {
      sum += by.weight(dx, dy) * row[std::clamp(x - dx, 0, image.width() - 1)];
    }
  }
  return sum;
}

/// Calls sink(x, y, code) for each pixel of the convolved picture, row by row.
template <typename Sink>
void convolve(const GreyImage& image, const Convolution& by, Sink&& sink) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const double code = std::clamp(convolved(image, by, x, y), 0.0, 255.0);
      sink(x, y, static_cast<std::uint8_t>(std::lround(code)));
    }
  }
}

/// How steeply tones change, by Sobel's two masks.
template <typename Sink>
void sobel_edges(const GreyImage& image, Sink&& sink) {
  const Convolution across = sobel_across(), down = sobel_down();
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const double code = std::hypot(convolved(image, across, x, y), convolved(image, down, x, y));
      sink(x, y, static_cast<std::uint8_t>(std::lround(std::min(code, 255.0))));
    }
  }
}

}  // namespace kinescope
