// A drawing of strokes, or a terminal that is drawn on, in a window.
#pragma once

#include <memory>

#include "demos/demo.h"
#include "demos/vector_terminal.h"
#include "display/vector/input/drawing.h"

namespace kinescope {

DemoInfo vector_view(VectorDrawing drawing);

/// Live: what programs draw appears as it arrives. A key or a click answers a crosshair. The past
/// cannot be stepped back to.
DemoInfo vector_view(std::shared_ptr<VectorTerminal> terminal);

}  // namespace kinescope
