#include "display/vector/input/hpgl_plotter.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace kinescope {
namespace {

/// The part of a line within a rectangle. Source: Liang and Barsky, 1984.
std::optional<std::pair<glm::dvec2, glm::dvec2>> clipped(glm::dvec2 from, glm::dvec2 to,
                                                         glm::dvec2 least, glm::dvec2 most) {
  double enter = 0, leave = 1;
  const glm::dvec2 d = to - from;
  for (int axis = 0; axis < 2; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const double room = side > 0 ? most[axis] - from[axis] : from[axis] - least[axis];
      const double towards = side * d[axis];
      if (towards == 0 && room < 0) return std::nullopt;
      if (towards < 0) enter = std::max(enter, room / towards);
      if (towards > 0) leave = std::min(leave, room / towards);
    }
  }
  if (enter > leave) return std::nullopt;
  return std::pair(enter == 0 ? from : from + enter * d, leave == 1 ? to : from + leave * d);
}

}  // namespace

glm::dvec2 HpglPlotter::turned(glm::dvec2 at) const {
  switch (turn_quarters & 3) {
    case 1:
      return {-at.y, at.x};
    case 2:
      return -at;
    case 3:
      return {at.y, -at.x};
    default:
      return at;
  }
}

void HpglPlotter::stroke(glm::dvec2 from, glm::dvec2 to) {
  if (in_polygon || pen_number == 0) return;
  if (clipped) {
    const auto part = kinescope::clipped(from, to, window_least, window_most);
    if (!part) return;
    std::tie(from, to) = *part;
  }
  const auto far = [](glm::dvec2 p) { return !(std::max(std::abs(p.x), std::abs(p.y)) < 1e9); };
  if (far(from) || far(to)) return;  // no plotter reaches there
  out->line(turned(from), turned(to), pen_intensity());
}

/// Pens have no currents: each of the carousel's eight is drawn a little dimmer than the last.
float HpglPlotter::pen_intensity() const {
  return has_default_pens ? 1 - 0.08f * static_cast<float>((pen_number - 1) % 8) : 1;
}

void HpglPlotter::go(glm::dvec2 to) {
  if (in_polygon) {
    if (contour_due) {
      polygon.emplace_back();
      contour_due = false;
    }
    if (polygon.empty()) new_contour();
    polygon.back().points.push_back(to);
    polygon.back().edges.push_back(down);
  } else if (down) {
    stroke(pen, to);
  }
  dot_due = false;
  pen = to;
}

void HpglPlotter::set_down(bool is_down) {
  if (!is_down && dot_due) stroke(pen, pen);
  if (is_down != down) dot_due = is_down && !in_polygon;
  down = is_down;
}

void HpglPlotter::use_pen() { out->use(pen_in_hand()); }

void HpglPlotter::new_contour() {
  polygon.emplace_back();
  polygon.back().points.push_back(pen);
  polygon.back().edges.push_back(false);
}

}  // namespace kinescope
