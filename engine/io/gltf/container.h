// The frame of a GLB file and the shape of glTF's JSON, checked before the library sees them.
#pragma once

#include "engine/io/reader.h"

namespace kinescope {

/// True for GLB, false for JSON text.
bool is_glb(const ModelFile& file);

/// Refuses what the library would read past the end of, recurse too deeply into, or multiply in
/// memory: chunks that leave the file, deep nesting, many buffers that all copy the one binary
/// chunk.
/// @throws Error (bad input)
void check_gltf_container(const ModelFile& file);

}  // namespace kinescope
