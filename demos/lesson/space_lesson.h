// A lesson in space: the pane shows it as an observer sees it from afar, and dragging the picture
// moves the observer.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/projection/axonometric.h"
#include "engine/transform/transform3d.h"

namespace kinescope {

/// Points and the edges between them.
struct Wire {
  std::vector<glm::dvec3> points;
  std::vector<std::array<std::size_t, 2>> edges;
};
/// A house with a door in its gable, so that it has no symmetry: two wide, about the middle of its
/// floor.
Wire wire_house();
Wire wire_box(const glm::dvec3& low, const glm::dvec3& high);

/// Parallel projection onto a pane.
struct SpacePane {
  World world;
  Axonometric from;
  glm::dvec3 centre{0.0};  ///< in the middle of the pane
  double reach = 4;        ///< from there to the nearer border

  glm::dvec2 place(const glm::dvec3& p) const;
  void add_axes(Overlay& over, double length, int pane, int axes = 3) const;
  void add_line(Overlay& over, const glm::dvec3& from, const glm::dvec3& to, Srgb8 colour,
                int pane) const;
  void add_label(Overlay& over, const glm::dvec3& at, std::string words, Srgb8 colour,
                 int pane) const;
};

template <typename Ink>
void ink_wire(Ink& ink, const SpacePane& view, const Wire& wire, const glm::dmat4& matrix,
              Srgb8 colour) {
  for (const auto& [a, b] : wire.edges) {
    ink_line(ink, view.world, view.place(apply(matrix, wire.points[a])),
             view.place(apply(matrix, wire.points[b])), colour);
  }
}

/// Four lines of a note.
std::string matrix_lines(const glm::dmat4& matrix);
/// Three lines: without z.
std::string plane_matrix_lines(const glm::dmat4& matrix);
/// A matrix of the plane as one of space, z left as it is.
glm::dmat4 in_space(const glm::dmat3& matrix);

class SpaceLesson : public Lesson {
 protected:
  /// @param pane where dragging moves the observer; the knobs for it come behind the demo's own
  SpaceLesson(const DemoSetup& setup, LessonPlan plan, std::vector<Knob> own, int pane = 0,
              double turn_deg = 30, double tilt_deg = 20);

  SpacePane view(const glm::dvec3& centre, double reach) const;
  bool answer(const InputEvent& event, LessonScreen::Spot at) override;

 private:
  int pane_, turn_knob_;
  bool held_ = false;
  glm::ivec2 held_at_{0};
  glm::dvec2 held_angles_{0};
};

}  // namespace kinescope
