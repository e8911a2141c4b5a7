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

/// Live: what programs draw appears on a storage tube as it arrives. A key or a click answers a
/// crosshair. The past cannot be stepped back to.
DemoInfo vector_view(std::shared_ptr<VectorTerminal> terminal);

}  // namespace kinescope
