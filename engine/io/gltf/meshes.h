// glTF's primitives as meshes.
#pragma once

#include <tiny_gltf.h>

#include <map>
#include <optional>
#include <vector>

#include "engine/io/gltf/accessors.h"
#include "engine/io/gltf/materials.h"

namespace kinescope {

class GltfMeshes {
 public:
  GltfMeshes(const tinygltf::Model& model, GltfAccessors& accessors, const GltfMaterials& materials,
             const ModelFile& file, Scene& scene);

  /// The numbers in Scene::meshes of a glTF mesh's primitives, which are read when first asked for.
  const std::vector<int>& numbers_of(int mesh);

  void warn_of_lost() const;

 private:
  std::optional<Mesh> read(const tinygltf::Primitive& primitive);
  std::vector<std::uint32_t> triangles_of(const tinygltf::Primitive& primitive,
                                          std::size_t vertex_count);
  const GltfNumbers* attribute(const tinygltf::Primitive& primitive, const std::string& name,
                               int least_components, std::size_t vertex_count);
  std::vector<std::uint32_t> take_used(std::vector<std::uint32_t>& indices,
                                       std::size_t vertex_count);
  void spend(std::size_t indices);

  const tinygltf::Model& model_;
  GltfAccessors& accessors_;
  const GltfMaterials& materials_;
  const ModelFile& file_;
  Scene& scene_;
  std::map<int, std::vector<int>> numbers_;
  std::vector<std::uint32_t> new_index_;
  std::uint64_t budget_;  ///< indices that may still be read
  std::size_t lost_primitives_ = 0;
  std::size_t lost_triangles_ = 0;
  int first_lost_ = -1;
};

}  // namespace kinescope
