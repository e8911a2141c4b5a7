// A drawing's strokes as a display file that refreshes them.
#pragma once

#include <span>
#include <vector>

#include "display/vector/display_memory.h"
#include "display/vector/machine.h"
#include "display/vector/segment.h"

namespace kinescope {

/// The words of a list for a machine of the generic words that draws lines. Strokes, in the
/// machine's units, are rounded to its points; those at one point are left out, and of equal ones
/// all but one. Strokes that meet follow each other, so that the beam seldom goes a dark way: a
/// trail goes on as long as a stroke is left where it came to. A list that is drawn within a tick
/// of the machine's clock waits for it; a longer one begins again at once.
/// @throws Error (usage) if the machine draws no lines by such words
std::vector<Word> stroke_list(std::span<const VectorSegment> strokes, const VectorMachine& machine);

}  // namespace kinescope
