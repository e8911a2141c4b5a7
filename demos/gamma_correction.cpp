#include "demos/gamma_correction.h"

#include <algorithm>
#include <cmath>

namespace kinescope {

GammaCorrection::GammaCorrection(double tube_gamma) {
  for (std::size_t code = 0; code < drive_.size(); ++code) {
    const double light = srgb_decode(static_cast<float>(code) / 255.0f);
    drive_[code] = static_cast<std::uint8_t>(std::lround(255 * std::pow(light, 1 / tube_gamma)));
  }
}

const Image<Srgb8>& GammaCorrection::operator()(const Image<Srgb8>& picture, Workers& workers) {
  corrected_.resize(picture.width(), picture.height());
  run_rows(workers, picture.height(), [&](int y) {
    const Srgb8* from = picture.row(y);
    std::transform(from, from + picture.width(), corrected_.row(y), [this](Srgb8 c) {
      return Srgb8{drive_[c.r], drive_[c.g], drive_[c.b], c.a};
    });
  });
  return corrected_;
}

}  // namespace kinescope
