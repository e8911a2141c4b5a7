// Everything that a drawing holds as plain strokes.
#pragma once

#include "display/vector/input/drawing.h"

namespace kinescope {

/// The drawing with its characters drawn and its broken lines broken, in the order in which they
/// were drawn: only solid strokes are left, no text, no event. What is not finite is left out.
VectorDrawing beam_strokes(const VectorDrawing& drawing);

}  // namespace kinescope
