#include "raster/ordered/ordered_fragments.h"

namespace kinescope {

void OrderedFragments::reserve(int count, int depths_a_fragment) {
  // Whole vectors are stored at the end.
  const auto n = static_cast<std::size_t>(count) + 16;
  if (id.size() < n) {
    id.resize(n);
    xy.resize(n);
    samples.resize(n);
  }
  const std::size_t depths = n * static_cast<std::size_t>(depths_a_fragment);
  if (depth.size() < depths) depth.resize(depths);
}

}  // namespace kinescope
