// Figures of paired timings and of two pictures.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "raster/image/image.h"

namespace kinescope::bench {

double median(std::vector<double> values);

template <typename Work>
double milliseconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

struct PictureDifference {
  std::int64_t pixels_differing = 0;  ///< any channel more than `tolerance` codes apart
  double psnr_db = 0;                 ///< over the three colours; infinite if equal
};
PictureDifference compare(const Image<Linear8>& a, const Image<Linear8>& b, int tolerance);

}  // namespace kinescope::bench
