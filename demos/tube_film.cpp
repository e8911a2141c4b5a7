#include "demos/tube_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "display/light_encode.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr int kMostShared = 8;      // pictures that hold the same light
constexpr Seconds kRounding(5e-8);  // no longer than what the camera rounds to a refresh

TubeCamera camera_of(const TubeShot& shot, TubeCamera::Source source, Workers& workers) {
  const Size glass = fit_within(shot.size, shot.aspect);
  TubeSettings tube = shot.tube;
  tube.glass.aspect = shot.aspect;
  return {tube, glass.width, glass.height, std::move(source), workers, shot.signal};
}

template <typename Pixel>
Image<Pixel> encoded(const Image<LinearRgb>& light, ExposureGain gain, Size size,
                     Workers& workers) {
  Image<Pixel> picture;
  encode_light(light, gain, workers, picture);
  return centre_on_black(std::move(picture), size);
}

}  // namespace

void check_shutter(Seconds shutter, Rate rate, bool named) {
  if (shutter <= rate.period() * ((named ? 1 : kMostShared) + 1e-6)) return;
  throw Error(ErrorKind::kUsage,
              fmt::format("the shutter stays open {:.6g} s, longer than a frame at {:.6g} frames a "
                          "second lasts; choose a shorter --shutter or a lower --fps",
                          shutter.count(), rate.hertz()),
              named ? "--shutter" : "--fps");
}

TubeFilm::TubeFilm(const TubeShot& shot, TubeCamera::Source source, Workers& workers)
    : shot_(shot), workers_(workers), camera_(camera_of(shot, std::move(source), workers)) {}

void TubeFilm::expose_to(Seconds end) {
  if (end <= gathered_ + kRounding) return;
  pieces_.push_back({end, camera_.expose({gathered_, end})});
  gathered_ = end;
}

const Image<LinearRgb>& TubeFilm::gather(Exposure exposure) {
  if (exposure.length() <= shot_.every + kRounding || shot_.every == Seconds(0)) {
    return camera_.expose(exposure);
  }
  // Cut where a later picture begins and where an earlier one ended.
  while (!pieces_.empty() && pieces_.front().end <= exposure.begin + kRounding) {
    pieces_.pop_front();
  }
  if (pieces_.empty()) gathered_ = exposure.begin;
  const auto whole = static_cast<int>(exposure.length() / shot_.every);
  for (int i = whole; i >= 0; --i) {
    expose_to(exposure.end - i * shot_.every);
    expose_to(std::min(exposure.end, exposure.begin + (whole - i + 1) * shot_.every));
  }
  sum_ = pieces_.front().light;
  for (std::size_t i = 1; i < pieces_.size(); ++i) add_light(sum_, pieces_[i].light);
  return sum_;
}

FilmPicture TubeFilm::shoot(Seconds begin) {
  const Exposure exposure{begin, begin + shot_.shutter};
  const Image<LinearRgb>& light = gather(exposure);
  const ExposureGain gain = shot_.gain
                                ? ExposureGain::fixed(static_cast<float>(*shot_.gain))
                                : ExposureGain::average(exposure, shot_.tube.mode.frame_period());
  if (shot_.deep) return encoded<Srgb16>(light, gain, shot_.size, workers_);
  return encoded<Srgb8>(light, gain, shot_.size, workers_);
}

}  // namespace kinescope
