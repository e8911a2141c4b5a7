// Puts the faces of an OBJ file together into meshes, one a material.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/io/reader.h"

namespace kinescope {

/// What the lines of an OBJ file hold, in the order of the file.
struct ObjData {
  /// Position, texture coordinate and normal, counted from 0; below 0: none.
  using Corner = std::array<std::int64_t, 3>;
  struct Face {
    std::size_t end = 0;  ///< of its corners; they begin where the last face's end
    std::size_t line = 0;
    int material = -1;
    std::uint32_t smoothing_group = 0;
  };

  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> colours;  ///< linear; empty, or as many as positions
  std::vector<glm::vec2> texcoords;
  std::vector<glm::vec3> normals;
  std::vector<Corner> corners;
  std::vector<Face> faces;
  bool has_smoothing_groups = false;
};

std::vector<Mesh> build_obj_meshes(const ObjData& data, const ModelFile& file);

}  // namespace kinescope
