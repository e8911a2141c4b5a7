// Instructions that set the page, the pens and the characters.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "display/vector/input/hpgl_plotter.h"

namespace kinescope {
namespace {

using Numbers = std::vector<double>;
constexpr double kMostUnits = 1e7;  ///< 250 m: no plotter goes further

double number(const Numbers& n, std::size_t i, double otherwise) {
  return i < n.size() ? n[i] : otherwise;
}
glm::dvec2 pair(const Numbers& n, std::size_t i) {
  return glm::clamp(glm::dvec2(n[i], n[i + 1]), -kMostUnits, kMostUnits);
}

void set_scale(HpglPlotter& p, const Numbers& n) {
  p.scaled = false;
  p.scale_numbers = n;
  if (n.size() < 4) return p.scale_numbers.clear();
  const int type = static_cast<int>(std::clamp(number(n, 4, 0), 0.0, 2.0));
  const glm::dvec2 least{n[0], n[2]}, second{n[1], n[3]}, page = p.p2 - p.p1;
  glm::dvec2 scale = type == 2 ? second : page / (second - least);
  glm::dvec2 start = p.p1;
  if (type == 1) {
    const double same = std::min(std::abs(scale.x), std::abs(scale.y));
    scale = {std::copysign(same, scale.x), std::copysign(same, scale.y)};
    const glm::dvec2 share{number(n, 5, 50) / 100, number(n, 6, 50) / 100};
    start += share * (page - scale * (second - least));
  }
  // A scale of nothing, or onto nothing, is none.
  const glm::dvec2 size = glm::abs(scale);
  if (!(size.x > 1e-9 && size.y > 1e-9 && size.x < 1e9 && size.y < 1e9)) return;
  p.scaled = true;
  p.scale = scale;
  p.offset = start - scale * least;
}

void set_corners(HpglPlotter& p, const Numbers& n) {
  const glm::dvec2 page = p.p2 - p.p1;
  p.p1 = n.size() >= 2 ? pair(n, 0) : glm::dvec2(0);
  p.p2 = n.size() >= 4 ? pair(n, 2) : n.size() >= 2 ? p.p1 + page : p.page;
  if (!p.scale_numbers.empty()) set_scale(p, Numbers(p.scale_numbers));
}

void set_defaults(HpglPlotter& p, const Numbers&) {
  HpglPlotter fresh(*p.out);
  fresh.name = p.name;
  fresh.fill_strokes = p.fill_strokes;
  fresh.page = p.page;
  fresh.p1 = p.p1;
  fresh.p2 = p.p2;
  fresh.pen = fresh.line_start = p.pen;
  fresh.pen_number = p.pen_number;
  fresh.pens = p.pens;
  fresh.has_default_pens = p.has_default_pens;
  fresh.turn_quarters = p.turn_quarters;
  fresh.down = p.down;
  for (VectorPen& pen : fresh.pens) pen.style = LineStyle::kSolid;
  p = std::move(fresh);
  p.use_pen();
}

void initialize(HpglPlotter& p, const Numbers& n) {
  p.set_down(false);
  p.p1 = {0, 0};
  p.p2 = p.page = HpglPlotter::kDefaultPage;
  p.turn_quarters = 0;
  set_defaults(p, n);
}

/// The size of the page: where P1 and P2 lie until IP moves them.
void page_size(HpglPlotter& p, const Numbers& n) {
  if (n.empty()) return;
  p.page = n.size() >= 2 ? pair(n, 0) : glm::dvec2(n[0]);
  set_corners(p, {});
}

/// Without numbers the corners P1 and P2, as hp2xx has it.
void set_window(HpglPlotter& p, const Numbers& n) {
  const bool given = n.size() >= 4;
  p.clipped = true;
  const glm::dvec2 a = given ? p.plotter_units(pair(n, 0)) : p.p1;
  const glm::dvec2 b = given ? p.plotter_units(pair(n, 2)) : p.p2;
  p.window_least = glm::min(a, b);
  p.window_most = glm::max(a, b);
}

/// A new page begins as IN leaves it (so does hp2xx), but for the pens.
void new_page(HpglPlotter& p, const Numbers& n) {
  initialize(p, n);
  p.out->event(DrawingEvent::Kind::kErase);
}

void turn_page(HpglPlotter& p, const Numbers& n) {
  p.turn_quarters = static_cast<int>(std::clamp(number(n, 0, 0), -360.0, 360.0) / 90) & 3;
}

void select_pen(HpglPlotter& p, const Numbers& n) {
  p.set_down(false);
  p.pen_number = static_cast<int>(std::clamp(number(n, 0, 0), 0.0, 255.0));
  p.use_pen();
}

/// A pen that is black on paper is white on a tube.
void pen_colour(HpglPlotter& p, const Numbers& n) {
  if (n.size() < 4) return;
  const auto code = [&](std::size_t i) {
    return static_cast<std::uint8_t>(std::clamp(n[i], 0.0, 255.0));
  };
  Srgb8 colour{code(1), code(2), code(3), 255};
  if (colour.r == 0 && colour.g == 0 && colour.b == 0) colour = {255, 255, 255, 255};
  p.pens[static_cast<std::size_t>(std::clamp(n[0], 0.0, 255.0))].colour = colour;
  p.has_default_pens = false;
  p.use_pen();
}

void width_unit(HpglPlotter& p, const Numbers& n) { p.relative_width = number(n, 0, 0) == 1; }

void pen_width(HpglPlotter& p, const Numbers& n) {
  const double given = std::clamp(number(n, 0, 0.35), 0.0, 1e4);
  const double page = glm::length(p.p2 - p.p1);
  const auto width =
      static_cast<float>(p.relative_width ? given * page / 100 : given * HpglPlotter::kUnitsAMm);
  if (n.size() >= 2) {
    p.pens[static_cast<std::size_t>(std::clamp(n[1], 0.0, 255.0))].width = width;
  } else {
    for (VectorPen& pen : p.pens) pen.width = width;
  }
  p.use_pen();
}

void pen_thickness(HpglPlotter& p, const Numbers& n) {
  p.pen_thickness = std::clamp(number(n, 0, 0.3), 0.01, 100.0) * HpglPlotter::kUnitsAMm;
}

void line_type(HpglPlotter& p, const Numbers& n) {
  constexpr std::array kStyles{LineStyle::kDotted,    LineStyle::kDotted,  LineStyle::kShortDash,
                               LineStyle::kLongDash,  LineStyle::kDotDash, LineStyle::kDotDash,
                               LineStyle::kShortDash, LineStyle::kDotDash, LineStyle::kDotDash};
  const double type = std::abs(number(n, 0, -1));
  const LineStyle style = n.empty() || !(type < kStyles.size())
                              ? LineStyle::kSolid
                              : kStyles[static_cast<std::size_t>(type)];
  for (VectorPen& pen : p.pens) pen.style = style;
  p.use_pen();
}

void fill_type(HpglPlotter& p, const Numbers& n) {
  p.fill_type = static_cast<int>(std::clamp(number(n, 0, 1), 0.0, 100.0));
  if (n.size() > 1) p.fill_spacing = n[1];
  if (n.size() > 2) p.fill_degrees = n[2];
}

void direction(HpglPlotter& p, const Numbers& n) {
  p.relative_direction = false;
  p.direction = n.size() >= 2 ? pair(n, 0) : glm::dvec2(1, 0);
}
void direction_relative(HpglPlotter& p, const Numbers& n) {
  direction(p, n);
  p.relative_direction = n.size() >= 2;
}

void size_in_cm(HpglPlotter& p, const Numbers& n) {
  p.relative_size = n.size() < 2;
  p.size = n.size() < 2 ? HpglPlotter(*p.out).size : HpglPlotter::kUnitsACm * pair(n, 0);
}
void size_relative(HpglPlotter& p, const Numbers& n) {
  p.relative_size = true;
  p.size = n.size() < 2 ? HpglPlotter(*p.out).size : pair(n, 0) / 100.0;
}

void slant(HpglPlotter& p, const Numbers& n) { p.slant = number(n, 0, 0); }
void extra_space(HpglPlotter& p, const Numbers& n) {
  p.extra_space = {number(n, 0, 0), number(n, 1, 0)};
}
void label_origin(HpglPlotter& p, const Numbers& n) {
  p.label_origin = static_cast<int>(std::clamp(number(n, 0, 1), 0.0, 100.0));
}
void vertical(HpglPlotter& p, const Numbers& n) { p.vertical = number(n, 0, 0) == 1; }
void tick_length(HpglPlotter& p, const Numbers& n) {
  p.tick = {number(n, 0, 0.5) / 100, n.size() == 1 ? 0 : number(n, 1, 0.5) / 100};
}

}  // namespace

std::span<const HpglAction> hpgl_setup_actions() {
  static constexpr HpglAction kActions[] = {
      {"IN", initialize},         {"BP", initialize},   {"PG", new_page},      {"AF", new_page},
      {"AH", new_page},           {"FR", new_page},     {"DF", set_defaults},  {"PS", page_size},
      {"IP", set_corners},        {"SC", set_scale},    {"IW", set_window},    {"RO", turn_page},
      {"SP", select_pen},         {"PC", pen_colour},   {"WU", width_unit},    {"PW", pen_width},
      {"PT", pen_thickness},      {"LT", line_type},    {"FT", fill_type},     {"DI", direction},
      {"DR", direction_relative}, {"SI", size_in_cm},   {"SR", size_relative}, {"SL", slant},
      {"ES", extra_space},        {"LO", label_origin}, {"DV", vertical},      {"TL", tick_length},
  };
  return kActions;
}

}  // namespace kinescope
