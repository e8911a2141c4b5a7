// A figure in space carried by matrix after matrix, as a lesson's course.
#pragma once

#include <string>
#include <vector>

#include "demos/lesson/space_lesson.h"

namespace kinescope {

struct SpaceCourse {
  SpacePane view;
  std::vector<TransformStep3> steps{};
  int smooth = 1;  ///< pictures a matrix
  Wire figure = wire_house();
  std::size_t traced = 3;  ///< the point whose coordinates are told
  bool brief = false;      ///< tells the product only, where there is little room
  bool flat = false;       ///< in the plane z = 0: told as two-dimensional
  Wire carried{};          ///< an axis, or a plane: goes the same way, drawn as guides
};

/// The matrix of a part of the way: whole steps, and a share of the next.
glm::dmat4 matrix_at(const SpaceCourse& course, std::size_t shown);

/// Adds a track, and what is painted in its pane. The last step but one plots the figure.
void show(SpaceCourse space, Course& course, int pane, std::string name);

/// Without factors that do nothing: what needs no moving to the origin is two shorter.
std::vector<TransformStep3> without_identities(std::vector<TransformStep3> steps);

/// The product's determinant and what it keeps.
std::vector<std::string> class_remarks(const glm::dmat4& product);

}  // namespace kinescope
