// One random frame of the rasterizer, drawn many ways that must agree.
#pragma once

#include <cstdint>
#include <string>

namespace kinescope::soak {

/// Draws frame `seed`: random calls, sizes, formats, samples, threads, tiles and instruction sets,
/// with impossible numbers among the vertices and attributes.
/// @return what disagreed with the reference rasterizer or between two runs; empty if nothing did
std::string check_random_frame(std::uint64_t seed);

/// The same for a scene through the whole pipeline: random meshes, nodes, cameras and settings.
std::string check_random_scene(std::uint64_t seed);

}  // namespace kinescope::soak
