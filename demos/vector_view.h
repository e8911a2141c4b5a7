// A drawing of strokes, or a terminal that is drawn on, in a window.
#pragma once

#include <functional>
#include <memory>

#include "demos/demo.h"
#include "demos/vector_film.h"
#include "demos/vector_terminal.h"

namespace kinescope {

/// @param make what is shown in a window of a size, from its beginning. The past cannot be stepped
/// back to.
DemoInfo vector_view(std::function<VectorShow(Size, Workers&)> make);

/// What a copier puts on paper of a Tektronix page, to a free name here; the user is told which.
void copy_to_paper(const VectorDrawing& page, Size size, Workers& workers);

/// Live: what programs draw appears on a storage tube as it arrives, what they plot as a list. A
/// key or a click answers a crosshair; else p erases the page and h copies it. The past cannot be
/// stepped back to.
DemoInfo vector_view(std::shared_ptr<VectorTerminal> terminal);

}  // namespace kinescope
