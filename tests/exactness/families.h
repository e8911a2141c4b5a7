// Random triangles of every kind, laid out so that none covers another's samples.
#pragma once

#include "tests/exactness/compare.h"

namespace kinescope::exactness {

/// What kind of triangles. In each: slivers, flat ones, some without area, vertices upon pixel
/// centres and corners.
enum class Family {
  kTiny,         ///< less than three pixels
  kSmall,        ///< up to eight
  kMiddling,     ///< up to 24, 48 or 150
  kSharedEdges,  ///< fans that meet in their edges, of 12, 40 or 160 pixels
  kOffScreen,    ///< partly or wholly outside the target
  kGuardBand     ///< reaching to the guard band's very edges
};
inline constexpr Family kFamilies[] = {Family::kTiny,      Family::kSmall,
                                       Family::kMiddling,  Family::kSharedEdges,
                                       Family::kOffScreen, Family::kGuardBand};

/// Compares one sheet of triangles.
Tally compare(Comparer& comparer, Family family, unsigned seed, int samples);

}  // namespace kinescope::exactness
