// Where the beam is and how it got there, drawn: its path over the tube, and the waveforms of both
// deflections below.
#pragma once

#include <string>

#include "demos/studio.h"
#include "demos/ui/canvas.h"
#include "display/raster_scan.h"

namespace kinescope {

/// Of one exposure [begin, end), tube time.
struct BeamChart {
  const RasterScan& scan;
  const Studio& studio;
  Seconds begin, end;

  /// The path of the line that passes, and of the flight that follows it; `face` is the tube's
  /// active picture. Blanked parts are dashed.
  void draw_path(Canvas& canvas, const Rect& face) const;
  /// Horizontal deflection over a line or two, vertical deflection over a frame, and in words.
  void draw_charts(Canvas& canvas, const Rect& room) const;

 private:
  void draw_span(Canvas& canvas, const Rect& face, Seconds from, Seconds to) const;
  void draw_wave(Canvas& canvas, const Rect& room, bool across) const;
  void draw_words(Canvas& canvas, const Rect& room) const;
};

/// "active", "front porch", "sync", "back porch".
std::string phase_name(ScanPhase phase);
/// A time in the unit that suits it: "16.683 ms", "31.78 us".
std::string time_text(Seconds t);

}  // namespace kinescope
