// Raster scan: the beam's place as a function of time.
#pragma once

#include <cstdint>

#include "display/video_mode.h"

namespace kinescope {

/// What part of a line, or of a field, is passing.
enum class ScanPhase { kActive, kFrontPorch, kSync, kBackPorch };

/// Where the beam is. Time 0 is the first pixel of line 0 of field 0.
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
                         ///< during sync and back porch
  double y = 0;  ///< deflection: 0 top to 1 bottom, flying back during vertical sync and porch
};

class RasterScan {
 public:
  explicit RasterScan(const VideoMode& mode);
  const VideoMode& mode() const { return mode_; }

  BeamPosition at(Seconds t) const;
  /// When the given active line's first pixel begins in the given frame.
  Seconds line_start(std::int64_t frame, int line) const;
  /// When vertical blanking that ends the given field begins.
  Seconds retrace_start(std::int64_t frame, int field) const;

 private:
  VideoMode mode_;
};

}  // namespace kinescope
