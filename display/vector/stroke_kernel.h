// Strokes and spots onto a tile of pixels, in SIMD.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

/// What is drawn together: strokes, then spots, numbered in this order, and for each of them the
/// weight of each plane. They must be finite, strokes less than 2^14 pixels away.
struct BeamMarks {
  std::vector<BeamStroke> strokes;
  std::vector<float> stroke_weights;
  std::vector<BeamSpots> spots;
  std::vector<float> spot_weights;

  std::size_t size() const { return strokes.size() + spots.size(); }
  void clear() {
    strokes.clear(), stroke_weights.clear();
    spots.clear(), spot_weights.clear();
  }
};

/// The planes that a tile may have.
inline constexpr int kMostBeamPlanes = 64;

/// Marks lie anywhere in memory: asked for so many ahead of those that are drawn.
inline constexpr std::size_t kMarksAhead = 8;
void prefetch_mark(const BeamMarks& marks, std::size_t number, std::size_t planes);

/// Adds the marks numbered order[0], order[1] ... to the tile: to each plane by their weight times
/// what stroke_share() says, or their spots.
/// @param order the first kMarksAhead are prefetched
void draw_marks(const BeamMarks& marks, std::span<const std::uint32_t> order, const BeamTile& tile);

}  // namespace kinescope
