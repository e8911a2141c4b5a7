// Triangles that are blended or tested otherwise than by "nearest wins": their order counts.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/bins.h"
#include "raster/draw_call.h"
#include "raster/kernels/cull.h"
#include "raster/sample_pattern.h"

namespace kinescope {

/// When in a frame a call is drawn; the phases follow one another.
enum class DrawPhase : std::uint8_t {
  kVisibility,  ///< plain calls: the nearest fragment wins
  kSubmitted,   ///< one triangle after another
  kByDepth,     ///< far to near
};

/// The phase of each call.
std::vector<DrawPhase> phases_of(std::span<const DrawCall> calls);

/// One worker's records of the two later phases, a list a tile, in each the ids rising.
struct OrderedBins {
  using Tiles = std::vector<ChunkList<RecordChunk>>;
  Tiles submitted, by_depth;
  ChunkPool<RecordChunk> pool;

  Tiles& of(DrawPhase phase) { return phase == DrawPhase::kByDepth ? by_depth : submitted; }
  void clear(int tiles) {
    submitted.assign(static_cast<std::size_t>(tiles), {});
    by_depth.assign(static_cast<std::size_t>(tiles), {});
    pool.take_all_back();
  }
};

/// Puts a range's triangles, of whatever size, into each tile that they touch, in their order.
/// @param clip  no pixel outside is drawn
/// @return how many were left
std::uint64_t bin_in_order(const CulledTriangles& triangles, const DrawCall& call,
                           std::uint32_t first_id, const PixelRect& clip,
                           std::span<const SampleOffset> pattern, const TileGrid& grid,
                           OrderedBins::Tiles& tiles, ChunkPool<RecordChunk>& pool);

/// Appends the records of one tile's lists, each with its ids rising, to `out`, all ids rising.
void merge_in_order(std::span<const ChunkList<RecordChunk>* const> lists,
                    std::vector<const TriangleRecord*>& out);

}  // namespace kinescope
