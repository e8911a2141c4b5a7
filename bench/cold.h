// The first frame of a new process against its steady frame, ours and the peer's.
#pragma once

#include <string>

#include "bench/peer_rows.h"

namespace kinescope::bench {

struct ColdFigures {
  double first_ms, steady_ms;
};

/// What a child process does: draws knot-phong, and prints its first frame and the median of the
/// later ones, in milliseconds. The scene is ready; the first frame includes making what draws it:
/// ours its threads and target, the peer its context, shaders and buffers.
/// @param who "ours" or "peer"
void run_cold_child(const PairOptions& options, const std::string& who, int samples);

struct ColdRow {
  Row row;  ///< of first frames
  double ours_over_steady;
  std::optional<double> peer_over_steady;
};
/// Starts this program again several times; medians. @throws Error if a child fails
ColdRow measure_cold(const PairOptions& options, int samples);

}  // namespace kinescope::bench
