// glTF's materials as Phong materials, with their textures.
#pragma once

#include <tiny_gltf.h>

#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "engine/io/gltf/accessors.h"
#include "engine/io/picture_finder.h"

namespace kinescope {

/// Which texture coordinates a material takes, and how they are moved (KHR_texture_transform).
struct GltfTexcoords {
  int set = 0;
  glm::vec2 offset{0.0f};
  glm::vec2 scale{1.0f};
  float rotation_rad = 0.0f;

  glm::vec2 apply(glm::vec2 uv) const;
};

/// What a surface is made of, in the terms of physically based shading; colours are linear.
struct PhysicalSurface {
  glm::vec3 base_colour{1.0f};
  float metalness = 1.0f;
  float roughness = 1.0f;  ///< perceptual, as glTF has it: its square is the microfacets' alpha
  glm::vec3 reflectance{0.04f};  ///< of what is not metal, seen straight on
};

/// Sets base_colour, specular and shininess.
///
/// The body keeps what is not metal; three tenths of a metal's colour stay in it for the
/// surroundings that a metal would mirror and that Phong's model lacks. The highlight has the
/// reflectance at normal incidence, which for metal is the base colour. A microfacet distribution
/// of width alpha is like Blinn's with the exponent n = 2 / alpha^2 - 2, whose peak is (n + 8) / 8
/// times as high at the same energy; Phong's reflection vector moves twice as fast, so its exponent
/// is n / 4. Sources: Walter et al., "Microfacet Models for Refraction", 2007; Akenine-Moeller et
/// al., "Real-Time Rendering", 3rd edition, 7.8.
void set_phong(Material& material, const PhysicalSurface& surface);

class GltfMaterials {
 public:
  GltfMaterials(const tinygltf::Model& model, const GltfAccessors& accessors, const ModelFile& file,
                Scene& scene);

  /// Adds every material of the model to the scene, under its own number.
  void read_all();
  /// How the base texture of a material is laid on; of any number.
  GltfTexcoords texcoords_of(int material) const;

 private:
  struct Laid {
    int texture = -1;
    GltfTexcoords texcoords;
  };

  void read(const tinygltf::Material& source);
  void read_base(const tinygltf::Material& source, Material& material);
  void read_specular_glossiness(const tinygltf::Material& source, const tinygltf::Value& extension,
                                Material& material);
  void read_emission(const tinygltf::Material& source, Material& material);
  const Image<Srgb8>* picture_of(int texture);
  /// Mean of the channels, sRGB-encoded ones decoded to linear light if asked; white if missing.
  glm::vec3 mean_of(int texture, bool is_colour);
  void lay_base(int texture, const GltfTexcoords& texcoords, const tinygltf::Material& source,
                Material& material);

  const tinygltf::Model& model_;
  const GltfAccessors& accessors_;
  const ModelFile& file_;
  Scene& scene_;
  PictureFinder finder_;
  std::map<int, std::optional<Image<Srgb8>>> pictures_;
  std::map<std::tuple<int, std::string, double>, int> textures_;
  std::vector<GltfTexcoords> texcoords_;
};

}  // namespace kinescope
