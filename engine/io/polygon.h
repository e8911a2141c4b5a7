// Polygons of a model file, cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/io/reader.h"

namespace kinescope {

using CornerTriple = std::array<std::uint32_t, 3>;

/// Cuts a polygon of n corners into n - 2 triangles of corner numbers, appended to `out`. Where it
/// is concave, by ear clipping (Meisters, "Polygons Have Ears", 1975); a polygon that crosses
/// itself or has more than kMaxEarCorners corners is completed as a fan.
void triangulate(std::span<const glm::vec3> corners, std::vector<CornerTriple>& out);
inline constexpr std::size_t kMaxEarCorners = 512;

/// Adds polygons to a mesh whose positions are all there already.
class PolygonSink {
 public:
  /// @param place_name  what `place` counts in add(): "face" or "line"
  PolygonSink(Mesh& mesh, const ModelFile& file, std::string place_name)
      : mesh_(mesh), file_(file), place_name_(std::move(place_name)) {}

  /// Fewer than three corners are no polygon and are left out. So is one that names a vertex that
  /// is not there; a warning tells how many, and where the first one stands.
  /// @return triangles added
  std::size_t add(std::span<const std::uint32_t> corners, std::size_t place);
  void warn_of_lost() const;

 private:
  Mesh& mesh_;
  const ModelFile& file_;
  std::string place_name_;
  std::vector<glm::vec3> points_;
  std::vector<CornerTriple> triangles_;
  std::size_t lost_ = 0;
  std::size_t first_lost_ = 0;
};

}  // namespace kinescope
