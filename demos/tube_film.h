// Pictures for a film, of a tube: exposures of its light, encoded and laid on black.
#pragma once

#include <deque>
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
  Seconds every{0};            ///< from one picture's beginning to the next one's
  std::optional<double> gain;  ///< of light in refreshes of steady white; none: by the shutter's
                               ///< length, so that steady white is 1
  bool deep = false;           ///< 16 bits a channel instead of 8
};

/// A camera's shutter cannot stay open longer than a frame of its film lasts. The eye's exposure,
/// which nobody named, may: pictures then share light, up to eight at a time.
/// @param named whether the user gave the shutter
/// @throws Error (usage)
void check_shutter(Seconds shutter, Rate rate, bool named);

/// Times are the camera's.
class TubeFilm {
 public:
  TubeFilm(const TubeShot& shot, TubeCamera::Source source, Workers& workers);
  void pass_to(Seconds time) { camera_.pass_to(time); }
  /// The picture of [begin, begin + shutter). Each begins `every` after the one before.
  FilmPicture shoot(Seconds begin);

 private:
  const Image<LinearRgb>& gather(Exposure exposure);
  void expose_to(Seconds end);

  /// Light that several pictures share.
  struct Piece {
    Seconds end;
    Image<LinearRgb> light;
  };
  TubeShot shot_;
  Workers& workers_;
  TubeCamera camera_;
  std::deque<Piece> pieces_;  // in order, without gaps
  Seconds gathered_{0};       // their end
  Image<LinearRgb> sum_;
};

}  // namespace kinescope
