// glTF's node tree: what stands where, cameras and lights.
#pragma once

#include <tiny_gltf.h>

#include "engine/io/gltf/meshes.h"

namespace kinescope {

/// Adds the nodes of the default scene (of the first where none is named; of all trees where there
/// are no scenes) to `scene`, with their meshes, cameras and lights.
/// @throws Error if a node is its own ancestor
void read_gltf_nodes(const tinygltf::Model& model, GltfMeshes& meshes, const ModelFile& file,
                     Scene& scene);

}  // namespace kinescope
