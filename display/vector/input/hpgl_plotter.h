// A pen plotter: what its instructions leave set, and where its pen goes.
#pragma once

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "display/vector/input/drawing.h"

namespace kinescope {

/// One contour of a polygon; edges[i] tells whether the pen was down on the way to points[i].
struct HpglContour {
  std::vector<glm::dvec2> points;
  std::vector<bool> edges;
};

/// State in plotter units (1/40 mm) unless a name says user units. The page that no instruction
/// tells is an A0 sheet, as hp2xx takes it.
struct HpglPlotter {
  static constexpr glm::dvec2 kDefaultPage{33600, 47520};
  static constexpr double kUnitsACm = 400, kUnitsAMm = 40;

  explicit HpglPlotter(VectorDrawing& drawing) : out(&drawing) {}

  // Coordinates.
  glm::dvec2 p1{0}, p2 = kDefaultPage;
  glm::dvec2 page = kDefaultPage;  ///< PS

  bool scaled = false;
  std::vector<double> scale_numbers;  ///< as SC gave them
  glm::dvec2 scale{1}, offset{0};     ///< plotter units = scale * user units + offset
  int turn_quarters = 0;              ///< RO
  bool clipped = false;
  glm::dvec2 window_least{0}, window_most{0};

  // The pen.
  glm::dvec2 pen{0};  ///< where it is, before RO
  bool down = false, relative = false;
  bool dot_due = false;  ///< down, and not moved since
  int pen_number = 1;
  bool has_default_pens = true;
  bool relative_width = false;  ///< PW in shares of P1 to P2
  std::array<VectorPen, 256> pens{};

  // Polygons and fills.
  bool in_polygon = false;
  bool contour_due = false;  ///< the next move begins one
  std::vector<HpglContour> polygon;
  int fill_type = 1;
  double fill_spacing = 0, fill_degrees = 0;  ///< spacing 0: one hundredth of P1 to P2
  std::size_t fill_strokes = 0;               ///< so far
  double pen_thickness = 0.3 * kUnitsAMm;

  // Characters.
  bool relative_size = true;
  glm::dvec2 size{0.005, 0.0075};  ///< shares of P2 - P1, or plotter units
  glm::dvec2 direction{1, 0};      ///< a unit vector, or (relative_direction) in shares
  bool relative_direction = false;
  double slant = 0;
  glm::dvec2 extra_space{0};  ///< shares of a character's cell
  int label_origin = 1;
  bool vertical = false;
  glm::dvec2 line_start{0};  ///< where a carriage return goes
  char symbol = 0;
  std::string label_buffer;
  glm::dvec2 tick{0.005, 0.005};  ///< positive and negative, shares of P2 - P1

  glm::dvec2 plotter_units(glm::dvec2 user) const { return scaled ? scale * user + offset : user; }
  glm::dvec2 user_units(glm::dvec2 at) const { return scaled ? (at - offset) / scale : at; }
  /// Lengths along x, as radii and spacings are given.
  double plotter_length(double user) const { return scaled ? scale.x * user : user; }

  /// A move of the pen, drawing if it is down.
  void go(glm::dvec2 to);
  /// A stroke whatever the pen does; kept for the polygon while one is being defined.
  void stroke(glm::dvec2 from, glm::dvec2 to);
  void set_down(bool is_down);
  void use_pen();
  const VectorPen& pen_in_hand() const {
    return pens[static_cast<std::size_t>(std::clamp(pen_number, 0, 255))];
  }
  float pen_intensity() const;
  void new_contour();

  /// As RO turns the sheet.
  glm::dvec2 turned(glm::dvec2 at) const;

  VectorDrawing* out;
  std::string name = {};  ///< what an Error calls the plot
};

/// An instruction's name and what it does with its numbers.
struct HpglAction {
  std::string_view name;
  void (*obey)(HpglPlotter& plotter, const std::vector<double>& numbers);
};
std::span<const HpglAction> hpgl_setup_actions();    // hpgl_setup.cpp: the page, pens, characters
std::span<const HpglAction> hpgl_drawing_actions();  // hpgl_drawing.cpp: what draws

// hpgl_curves.cpp: chords of `chord_degrees` each, as near as they divide the arc.
void hpgl_arc(HpglPlotter& plotter, glm::dvec2 centre_user, double degrees, double chord_degrees);
void hpgl_arc_through(HpglPlotter& plotter, glm::dvec2 middle, glm::dvec2 end,
                      double chord_degrees);
void hpgl_circle(HpglPlotter& plotter, double radius_user, double chord_degrees);
void hpgl_bezier(HpglPlotter& plotter, glm::dvec2 a, glm::dvec2 b, glm::dvec2 to);
/// A wedge's contour, from its centre and back; radius and angles as EW and WG take them.
HpglContour hpgl_wedge(const HpglPlotter& plotter, double radius_user, double start_degrees,
                       double sweep_degrees, double chord_degrees);

// hpgl_fill.cpp
void hpgl_fill(HpglPlotter& plotter, const std::vector<HpglContour>& polygon);
void hpgl_outline(HpglPlotter& plotter, const std::vector<HpglContour>& polygon);

// hpgl_label.cpp
void hpgl_label(HpglPlotter& plotter, const std::string& text);
void hpgl_print_buffer(HpglPlotter& plotter);
void hpgl_symbol(HpglPlotter& plotter);
void hpgl_character_plot(HpglPlotter& plotter, double spaces, double lines);
void hpgl_new_line(HpglPlotter& plotter);

}  // namespace kinescope
