// A camera before a raster tube: moving pictures go onto the tube refresh by refresh, exposures of
// its light come out. Pictures are gamma-corrected on their way to the frame buffer.
#pragma once

#include <cstdint>
#include <functional>

#include "demos/gamma_correction.h"
#include "display/exposure.h"
#include "display/raster_tube.h"

namespace kinescope {

/// What the codes of a source's pictures mean.
enum class TubeSignal {
  kPicture,   ///< sRGB, brought to the guns by gamma correction
  kGunDrive,  ///< the guns' own signal: generators, old computers
};

void add_light(Image<LinearRgb>& sum, const Image<LinearRgb>& light);

/// Times count from the first pixel of refresh 0, before which the tube has shown picture 0 for
/// so long that its light is steady.
class TubeCamera {
 public:
  /// The picture on the tube during a refresh, of the mode's size; valid until the next call.
  using Source = std::function<const Image<Srgb8>&(std::int64_t refresh)>;

  /// @param width, height of the photographs, pixels
  TubeCamera(const TubeSettings& settings, int width, int height, Source source, Workers& workers,
             TubeSignal signal = TubeSignal::kPicture);

  /// The light of the exposure, in refreshes of steady white; exposures must follow each other in
  /// time. @return valid until the next call
  const Image<LinearRgb>& expose(Exposure exposure);

  /// The same light times the gain, encoded, as RasterTube::photograph() lays it down; faster
  /// within one refresh. @return whether it drew
  bool photograph(Exposure exposure, const RasterTube::Print& print);

  /// Changes the photographs' size; the tube's light stays.
  void resize(int width, int height) { tube_.resize(width, height); }

  /// Lets time pass unseen until `time`; the refresh that begins then, if one does, has its
  /// picture.
  void pass_to(Seconds time);

  /// The end of the last exposure.
  Seconds now() const { return now_; }
  Rate refresh() const { return settings_.mode.frame_rate(); }

 private:
  void settle();
  void show(std::int64_t refresh);
  /// Shows the next picture if its refresh begins now.
  void turn_page();
  /// Times within rounding of a refresh's start are that start.
  Seconds snapped(Seconds t) const;
  /// Moves on to `end`, at most to the end of the refresh that passes.
  const Image<LinearRgb>& run_to(Seconds end);

  TubeSettings settings_;
  Source source_;
  Workers& workers_;
  TubeSignal signal_;
  GammaCorrection correct_;
  FrameBuffer buffer_;
  RasterTube tube_;
  Seconds period_;
  Seconds now_{0};             ///< our own: the tube's is in whole ticks of its clock
  std::int64_t settling_ = 0;  ///< refreshes that passed before time 0
  std::int64_t refresh_ = 0;   ///< the one that passes
  Image<LinearRgb> sum_;
  Image<Srgb8> encoded_;
};

}  // namespace kinescope
