// The path data of SVG ("d" attributes). Source: W3C, SVG 1.1, chapter 8 and appendix F.6.
#pragma once

#include <string_view>

#include "raster/path/path.h"

namespace kinescope {

/// All commands, absolute and relative; arcs become cubics, within 1/3000 of their radius. After a
/// fault the path ends, as the standard says, with what was right before it.
/// @param fault  if given, receives where in the text the fault is, or npos if there is none
Path parse_svg_path(std::string_view text, std::size_t* fault = nullptr);

}  // namespace kinescope
