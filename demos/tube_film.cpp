#include "demos/tube_film.h"

#include <fmt/format.h>

#include <utility>

#include "display/light_encode.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

TubeCamera camera_of(const TubeShot& shot, TubeCamera::Source source, Workers& workers) {
  const Size glass = fit_within(shot.size, shot.aspect);
  return {shot.tube, glass.width, glass.height, std::move(source), workers, shot.signal};
}

template <typename Pixel>
Image<Pixel> encoded(const Image<LinearRgb>& light, ExposureGain gain, Size size,
                     Workers& workers) {
  Image<Pixel> picture;
  encode_light(light, gain, workers, picture);
  return centre_on_black(std::move(picture), size);
}

}  // namespace

void check_shutter(Seconds shutter, Rate rate, bool named_shutter) {
  if (shutter <= rate.period() * (1 + 1e-6)) return;
  throw Error(ErrorKind::kUsage,
              fmt::format("the shutter stays open {:.6g} s, longer than a frame at {:.6g} frames a "
                          "second lasts; choose a shorter --shutter or a lower --fps",
                          shutter.count(), rate.hertz()),
              named_shutter ? "--shutter" : "--fps");
}

TubeFilm::TubeFilm(const TubeShot& shot, TubeCamera::Source source, Workers& workers)
    : shot_(shot), workers_(workers), camera_(camera_of(shot, std::move(source), workers)) {}

FilmPicture TubeFilm::shoot(Seconds begin) {
  const Exposure exposure{begin, begin + shot_.shutter};
  const Image<LinearRgb>& light = camera_.expose(exposure);
  const ExposureGain gain = shot_.gain
                                ? ExposureGain::fixed(static_cast<float>(*shot_.gain))
                                : ExposureGain::average(exposure, shot_.tube.mode.frame_period());
  if (shot_.deep) return encoded<Srgb16>(light, gain, shot_.size, workers_);
  return encoded<Srgb8>(light, gain, shot_.size, workers_);
}

}  // namespace kinescope
