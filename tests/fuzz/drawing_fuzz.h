// What the fuzz targets check of a decoded drawing.
#pragma once

#include <cmath>
#include <cstdlib>

#include "display/vector/input/beam_strokes.h"
#include "tests/fuzz/fuzz.h"

namespace kinescope {

/// Order, and strokes that any beam can follow.
inline void check_drawing(const VectorDrawing& drawing) {
  std::size_t last = 0;
  for (const auto& change : drawing.pens) {
    if (change.segments < last || change.segments > drawing.segments.size()) std::abort();
    last = change.segments;
  }
  if (!(drawing.size.x > 0 && drawing.size.y > 0)) std::abort();
  for (const VectorSegment& s : drawing.segments) {
    if (!std::isfinite(s.x1 + s.y1 + s.x2 + s.y2)) std::abort();
    if (!(s.intensity >= 0 && s.intensity <= 1)) std::abort();
  }
  if (drawing.segments.size() < 10000) beam_strokes(drawing);
  pages(drawing);
}

}  // namespace kinescope
