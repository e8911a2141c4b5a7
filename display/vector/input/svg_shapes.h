// SVG's shapes as paths, and paths as strokes.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <optional>

#include "display/vector/input/xml.h"
#include "raster/path/path.h"

namespace kinescope {

/// The outline of a path, line, polyline, polygon, rect, circle or ellipse, user units; none of
/// other elements. @param viewport what percentages are of
std::optional<Path> svg_shape(const XmlElement& element, glm::vec2 viewport);

/// Calls sink(from, to, begins) for each chord of the path's contours as they are drawn: an open
/// one stays open. `begins` tells that a contour begins with it.
template <typename Sink>
void for_each_chord(const Path& path, const PixelsFromPath& place, float tolerance, Sink&& sink) {
  const auto at = [&](glm::vec2 p) { return place * glm::vec3(p, 1); };
  glm::vec2 start{0}, pen{0};
  bool begins = true, moved = false;
  const auto line_to = [&](glm::vec2 to) {
    if (std::isfinite(pen.x + pen.y + to.x + to.y)) sink(pen, to, begins);
    begins = false;
    moved = true;
    pen = to;
  };
  const glm::vec2* p = path.points.data();
  for (const Path::Verb verb : path.verbs) {
    switch (verb) {
      case Path::Verb::kMove:
        start = pen = at(*p++);
        begins = true;
        moved = false;
        break;
      case Path::Verb::kLine:
        line_to(at(*p++));
        break;
      case Path::Verb::kQuadratic:
        flatten_quadratic(pen, at(p[0]), at(p[1]), tolerance, line_to);
        p += 2;
        break;
      case Path::Verb::kCubic:
        flatten_cubic(pen, at(p[0]), at(p[1]), at(p[2]), tolerance, line_to);
        p += 3;
        break;
      case Path::Verb::kClose:
        if (pen != start || !moved) line_to(start);
        begins = true;
        break;
    }
  }
}

}  // namespace kinescope
