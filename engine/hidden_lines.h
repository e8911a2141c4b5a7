// Hidden-line removal: which parts of a line no face lies before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "engine/camera.h"
#include "engine/wire_scene.h"

namespace kinescope {

/// A part of a line, from 0 at its beginning to 1 at its end.
struct LinePart {
  double from = 0, to = 1;
};

/// Faces as they hide what lies behind them, in clip space. There all lines of sight are parallel
/// to the z axis: a face hides those points whose x, y, w are sums, without a negative share, of
/// its corners', and whose z is greater than that sum's. Each of the four conditions is linear
/// along a line, so what a face hides of it is one part, exactly; faces that cross the eye's plane
/// need no cutting. A grid over the view tells which faces may lie before a line.
/// Source: parts behind volumes bounded by linear inequalities are those of Roberts, "Machine
/// Perception of Three-Dimensional Solids", 1963; edge functions of homogeneous corners those of
/// Olano and Greer, "Triangle Scan Conversion Using 2D Homogeneous Coordinates", 1997.
class HiddenLines {
 public:
  /// Faces that lie before a point by less than this share of its distance (of the depth range,
  /// where parallel) do not hide it: so that lines on a surface are seen, and not eaten by it.
  static constexpr double kLeastBefore = 1e-5;
  /// The same of faces that touch the line's end.
  static constexpr double kLeastBeforeEnd = 1e-10;

  /// @param scene must outlive this. @param clip_points of its points, by the camera
  HiddenLines(const WireScene& scene, const Camera& camera,
              std::span<const glm::dvec4> clip_points);

  /// Memory that is kept from line to line; one a thread, and for one HiddenLines only.
  class Scratch {
    friend class HiddenLines;
    std::vector<std::uint32_t> tried_;  // the line that each face was last tried for
    std::uint32_t line_ = 0;
    std::vector<LinePart> hidden_;
  };

  /// Adds the visible parts, in order, of a line within the view volume.
  /// Faces that it borders do not hide it.
  void visible_parts(const WireEdge& edge, const glm::dvec4& from, const glm::dvec4& to,
                     Scratch& scratch, std::vector<LinePart>& visible) const;

 private:
  struct Face {
    std::array<glm::dvec3, 3> sides;  // edge functions of x, y, w: not negative within
    glm::dvec3 depth;                 // z of the face at x, y, w
    glm::dvec2 low, high;             // box of x / w and y / w
    double nearest;                   // z / w, at least
    int index;                        // in the scene
  };
  void place(std::size_t index, const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c);
  void fill_cells();
  double least_before(const Face& face, const WireEdge& edge) const;
  void hide(const Face& face, const glm::dvec4& from, const glm::dvec4& to, double least,
            std::vector<LinePart>& hidden) const;
  template <typename Body>
  void for_each_cell(const glm::dvec4& from, const glm::dvec4& to, const Body& body) const;
  void gather_hidden(const WireEdge& edge, const glm::dvec4& from, const glm::dvec4& to,
                     Scratch& scratch) const;

  double unit_;  // by so much z grows with a distance, as a share of it
  const WireScene& scene_;
  int cells_;                        // of the grid, along each side
  std::vector<Face> faces_;          // near to far
  std::vector<std::size_t> first_;   // of each cell, in held_; the end of all behind
  std::vector<std::uint32_t> held_;  // faces, near to far
};

}  // namespace kinescope
