// Picture enhancement point by point: histograms, and curves from old tones to new ones.
// Source: R. C. Gonzalez and R. E. Woods, "Digital Image Processing", 1992, ch. 4.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "raster/dither/grey.h"

namespace kinescope {

/// How many pixels have each tone.
using Histogram = std::array<std::int64_t, 256>;
/// The new tone of each old one.
using ToneCurve = std::array<std::uint8_t, 256>;

inline Histogram histogram(const GreyImage& image) {
  Histogram counts{};
  for (const std::uint8_t tone : image.pixels()) ++counts[tone];
  return counts;
}

/// Mean and standard deviation of the tones, and how many there are; all 0 of no pixels.
struct ToneSpread {
  double mean = 0, deviation = 0;
  int tones = 0;
};
inline ToneSpread tone_spread(const Histogram& counts) {
  double count = 0, sum = 0, squares = 0;
  ToneSpread spread;
  for (std::size_t tone = 0; tone < counts.size(); ++tone) {
    const auto n = static_cast<double>(counts[tone]), t = static_cast<double>(tone);
    count += n;
    sum += n * t;
    squares += n * t * t;
    spread.tones += counts[tone] > 0;
  }
  if (count == 0) return spread;
  spread.mean = sum / count;
  spread.deviation = std::sqrt(std::max(0.0, squares / count - spread.mean * spread.mean));
  return spread;
}

/// A curve from a function of tones from 0 to 1; what it makes of them is clamped.
template <typename Function>
ToneCurve tone_curve(Function&& function) {
  ToneCurve curve{};
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double tone = function(static_cast<double>(i) / 255);
    curve[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(tone, 0.0, 1.0)));
  }
  return curve;
}

inline ToneCurve negative_curve() {
  return tone_curve([](double tone) { return 1 - tone; });
}
/// Below 1 brightens. @param gamma above 0
inline ToneCurve power_curve(double gamma) {
  return tone_curve([=](double tone) { return std::pow(tone, gamma); });
}
/// Tones move away from the middle one, or towards it.
inline ToneCurve contrast_curve(double factor) {
  return tone_curve([=](double tone) { return 0.5 + factor * (tone - 0.5); });
}

/// The darkest tone becomes 0 and the lightest 255, after a share of the pixels at either end is
/// given up. A picture of one tone stays as it is.
inline ToneCurve stretching_curve(const Histogram& counts, double given_up = 0) {
  std::int64_t all = 0;
  for (const std::int64_t count : counts) all += count;
  const auto most = static_cast<std::int64_t>(given_up * static_cast<double>(all));
  int low = 0, high = 255;
  for (std::int64_t sum = counts[0]; low < 255 && sum <= most;) {
    sum += counts[static_cast<std::size_t>(++low)];
  }
  for (std::int64_t sum = counts[255]; high > 0 && sum <= most;) {
    sum += counts[static_cast<std::size_t>(--high)];
  }
  if (low >= high) return tone_curve([](double tone) { return tone; });
  return tone_curve([=](double tone) { return (255 * tone - low) / (high - low); });
}

/// Each tone becomes the share of pixels that are as dark or darker: tones spread evenly.
inline ToneCurve equalizing_curve(const Histogram& counts) {
  ToneCurve curve{};
  std::int64_t all = 0, sum = 0;
  for (const std::int64_t count : counts) all += count;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    sum += counts[i];
    curve[i] = static_cast<std::uint8_t>(all == 0 ? static_cast<std::int64_t>(i)
                                                  : (255 * sum + all / 2) / all);
  }
  return curve;
}

inline GreyImage with_curve(GreyImage image, const ToneCurve& curve) {
  for (std::uint8_t& tone : image.pixels()) tone = curve[tone];
  return image;
}

}  // namespace kinescope
