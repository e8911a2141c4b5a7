// How a beam draws plain strokes: one move after the other, in time.
#pragma once

#include <vector>

#include "display/vector/beam_move.h"
#include "display/vector/input/drawing.h"
#include "display/vector/machine.h"

namespace kinescope {

/// Adds the moves that draw strokes from `begin` on, in the order in which they lie there: the area
/// of the drawing as large as the machine's points hold it, in their middle. Lit ways take
/// their time at the machine's usual speed, so that an intensity of 1 is as bright as white, and a
/// point as bright as a line; dark ones take as long as its `move`. Colours are those of the pens;
/// a tube of one colour has their luminance. Of texts, broken lines and events see beam_strokes();
/// a move's address is its stroke's number. @return when the last has ended
Seconds draw_strokes_of(const VectorDrawing& strokes, const VectorMachine& machine, Seconds begin,
                        std::vector<BeamMove>& moves);

}  // namespace kinescope
