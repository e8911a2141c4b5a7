// Counts of covering pieces over their sizes, both as logarithms: the slope is the dimension.
#pragma once

#include <vector>

#include "demos/lesson/lesson.h"
#include "engine/fractals/dimension.h"

namespace kinescope {

struct CoveringPlot {
  std::vector<Covering> coverings;  ///< from the largest pieces to the smallest
  double slope = 0;                 ///< of the line that fits them
  int lit = 0;                      ///< the one that is looked at
};
/// Adds axes and the fitting line. @return the points, all in one step
Track covering_plot(Course& course, const World& world, int pane, const CoveringPlot& plot);

}  // namespace kinescope
