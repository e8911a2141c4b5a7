// A drawing as a picture that browsers and printers take.
#pragma once

#include <string>

#include "display/vector/input/drawing.h"

namespace kinescope {

/// Strokes in the colours of their pens on black, one user unit a device unit; characters as
/// strokes. `path` "-" is standard output. @throws Error (cannot write)
void write_svg(const std::string& path, const VectorDrawing& drawing);

}  // namespace kinescope
