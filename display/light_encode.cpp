#include "display/light_encode.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "raster/colour/encode.h"

namespace kinescope {
namespace {

constexpr int kRowsATask = 16;

template <typename Pixel>
void encode_rows(const Image<LinearRgb>& light, ExposureGain gain, Workers& workers,
                 Image<Pixel>& out) {
  if (out.width() != light.width() || out.height() != light.height()) {
    out = Image<Pixel>(light.width(), light.height());
  }
  const std::size_t width = static_cast<std::size_t>(light.width());
  workers.run((light.height() + kRowsATask - 1) / kRowsATask, [&](int task, int) {
    std::vector<LinearRgb> scaled(gain.factor == 1 ? 0 : width);
    const int end = std::min(light.height(), (task + 1) * kRowsATask);
    for (int y = task * kRowsATask; y < end; ++y) {
      std::span<const LinearRgb> row(light.row(y), width);
      if (gain.factor != 1) {
        std::transform(row.begin(), row.end(), scaled.begin(), [&](LinearRgb p) {
          return LinearRgb{p.r * gain.factor, p.g * gain.factor, p.b * gain.factor};
        });
        row = scaled;
      }
      encode_row(row, {out.row(y), width});
    }
  });
}

}  // namespace

ExposureGain ExposureGain::average(Exposure exposure, Seconds refresh_period) {
  assert(exposure.length() > Seconds(0));
  return {static_cast<float>(refresh_period / exposure.length())};
}

void encode_light(const Image<LinearRgb>& light, ExposureGain gain, Workers& workers,
                  Image<Srgb8>& out) {
  encode_rows(light, gain, workers, out);
}

void encode_light(const Image<LinearRgb>& light, ExposureGain gain, Workers& workers,
                  Image<Srgb16>& out) {
  encode_rows(light, gain, workers, out);
}

}  // namespace kinescope
