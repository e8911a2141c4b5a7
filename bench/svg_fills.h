// The filled paths of a simple SVG drawing, such as Inkscape's tiger: groups, paths, plain colours,
// matrices and translations. No strokes, styles or gradients.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "raster/path/path_painter.h"

namespace kinescope::bench {

struct SvgFills {
  std::deque<Path> paths;  ///< elements stay where they are
  std::vector<FilledPath> fills;
  glm::vec2 size{0};  ///< of the view box, from (0, 0)
};

/// @param path  .svg or .svgz  @throws Error (bad input)
SvgFills read_svg_fills(const std::string& path);

}  // namespace kinescope::bench
