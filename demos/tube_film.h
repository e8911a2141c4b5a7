// Pictures for a film, of a tube: exposures of its light, encoded and laid on black.
#pragma once

#include <optional>

#include "demos/film.h"
#include "demos/tube_camera.h"

namespace kinescope {

/// How a tube is photographed.
struct TubeShot {
  TubeSettings tube;
  TubeSignal signal = TubeSignal::kPicture;
  Size size;          ///< of the pictures
  double aspect = 1;  ///< width over height of the tube's face, which is centred on black
  Seconds shutter{0};
  std::optional<double> gain;  ///< of light in refreshes of steady white; none: by the shutter's
                               ///< length, so that steady white is 1
  bool deep = false;           ///< 16 bits a channel instead of 8
};

/// @param named_shutter whether the user gave the shutter, not the rate
/// @throws Error (usage) if the shutter stays open longer than a frame of the film lasts
void check_shutter(Seconds shutter, Rate rate, bool named_shutter);

/// Times are the camera's.
class TubeFilm {
 public:
  TubeFilm(const TubeShot& shot, TubeCamera::Source source, Workers& workers);
  void pass_to(Seconds time) { camera_.pass_to(time); }
  /// The picture of [begin, begin + shutter); they must follow each other in time.
  FilmPicture shoot(Seconds begin);

 private:
  TubeShot shot_;
  Workers& workers_;
  TubeCamera camera_;
};

}  // namespace kinescope
