// A pane that shows one coordinate space: a solid, and lines and words about it, of which those
// behind the solid are faint.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <string_view>

#include "demos/easel.h"
#include "demos/studio.h"
#include "demos/ui/canvas.h"

namespace kinescope {

class SpaceView {
 public:
  /// @param room     in the picture, whole pixels
  /// @param observer who looks at the space, not the demo's own camera
  SpaceView(Easel& easel, const Studio& studio, Image<Srgb8>& picture, const Rect& room,
            Camera observer);

  /// Draws a mesh of this space and all of the pane's background. Lines come after it.
  void solid(const Mesh& mesh, bool wireframe);
  void line(glm::vec3 a, glm::vec3 b, float width, Srgb8 colour);
  /// Arrows of one length along x, y and z.
  void axes(glm::vec3 origin, float length, const std::array<std::string_view, 3>& names);
  void grid(float reach, float pitch);
  /// The edges of a box, corner i at x = i & 1, y = i & 2, z = i & 4.
  void box(const std::array<glm::vec3, 8>& corners, float width, Srgb8 colour);
  void label(glm::vec3 place, std::string_view text, Srgb8 colour);
  void caption(std::string_view title, std::string_view note);
  /// The pane's own pixels, from its top left corner right and down.
  void pixel_axes();
  void matrix(std::string_view name, const glm::mat4& m);

 private:
  bool project(glm::vec3& a, glm::vec3& b) const;
  bool hidden(glm::vec3 device) const;

  Easel& easel_;
  const Studio& studio_;
  Image<Srgb8>& picture_;
  Canvas canvas_;
  Rect room_;
  Camera observer_;
  glm::mat4 clip_from_space_;
  float scale_;
};

}  // namespace kinescope
