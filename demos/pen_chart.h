// What a light pen saw, drawn: its view on the glass, and its signal about the moment it tripped.
#pragma once

#include <optional>
#include <vector>

#include "demos/studio.h"
#include "demos/ui/canvas.h"
#include "display/light_pen.h"

namespace kinescope {

/// One tripping of the pen, tube time.
struct PenSight {
  Seconds tripped{0};
  PixelAddress address;
  std::vector<LightPen::Sample> signal;
};

struct PenChart {
  const LightPen& pen;
  const Studio& studio;
  const std::optional<PenSight>& sight;  ///< the latest, if there was one

  /// The pen's view about its axis, and the pixel that it told. @param face the tube's picture
  void draw_view(Canvas& canvas, const Rect& face, bool pressed) const;
  /// The signal against time, its threshold, and in words what follows from it.
  void draw_signal(Canvas& canvas, const Rect& room) const;

  /// What of the signal draw_signal() shows.
  static Exposure shown(Seconds tripped);

 private:
  void draw_curve(Canvas& canvas, const Rect& plot) const;
};

}  // namespace kinescope
