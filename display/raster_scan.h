// Raster scan: the beam's place as a function of time.
#pragma once

#include <cstdint>

#include "display/beam_clock.h"
#include "display/video_mode.h"

namespace kinescope {

/// What part of a line, or of a field, is passing.
enum class ScanPhase { kActive, kFrontPorch, kSync, kBackPorch };

/// Where the beam is. Time 0 is the first pixel of line 0 of field 0. The second field of an
/// interlaced frame begins in the middle of a line; its first picture line, line 1 of the frame,
/// begins half a line later.
struct BeamPosition {
  std::int64_t frame = 0;
  int field = 0;          ///< 0, or 1 in the second field of an interlaced frame
  double field_line = 0;  ///< lines since the field began, fractional
  int line = 0;      ///< line of the frame (interlaced: 2 * line in field + field); active only
                     ///< below mode.vertical.active
  double pixel = 0;  ///< pixels since the line began, fractional, below horizontal.total()
  ScanPhase horizontal = ScanPhase::kActive;
  ScanPhase vertical = ScanPhase::kActive;
  bool blanked = false;  ///< outside the active picture
  double x = 0;          ///< deflection: 0 left to 1 right edge of the active picture, flying back
                         ///< during sync and back porch; in the front porch it sweeps on beyond 1
  double y = 0;  ///< deflection: 0 top to 1 bottom, flying back during vertical sync and back
                 ///< porch; it is (line + 1/2) / active in the middle of a line's sweep
};

/// Fly-back is half a period of the deflection coil ringing with its capacitor: from `from` to `to`
/// along half a cosine, `done` in [0, 1].
double fly_back(double from, double to, double done);

class RasterScan {
 public:
  explicit RasterScan(const VideoMode& mode);
  const VideoMode& mode() const { return mode_; }

  BeamPosition at(Seconds t) const;
  /// When the given active line's first pixel begins in the given frame.
  Seconds line_start(std::int64_t frame, int line) const;
  /// When vertical blanking that ends the given field begins.
  Seconds retrace_start(std::int64_t frame, int field) const;

  // The same in exact pixel clocks.
  const BeamClock& clock() const { return clock_; }
  int fields() const { return mode_.interlaced ? 2 : 1; }
  BeamTime line_clocks() const { return clocks(mode_.horizontal.total()); }
  BeamTime frame_clocks() const;
  BeamTime line_start_clocks(std::int64_t frame, int line) const;
  BeamTime retrace_start_clocks(std::int64_t frame, int field) const;
  /// The first of these at `t` or later.
  BeamTime retrace_from(BeamTime t) const;

 private:
  int picture_lines(int field) const;
  void place_across(BeamPosition& beam, BeamTime in_frame) const;
  void place_down(BeamPosition& beam) const;

  VideoMode mode_;
  BeamClock clock_;
};

}  // namespace kinescope
