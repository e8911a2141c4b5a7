// What a surface is made of, as model files give it.
#pragma once

#include <glm/vec3.hpp>
#include <string>

namespace kinescope {

/// A Phong material; colours are linear. Texture indices point into the scene's textures; -1: none.
struct Material {
  std::string name;
  glm::vec3 base_colour{0.8f};  ///< ambient and diffuse reflectance
  float opacity = 1.0f;         ///< times the texture's alpha; 0 shows all that lies behind
  glm::vec3 specular{0.0f};     ///< reflectance of the highlight
  float shininess = 32.0f;      ///< exponent of the reflection-vector law
  glm::vec3 emission{0.0f};
  int base_texture = -1;  ///< multiplies base_colour
  bool double_sided = false;
};

}  // namespace kinescope
