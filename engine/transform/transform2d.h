// Two-dimensional transformations as matrices in homogeneous coordinates, for column vectors:
// p' = M p, so that in a product the rightmost factor acts first. Angles are counter-clockwise.
// Source: Foley, van Dam, Feiner, Hughes, "Computer Graphics: Principles and Practice", 1990,
// ch. 5.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace kinescope {

glm::dmat3 translation(const glm::dvec2& by);
glm::dmat3 scaling(double factor);
/// Differential where the factors differ.
glm::dmat3 scaling(const glm::dvec2& factors);
glm::dmat3 scaling_about(const glm::dvec2& fixed, const glm::dvec2& factors);
glm::dmat3 rotation_deg(double angle_deg);
glm::dmat3 rotation_about_deg(const glm::dvec2& pivot, double angle_deg);
/// x' = x + along_x y, y' = y + along_y x.
glm::dmat3 shear(double along_x, double along_y);

glm::dmat3 reflection_in_x_axis();
glm::dmat3 reflection_in_y_axis();
glm::dmat3 reflection_in_origin();
glm::dmat3 reflection_in_diagonal();  ///< the line y = x
/// The line y = slope x + intercept.
glm::dmat3 reflection_in_line(double slope, double intercept);
/// Any line, vertical ones too. The direction need not be of unit length.
/// @throws Error (bad input) if it has no length, or none that is finite
glm::dmat3 reflection_in_line(const glm::dvec2& through, const glm::dvec2& direction);

/// The point where a matrix puts p, after the division by w.
glm::dvec2 apply(const glm::dmat3& matrix, const glm::dvec2& p);

/// A geometric transformation moves the object, a coordinate transformation moves the axes: the one
/// is the other's inverse. @throws Error (bad input) if the matrix has none
glm::dmat3 coordinate_from_geometric(const glm::dmat3& geometric);

/// One factor of a composed transformation, in the order of action.
struct TransformStep2 {
  std::string name;
  glm::dmat3 matrix;
};
/// The product, last step leftmost.
glm::dmat3 compose(std::span<const TransformStep2> steps);

/// The textbook's chains, for showing each step: their products are the functions above.
/// Any matrix about a point: there, the matrix, and back.
std::vector<TransformStep2> about_steps(const glm::dvec2& fixed, const std::string& name,
                                        const glm::dmat3& matrix);
std::vector<TransformStep2> rotation_about_steps(const glm::dvec2& pivot, double angle_deg);
std::vector<TransformStep2> scaling_about_steps(const glm::dvec2& fixed, const glm::dvec2& factors);
std::vector<TransformStep2> reflection_in_line_steps(double slope, double intercept);

}  // namespace kinescope
