// Fragments of triangles in a tile, one triangle after another, depth-tested in that order.
#pragma once

#include <span>

#include "raster/bins.h"
#include "raster/blending.h"
#include "raster/ordered/ordered_fragments.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

namespace kinescope {

/// What the depth of a call's fragments does.
struct DepthUse {
  DepthTest test = DepthTest::kLess;
  bool write = true;  ///< to the tile
  bool keep = false;  ///< in OrderedFragments::depth
};

/// Appends the fragments of records with any sample that passes, until there are `limit`; `out` has
/// room for as many and, since a record is not cut in two, for all pixels of the clip besides.
/// @param clip  a part of the tile: no pixel outside is drawn
/// @return how many records were done
std::size_t draw_ordered_records(std::span<const TriangleRecord* const> records, DepthUse use,
                                 const PixelRect& clip, std::span<const SampleOffset> pattern,
                                 int limit, TileBuffer& tile, OrderedFragments& out);

}  // namespace kinescope
