// A scene on its way from local coordinates to the screen, stage by stage, as a lesson's course.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "demos/lesson/space_lesson.h"
#include "engine/camera.h"
#include "engine/projection/window_to_viewport.h"

namespace kinescope {

class ViewingCourse {
 public:
  /// @throws Error (bad input) for a view volume without size
  ViewingCourse(const Camera& camera, const Axonometric& from, const Window& viewport);

  struct Stage {
    std::string name;
    int pictures = 1;
  };
  const std::vector<Stage>& stages() const { return stages_; }
  /// Where a number of steps leads: how many stages are done, and the share of the next.
  struct Place {
    std::size_t stage = 0;
    double share = 0;
  };
  Place place(std::size_t shown) const;
  std::size_t steps() const;

  /// Pane 0: the scene and its volume as an observer sees them; pane 1: the picture.
  void paint(std::size_t shown, const World& world, int pane, Image<Srgb8>& paper) const;
  Overlay overlay(std::size_t shown, const World& world) const;
  /// A corner of the first house, homogeneous.
  glm::dvec4 traced(std::size_t shown) const;
  std::string note(std::size_t shown) const;
  struct PictureLine {
    Segment2 line;  ///< pixels of pane 1
    Srgb8 ink;
  };
  std::vector<PictureLine> picture() const;

 private:
  struct Line {
    glm::dvec4 from, to;
    Srgb8 ink;
  };
  static constexpr std::size_t kPlaced = 0, kViewing = 1, kClip = 5, kDivision = 11, kViewport = 12;
  static constexpr int kSmooth = 8;

  std::vector<Line> world_lines(double placed) const;
  glm::dmat4 viewed(const Place& at) const;   ///< canonical, or on the way there, from world
  glm::dmat4 divided(const Place& at) const;  ///< the box from the canonical volume
  std::vector<Line> clipped(std::size_t planes) const;  ///< in canonical space, by so many planes
  SpacePane pane(const Place& at, const World& world) const;
  std::array<glm::dvec3, 8> volume(const Place& at) const;
  glm::dvec3 eye(const Place& at) const;
  glm::dvec3 up(const Place& at) const;

  Camera camera_;
  Axonometric from_;
  Window viewport_;
  std::vector<TransformStep3> viewing_;
  glm::dmat4 canonical_from_world_, clip_from_canonical_;
  std::vector<Stage> stages_;
};

}  // namespace kinescope
