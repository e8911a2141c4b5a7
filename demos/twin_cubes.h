// A wire cube and the same with its depth reversed: two solids of one picture, until the lines that
// each hides are removed.
#pragma once

#include "demos/lesson/space_lesson.h"

namespace kinescope {

struct TwinCubes {
  SpacePane space;  ///< pane 0: both, seen from elsewhere
  bool hides_lines = false;
};
/// Pane 1 holds both pictures, compared.
Course twin_cubes_course(const TwinCubes& twins);

}  // namespace kinescope
