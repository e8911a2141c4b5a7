// A picture's tones as bars of a pane.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "demos/lesson/track.h"
#include "demos/lesson/world.h"
#include "raster/image/tone_curve.h"

namespace kinescope {

/// One column a step, of as many tones as fall on it.
inline Track histogram_track(const World& world, const char* name, const Histogram& counts,
                             int pane, Srgb8 colour) {
  Track track(name, {}, pane, colour);
  const int columns = world.columns(), rows = world.rows();
  std::vector<double> sums(static_cast<std::size_t>(columns));
  for (int tone = 0; tone < 256; ++tone) {
    sums[static_cast<std::size_t>(tone * columns / 256)] +=
        static_cast<double>(counts[static_cast<std::size_t>(tone)]);
  }
  const double most = *std::max_element(sums.begin(), sums.end());
  for (int x = 0; x < columns; ++x) {
    // The root, so that small counts are seen beside a peak.
    const double share = std::sqrt(sums[static_cast<std::size_t>(x)] / std::max(most, 1.0));
    const int top = rows - static_cast<int>(std::lround(share * (rows - 4)));
    for (int y = top; y < rows; ++y) track(x, y);
    track.step({});
  }
  return track;
}

}  // namespace kinescope
