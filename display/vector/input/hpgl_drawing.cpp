// Instructions that move the pen and draw.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "display/vector/input/hpgl_plotter.h"

namespace kinescope {
namespace {

using Numbers = std::vector<double>;
constexpr double kChordDegrees = 5;
constexpr double kMostUnits = 1e7;  ///< 250 m: no plotter goes further

double number(const Numbers& n, std::size_t i, double otherwise) {
  return i < n.size() ? n[i] : otherwise;
}

/// Plotter units of a pair, absolute or from the pen.
glm::dvec2 target(const HpglPlotter& p, const Numbers& n, std::size_t i, bool relative) {
  glm::dvec2 user{n[i], n[i + 1]};
  if (relative) user += p.user_units(p.pen);
  return glm::clamp(p.plotter_units(user), -kMostUnits, kMostUnits);
}

void move(HpglPlotter& p, const Numbers& n) {
  for (std::size_t i = 0; i + 1 < n.size(); i += 2) {
    p.go(target(p, n, i, p.relative));
    p.line_start = p.pen;
    hpgl_symbol(p);
  }
}
void pen_up(HpglPlotter& p, const Numbers& n) {
  p.set_down(false);
  move(p, n);
}
void pen_down(HpglPlotter& p, const Numbers& n) {
  p.set_down(true);
  move(p, n);
}
void absolute(HpglPlotter& p, const Numbers& n) {
  p.relative = false;
  move(p, n);
}
void relative(HpglPlotter& p, const Numbers& n) {
  p.relative = true;
  move(p, n);
}

void arc(HpglPlotter& p, const Numbers& n, bool is_relative) {
  if (n.size() < 3) return;
  glm::dvec2 centre{n[0], n[1]};
  if (is_relative) centre += p.user_units(p.pen);
  hpgl_arc(p, centre, n[2], number(n, 3, kChordDegrees));
  p.line_start = p.pen;
}
void arc_absolute(HpglPlotter& p, const Numbers& n) { arc(p, n, false); }
void arc_relative(HpglPlotter& p, const Numbers& n) { arc(p, n, true); }

void through(HpglPlotter& p, const Numbers& n, bool is_relative) {
  if (n.size() < 4) return;
  glm::dvec2 middle{n[0], n[1]}, end{n[2], n[3]};
  if (is_relative) {
    middle += p.user_units(p.pen);
    end += p.user_units(p.pen);
  }
  hpgl_arc_through(p, middle, end, number(n, 4, kChordDegrees));
  p.line_start = p.pen;
}
void through_absolute(HpglPlotter& p, const Numbers& n) { through(p, n, false); }
void through_relative(HpglPlotter& p, const Numbers& n) { through(p, n, true); }

void circle(HpglPlotter& p, const Numbers& n) {
  if (!n.empty()) hpgl_circle(p, n[0], number(n, 1, kChordDegrees));
}

void bezier(HpglPlotter& p, const Numbers& n, bool is_relative) {
  for (std::size_t i = 0; i + 5 < n.size(); i += 6) {
    const glm::dvec2 a = target(p, n, i, is_relative), b = target(p, n, i + 2, is_relative);
    hpgl_bezier(p, a, b, target(p, n, i + 4, is_relative));
  }
  p.line_start = p.pen;
}
void bezier_absolute(HpglPlotter& p, const Numbers& n) { bezier(p, n, false); }
void bezier_relative(HpglPlotter& p, const Numbers& n) { bezier(p, n, true); }

/// From the pen to the opposite corner; more pairs give more rectangles from there.
void rectangle(HpglPlotter& p, const Numbers& n, bool is_relative, bool filled) {
  p.dot_due = false;
  for (std::size_t i = 0; i + 1 < n.size(); i += 2) {
    const glm::dvec2 a = p.pen, b = target(p, n, i, is_relative);
    const std::vector<HpglContour> box{
        {{a, {a.x, b.y}, b, {b.x, a.y}, a}, {false, true, true, true, true}}};
    if (filled) {
      hpgl_fill(p, box);
    } else {
      hpgl_outline(p, box);
    }
  }
}
void edge_absolute(HpglPlotter& p, const Numbers& n) { rectangle(p, n, false, false); }
void edge_relative(HpglPlotter& p, const Numbers& n) { rectangle(p, n, true, false); }
void fill_absolute(HpglPlotter& p, const Numbers& n) { rectangle(p, n, false, true); }
void fill_relative(HpglPlotter& p, const Numbers& n) { rectangle(p, n, true, true); }

void wedge(HpglPlotter& p, const Numbers& n, bool filled) {
  if (n.size() < 3) return;
  p.dot_due = false;
  const std::vector<HpglContour> piece{
      hpgl_wedge(p, n[0], n[1], n[2], number(n, 3, kChordDegrees))};
  if (filled) {
    hpgl_fill(p, piece);
  } else {
    hpgl_outline(p, piece);
  }
}
void edge_wedge(HpglPlotter& p, const Numbers& n) { wedge(p, n, false); }
void fill_wedge(HpglPlotter& p, const Numbers& n) { wedge(p, n, true); }

/// The way back to where the contour began.
void close_contour(HpglPlotter& p) {
  if (p.polygon.empty() || p.polygon.back().points.empty()) return;
  HpglContour& contour = p.polygon.back();
  if (contour.points.back() == contour.points.front()) return;
  contour.points.push_back(glm::dvec2(contour.points.front()));
  contour.edges.push_back(p.down);
}

void polygon_mode(HpglPlotter& p, const Numbers& n) {
  const int mode = static_cast<int>(std::clamp(number(n, 0, 0), 0.0, 3.0));
  if (mode == 0) {
    p.polygon.clear();
    p.in_polygon = true;
    p.dot_due = false;
    p.new_contour();
  } else if (p.in_polygon) {
    close_contour(p);
    if (mode == 2) p.in_polygon = false;
    // The next move begins the next contour.
    if (mode == 1) p.contour_due = true;
  }
}
void edge_polygon(HpglPlotter& p, const Numbers&) { hpgl_outline(p, p.polygon); }
/// Even-odd also for FP1, which asks for winding: so does hp2xx.
void fill_polygon(HpglPlotter& p, const Numbers&) { hpgl_fill(p, p.polygon); }

void character_plot(HpglPlotter& p, const Numbers& n) {
  if (n.size() >= 2) {
    hpgl_character_plot(p, std::clamp(n[0], -1e4, 1e4), std::clamp(n[1], -1e4, 1e4));
  } else {
    hpgl_new_line(p);
  }
}
void print_buffer(HpglPlotter& p, const Numbers&) { hpgl_print_buffer(p); }

void tick(HpglPlotter& p, glm::dvec2 way) {
  const glm::dvec2 length = way * glm::abs(p.p2 - p.p1);
  p.stroke(p.pen - p.tick.y * length, p.pen + p.tick.x * length);
}
void tick_x(HpglPlotter& p, const Numbers&) { tick(p, {0, 1}); }
void tick_y(HpglPlotter& p, const Numbers&) { tick(p, {1, 0}); }

}  // namespace

std::span<const HpglAction> hpgl_drawing_actions() {
  static constexpr HpglAction kActions[] = {
      {"PU", pen_up},           {"PD", pen_down},         {"PA", absolute},
      {"PR", relative},         {"AA", arc_absolute},     {"AR", arc_relative},
      {"AT", through_absolute}, {"RT", through_relative}, {"CI", circle},
      {"BZ", bezier_absolute},  {"BR", bezier_relative},  {"EA", edge_absolute},
      {"ER", edge_relative},    {"RA", fill_absolute},    {"RR", fill_relative},
      {"EW", edge_wedge},       {"WG", fill_wedge},       {"PM", polygon_mode},
      {"EP", edge_polygon},     {"FP", fill_polygon},     {"CP", character_plot},
      {"PB", print_buffer},     {"XT", tick_x},           {"YT", tick_y},
  };
  return kActions;
}

}  // namespace kinescope
