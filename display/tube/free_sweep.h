// The sweep of oscillators that may run by themselves: when each field and line begins, whatever
// the picture's sync says. Times are in sweep clocks, of which a line oscillator's period always
// has as many as the mode's line has pixels; time 0 is the tube's.
#pragma once

#include "display/raster_scan.h"
#include "display/tube/settings.h"

namespace kinescope {

/// Whether sweeps may land elsewhere than the last one did.
bool is_free(const TubeSettings& settings);
/// Lines of the picture that one vertical sweep draws.
int field_lines(const VideoMode& mode);

/// One vertical sweep.
struct SweptField {
  std::int64_t number = 0;
  BeamTime begin, end;     ///< the end is the next one's beginning
  BeamTime first_line;     ///< when its first line begins
  int lines = 0;           ///< that it draws before it flies back
  double fly_back = 0;     ///< when it does, in lines from its beginning
  double first_place = 0;  ///< of that line, in its own lines from the mode's topmost place
};

class FreeSweep {
 public:
  FreeSweep(const SweepSettings& settings, const VideoMode& mode);
  /// Takes over from another at a time in the video's clocks: oscillators that run by themselves go
  /// on from the phase in which they were.
  void take_over(const FreeSweep& before, BeamTime video_now);

  double clock_hz() const { return line_hz_ * line_clocks_; }
  /// Video clocks that a sweep clock takes.
  double video_clocks() const { return video_hz_ / clock_hz(); }
  BeamTime of_video(BeamTime video) const;
  BeamTime line_period() const { return clocks(line_clocks_); }

  SweptField field(std::int64_t number) const;
  SweptField field_at(BeamTime t) const;

 private:
  std::int64_t field_begin_raw(std::int64_t number) const;

  SweepSettings settings_;
  double video_hz_, line_hz_;
  int line_clocks_;
  double field_clocks_;  // from one vertical sweep to the next
  bool interlaced_;
  int lines_, fly_back_lines_;
  double field_origin_ = 0;  // when field 0 begins
  BeamTime line_origin_;     // when a line begins
};

}  // namespace kinescope
