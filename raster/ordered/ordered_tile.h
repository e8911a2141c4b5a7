// Draws what must be blended in one tile, upon what is visible there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/fragment_batches.h"
#include "raster/kernels/blend_samples.h"
#include "raster/kernels/ordered_triangles.h"
#include "raster/ordered/ordered_bins.h"
#include "raster/ordered/ordered_fragments.h"
#include "raster/render_target.h"
#include "raster/tile.h"

namespace kinescope {

/// One worker's storage for the two later phases of a tile.
class OrderedTile {
 public:
  /// Forgets the tile before.
  void begin();
  /// The lists of one worker's bins.
  void add(const OrderedBins& bins, int tile);
  /// Nothing to draw: the tile may be resolved at once.
  bool empty() const { return submitted_lists_.empty() && by_depth_lists_.empty(); }

  /// Takes what is visible, some fragments at a time: the colours that will be blended onto.
  void begin_colours(const LinearRgba& clear, const TileBuffer& tile);
  void take(const VisibleFragments& visible, std::span<const LinearRgba> colours,
            const TileBuffer& tile);
  /// Draws in order, then by depth, upon those colours and the visibility phase's depth and
  /// triangles in `tile`; leaves there the depth, and the triangle, that were written last.
  /// @return fragments shaded
  std::uint64_t draw(const FrameCalls& frame, std::span<const SampleOffset> pattern,
                     const LinearRgba& clear, TileBuffer& tile);

  /// Overwrites the pixels that draw() touched.
  void resolve(const TileBuffer& tile, RenderTarget& target);

 private:
  using Records = std::span<const TriangleRecord* const>;
  /// Calls each(call's index, records) for each run of records of one call.
  template <typename Each>
  static void for_each_call(const FrameCalls& frame, Records records, const Each& each);

  std::int64_t covered_area(const TileBuffer& tile) const;
  void set_bands(const TileBuffer& tile, int rows);

  void draw_in_order(const FrameCalls& frame, std::span<const SampleOffset> pattern,
                     const LinearRgba& clear, TileBuffer& tile);
  void blend_batches(const FrameCalls& frame, int call, const LinearRgba& clear,
                     const TileBuffer& tile);
  bool lie_apart(const FrameCalls& frame, const TileBuffer& tile);
  void draw_by_depth(const FrameCalls& frame, std::span<const SampleOffset> pattern,
                     const LinearRgba& clear, TileBuffer& tile);
  bool gather(const FrameCalls& frame, std::span<const SampleOffset> pattern, const PixelRect& band,
              TileBuffer& tile);
  void blend_band(const FrameCalls& frame, const PixelRect& band, const LinearRgba& clear,
                  const TileBuffer& tile);

  std::vector<const ChunkList<RecordChunk>*> submitted_lists_, by_depth_lists_;
  std::vector<const TriangleRecord*> records_, far_first_;
  std::vector<PixelRect> bands_;  ///< parts of the tile that are drawn one after another
  OrderedFragments fragments_;
  /// Of fragments that are blended by depth: modes, and where each call's end.
  std::vector<BlendMode> modes_;
  struct CallEnd {
    int call;
    int fragment;
  };
  std::vector<CallEnd> call_ends_;
  FragmentShader shader_;
  AlignedVector<LinearRgba> shaded_;
  std::uint64_t shaded_count_ = 0;
  DepthOrder order_;
  TileColours colours_;
  AlignedVector<LinearRgba> row_;
};

}  // namespace kinescope
