// The ways to enhance a picture, by name: tone curves, sums of neighbours, and the median.
#pragma once

#include <cmath>

#include "raster/image/convolution.h"
#include "raster/image/median_filter.h"
#include "raster/image/tone_curve.h"

namespace kinescope {

enum class Enhancement {
  kStretch,
  kEqualize,
  kContrast,
  kGamma,
  kNegative,
  kBox,
  kGaussian,
  kSharpen,
  kLaplacian,
  kSobel,
  kEmboss,
  kMedian
};

struct EnhancementStep {
  Enhancement kind = Enhancement::kEqualize;
  double amount = 1;  ///< factor, exponent, or pixels about the middle one; above 0
};

/// The curve of those that look at a pixel alone; others' is the identity.
inline ToneCurve enhancing_curve(const Histogram& counts, const EnhancementStep& step) {
  switch (step.kind) {
    case Enhancement::kStretch:
      return stretching_curve(counts, 0.005);
    case Enhancement::kEqualize:
      return equalizing_curve(counts);
    case Enhancement::kContrast:
      return contrast_curve(step.amount);
    case Enhancement::kGamma:
      return power_curve(step.amount);
    case Enhancement::kNegative:
      return negative_curve();
    default:
      return tone_curve([](double tone) { return tone; });
  }
}

/// Calls sink(x, y, tone) for each pixel, row by row.
template <typename Sink>
void enhance(const GreyImage& image, const EnhancementStep& step, Sink&& sink) {
  const int pixels = static_cast<int>(std::lround(step.amount));
  switch (step.kind) {
    case Enhancement::kBox:
      return convolve(image, box_blur(2 * pixels + 1), sink);
    case Enhancement::kGaussian:
      return convolve(image, gaussian_blur(step.amount), sink);
    case Enhancement::kSharpen:
      return convolve(image, sharpening(step.amount), sink);
    case Enhancement::kLaplacian:
      return convolve(image, laplacian(), sink);
    case Enhancement::kSobel:
      return sobel_edges(image, sink);
    case Enhancement::kEmboss:
      return convolve(image, emboss(), sink);
    case Enhancement::kMedian:
      return median_filter(image, pixels, sink);
    default:
      break;
  }
  const ToneCurve curve = enhancing_curve(histogram(image), step);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) sink(x, y, curve[image.at(x, y)]);
  }
}

}  // namespace kinescope
