// Model files: one entry for every format.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/scene.h"
#include "raster/base/error.h"

namespace kinescope {

/// Reads a model, choosing the reader by content where the format has a mark (glTF, GLB, PLY, OFF,
/// binary STL by its size), else by the file's ending. Textures and material files are looked for
/// beside the model. Missing normals are computed. What can be worked around is told in `warnings`.
/// @throws Error (bad input) naming the file and the place in it
Scene import_model(const std::string& path, Warnings& warnings);

/// Whether a file is a model, by the ending of its name or by its first bytes.
bool looks_like_model(const std::string& path, std::span<const std::uint8_t> first_bytes);

}  // namespace kinescope
