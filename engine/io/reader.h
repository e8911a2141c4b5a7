// What the readers of model files share: the file at hand, its complaints, and one function a
// format.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/scene.h"
#include "raster/base/error.h"

namespace kinescope {

/// A model file in memory. Files that it names are looked for beside `path`.
struct ModelFile {
  std::string path;  ///< as the user gave it
  std::span<const std::uint8_t> bytes;
  Warnings& warnings;

  [[noreturn]] void fail(const std::string& what, const std::string& where = {}) const;
  void warn(const std::string& what, const std::string& where = {}) const;
};

enum class ModelFormat { kGltf, kObj, kPly, kStl, kOff };

/// By content where the format has a mark, else by the ending of the file's name.
/// @throws Error (bad input) if it is none of them
ModelFormat detect_format(const ModelFile& file);

/// Reads and finishes a model: see finish().
/// @throws Error (bad input)
Scene read_model(const ModelFile& file, ModelFormat format);

// The readers. They keep every index below the number of vertices, but hand over what numbers the
// file holds: finish() keeps those out that are not finite.
Scene read_gltf(const ModelFile& file);
Scene read_obj(const ModelFile& file);
Scene read_ply(const ModelFile& file);
Scene read_stl(const ModelFile& file);
Scene read_off(const ModelFile& file);

/// Whether the size is that of a binary STL file with as many triangles as its head promises.
bool is_binary_stl(const ModelFile& file);
/// Whether it begins with "solid" and is text.
bool is_ascii_stl(const ModelFile& file);

/// Leaves out triangles with a corner that is not finite and vertices that no triangle uses,
/// makes normals unit length, and computes those that are missing.
/// @throws Error (bad input) if nothing is left to draw
void finish(Scene& scene, const ModelFile& file);

/// A scene of one node that shows every mesh.
Scene scene_of(std::vector<Mesh> meshes);

}  // namespace kinescope
