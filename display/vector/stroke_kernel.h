// Strokes onto a tile of pixels, in SIMD.
#pragma once

#include <cstdint>
#include <span>

#include "display/vector/beam_stroke.h"

namespace kinescope {

/// Tiles are squares of so many pixels.
inline constexpr int kBeamTile = 64;
/// Floats of one plane of a tile: its rows, and room after the last for a vector to end in.
inline constexpr int kBeamTilePlane = kBeamTile * kBeamTile + 16;

/// A tile: its upper left pixel, and `planes` planes of kBeamTilePlane floats.
struct BeamTile {
  int x = 0, y = 0;
  int planes = 1;
  float* light = nullptr;
};

/// Adds strokes[order[0]], strokes[order[1]] ... to the tile: to each plane p by
/// weights[stroke * planes + p] times what stroke_share() says. They must be finite and less than
/// 2^14 pixels away.
void draw_strokes(std::span<const BeamStroke> strokes, const float* weights,
                  std::span<const std::uint32_t> order, const BeamTile& tile);

}  // namespace kinescope
