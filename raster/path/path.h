// Outlines of lines and Bezier curves.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <vector>

#include "raster/path/flatten.h"

namespace kinescope {

/// Contours one after another, in units of their own. Each begins with kMove; filling closes it.
struct Path {
  enum class Verb : std::uint8_t { kMove, kLine, kQuadratic, kCubic, kClose };

  std::vector<Verb> verbs;
  std::vector<glm::vec2> points;  ///< 1, 1, 2, 3 and none for each verb

  void move_to(glm::vec2 to) { add(Verb::kMove, {to}); }
  void line_to(glm::vec2 to) { add(Verb::kLine, {to}); }
  void quadratic_to(glm::vec2 control, glm::vec2 to) { add(Verb::kQuadratic, {control, to}); }
  void cubic_to(glm::vec2 a, glm::vec2 b, glm::vec2 to) { add(Verb::kCubic, {a, b, to}); }
  void close() { verbs.push_back(Verb::kClose); }

 private:
  void add(Verb verb, std::initializer_list<glm::vec2> more) {
    verbs.push_back(verb);
    points.insert(points.end(), more);
  }
};

/// Pixels from a path's units: pixel = m[0] x + m[1] y + m[2].
using PixelsFromPath = glm::mat3x2;

/// Calls sink(from, to) for each edge of the path's closed contours, pixels. No curve is further
/// than the tolerance from its chords. A point that is not finite is passed over, so that what is
/// left still closes.
template <typename Sink>
void path_edges(const Path& path, const PixelsFromPath& place, float tolerance_px, Sink&& sink) {
  const auto at = [&](glm::vec2 p) { return place * glm::vec3(p, 1); };
  glm::vec2 start{0}, pen{0};
  const auto line_to = [&](glm::vec2 to) {
    if (!std::isfinite(to.x + to.y)) return;
    if (std::isfinite(pen.x + pen.y)) {
      sink(pen, to);
    } else {
      start = to;
    }
    pen = to;
  };
  const auto close = [&] {
    if (pen != start) line_to(start);
  };
  const glm::vec2* p = path.points.data();
  for (const Path::Verb verb : path.verbs) {
    switch (verb) {
      case Path::Verb::kMove:
        close();
        start = pen = at(*p++);
        break;
      case Path::Verb::kLine:
        line_to(at(*p++));
        break;
      case Path::Verb::kQuadratic:
        flatten_quadratic(pen, at(p[0]), at(p[1]), tolerance_px, line_to);
        p += 2;
        break;
      case Path::Verb::kCubic:
        flatten_cubic(pen, at(p[0]), at(p[1]), at(p[2]), tolerance_px, line_to);
        p += 3;
        break;
      case Path::Verb::kClose:
        close();
        break;
    }
  }
  close();
}

}  // namespace kinescope
