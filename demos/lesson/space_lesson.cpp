#include "demos/lesson/space_lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

constexpr double kDegreesAPixel = 0.4;  // at the theme's reference height

LessonPlan with_views(LessonPlan plan) {
  plan.views = 2;
  return plan;
}

std::vector<Knob> with_observer(std::vector<Knob> own, double turn_deg, double tilt_deg) {
  own.push_back(number_knob("turn", "Left", "Right", -180, 180, 5, turn_deg, "deg",
                            "where the observer stands: drag the picture"));
  own.push_back(number_knob("tilt", "Down", "Up", -90, 90, 5, tilt_deg, "deg",
                            "how high the observer stands"));
  return own;
}

}  // namespace

Wire wire_house() {
  Wire wire;
  for (const double z : {0.75, -0.75}) {
    for (const glm::dvec2& p : {glm::dvec2(-1, 0), {1, 0}, {1, 1}, {0, 1.75}, {-1, 1}}) {
      wire.points.emplace_back(p, z);
    }
  }
  for (std::size_t i = 0; i < 5; ++i) {
    wire.edges.push_back({i, (i + 1) % 5});
    wire.edges.push_back({i + 5, (i + 1) % 5 + 5});
    wire.edges.push_back({i, i + 5});
  }
  for (const glm::dvec2& p : {glm::dvec2(0.2, 0), {0.2, 0.7}, {0.65, 0.7}, {0.65, 0}}) {
    wire.points.emplace_back(p, 0.75);
  }
  for (std::size_t i = 10; i < 13; ++i) wire.edges.push_back({i, i + 1});
  return wire;
}

Wire wire_box(const glm::dvec3& low, const glm::dvec3& high) {
  Wire wire;
  for (std::size_t i = 0; i < 8; ++i) {
    wire.points.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y,
                             i & 4 ? high.z : low.z);
    for (std::size_t bit = 1; bit < 8; bit *= 2) {
      if (!(i & bit)) wire.edges.push_back({i, i | bit});
    }
  }
  return wire;
}

glm::dvec2 SpacePane::place(const glm::dvec3& p) const {
  const glm::dvec3 seen = apply(picture_from_world(from), p - centre);
  const double scale = 0.5 * std::min(world.columns(), world.rows()) / reach;
  return {0.5 * world.columns() + scale * seen.x, 0.5 * world.rows() - scale * seen.y};
}

void SpacePane::add_line(Overlay& over, const glm::dvec3& a, const glm::dvec3& b, Srgb8 colour,
                         int pane) const {
  over.guides.push_back({place(a), place(b), colour, pane});
}

void SpacePane::add_label(Overlay& over, const glm::dvec3& at, std::string words, Srgb8 colour,
                          int pane) const {
  over.labels.push_back({place(at), std::move(words), colour, pane});
}

void SpacePane::add_axes(Overlay& over, double length, int pane, int axes) const {
  constexpr std::array kInks = {theme::kRed, theme::kGreen, theme::kBlue};
  for (int i = 0; i < axes; ++i) {
    glm::dvec3 tip(0.0);
    tip[i] = length;
    const Srgb8 ink = kInks[static_cast<std::size_t>(i)];
    add_line(over, {0, 0, 0}, tip, ink, pane);
    add_label(over, 1.1 * tip, std::string(1, "xyz"[i]), ink, pane);
  }
}

namespace {

std::string lines_of(const glm::dmat4& matrix, std::span<const int> kept) {
  std::string text;
  for (const int row : kept) {
    text += '[';
    // Adding 0 turns a negative zero into 0.
    for (const int column : kept) {
      text += fmt::format("{:8.3f}", std::round(matrix[column][row] * 1000) / 1000 + 0.0);
    }
    text += " ]\n";
  }
  return text;
}

}  // namespace

std::string matrix_lines(const glm::dmat4& matrix) {
  constexpr std::array kAll = {0, 1, 2, 3};
  return lines_of(matrix, kAll);
}

std::string plane_matrix_lines(const glm::dmat4& matrix) {
  constexpr std::array kPlane = {0, 1, 3};
  return lines_of(matrix, kPlane);
}

glm::dmat4 in_space(const glm::dmat3& matrix) {
  glm::dmat4 space(1.0);
  constexpr std::array kPlane = {0, 1, 3};
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      space[kPlane[std::size_t(column)]][kPlane[std::size_t(row)]] = matrix[column][row];
    }
  }
  return space;
}

SpaceLesson::SpaceLesson(const DemoSetup& setup, LessonPlan plan, std::vector<Knob> own, int pane,
                         double turn_deg, double tilt_deg)
    : Lesson(setup, with_views(std::move(plan)), with_observer(own, turn_deg, tilt_deg)),
      pane_(pane),
      turn_knob_(static_cast<int>(own.size())) {}

SpacePane SpaceLesson::view(const glm::dvec3& centre, double reach) const {
  return {world(), {knob(turn_knob_).value, knob(turn_knob_ + 1).value}, centre, reach};
}

bool SpaceLesson::answer(const InputEvent& event, LessonScreen::Spot at) {
  const glm::ivec2 mouse(event.x, event.y);
  if (event.kind == InputKind::kMouseDown && event.button == MouseButton::kLeft) {
    held_ = at.pane == pane_;
    held_at_ = mouse;
    held_angles_ = {knob(turn_knob_).value, knob(turn_knob_ + 1).value};
  }
  if (event.kind == InputKind::kMouseUp) held_ = false;
  if (event.kind == InputKind::kMouseMove && held_) {
    const double pixel = kDegreesAPixel / double(theme::scale_for(height()));
    const glm::dvec2 angles = held_angles_ + glm::round(glm::dvec2(mouse - held_at_) * pixel);
    turn(turn_knob_, std::remainder(angles.x, 360.0));
    turn(turn_knob_ + 1, std::clamp(angles.y, -90.0, 90.0));
  }
  return false;  // the next step takes the turned knobs
}

}  // namespace kinescope
