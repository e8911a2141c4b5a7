// Fragments on their way to be blended, in the order of their triangles.
#pragma once

#include <cstdint>

#include "raster/aligned_vector.h"

namespace kinescope {

/// Structure of arrays, `size` entries each; the arrays only grow.
struct OrderedFragments {
  int size = 0;
  AlignedVector<std::uint32_t> id;
  AlignedVector<std::uint32_t> xy;      ///< pixel in the target: x in the low half, y in the high
  AlignedVector<std::uint8_t> samples;  ///< bits: those that passed; unset if a pixel has one
  AlignedVector<float> depth;           ///< fragment * samples + sample; only if asked for

  /// At least that much room; what is there stays.
  void reserve(int count, int depths_a_fragment);
};

}  // namespace kinescope
