// The raster tube: frame buffer, scan, beam, phosphor; exposures of its light.
#pragma once

#include <memory>

#include "display/frame_buffer.h"
#include "display/raster_scan.h"
#include "display/tube/settings.h"
#include "raster/base/workers.h"
#include "raster/image/image.h"

namespace kinescope {

class FreeSweep;

/// A tube's light. Its cells are the mode's pixels on their scan lines; deflection lays them on the
/// glass, which fills the output image. A frame buffer smaller than the mode leaves the rest dark.
/// A monochrome tube's drive is the guns' mixture 0.299 R + 0.587 G + 0.114 B; its white has the
/// phosphor's hue, scaled so that the largest channel is 1 (channels out of gamut stay negative).
/// Copying one copies the phosphor's whole state (so a demo can step back). Exposures must follow
/// each other in time without gaps; each scans the frame buffer as it then is.
class RasterTube {
 public:
  RasterTube(const TubeSettings& settings, int width, int height);
  RasterTube(const RasterTube&);
  RasterTube& operator=(const RasterTube&);
  RasterTube(RasterTube&&) noexcept;
  RasterTube& operator=(RasterTube&&) noexcept;
  ~RasterTube();

  const RasterScan& scan() const;
  const TubeSettings& settings() const;
  /// Of a raster whose sweeps land anew each time; else null. Valid until knobs are turned.
  const FreeSweep* free_sweep() const;
  /// The end of the last exposure; 0 at first.
  Seconds now() const;
  /// Darkens the faceplate and returns to time 0.
  void reset();
  /// Changes the picture's size in output pixels; the phosphor keeps its state.
  void resize(int width, int height);
  /// Turns the knobs. In the same mode, with the same phosphor, the faceplate keeps its light: what
  /// glows stays where it was when the raster moves.
  /// @return whether that was so; else it is a new tube: dark, at time 0
  bool adjust(const TubeSettings& settings);

  /// The light of [now, end), per output pixel, in refresh-periods of steady white: exposing one
  /// whole frame period of a steady white picture gives 1, averaged over scan lines and mask.
  /// @return valid until the next call
  const Image<LinearRgb>& expose(FrameBuffer& buffer, Seconds end, Workers& workers);

  /// Where photograph() puts a picture, and what it may rely on.
  struct Print {
    Image<Srgb8>& out;
    float gain = 1;
    int left = 0, top = 0;  ///< of its upper left corner in `out`
    bool kept = false;      ///< whether `out` still holds what the last call left there
  };
  /// The same light times the gain, encoded; faster, for the light itself is never stored.
  /// Refreshes of a picture that does not change cost next to nothing once its light is steady.
  /// @return whether it drew; if not, `out` holds the very picture already
  bool photograph(FrameBuffer& buffer, Seconds end, Workers& workers, const Print& print);

  /// What the last exposure spent where, ms.
  struct Times {
    double guns = 0, phosphor = 0, glow = 0, glass = 0;
  };
  const Times& times() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kinescope
