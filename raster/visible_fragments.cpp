#include "raster/visible_fragments.h"

namespace kinescope {

void VisibleFragments::reserve(int count) {
  // Whole vectors are stored at the end.
  const auto n = static_cast<std::size_t>(count) + 16;
  if (id.size() >= n) return;
  id.resize(n);
  xy.resize(n);
  weight.resize(n);
}

}  // namespace kinescope
