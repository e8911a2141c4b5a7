// Tells when a list is refreshed in step with the exposures, and does not change.
#pragma once

#include <span>
#include <vector>

#include "display/vector/beam_move.h"

namespace kinescope {

class RepeatedMoves {
 public:
  /// @param moves of the exposure [begin, end) @return how many exposures before it, one after the
  /// other, were as long and had the same moves at the same times after they began
  int count(std::span<const BeamMove> moves, Seconds begin, Seconds end);
  /// Counts from nought again.
  void restart() { repeats_ = -1; }

 private:
  bool same(std::span<const BeamMove> moves, Seconds begin, Seconds length) const;

  std::vector<BeamMove> first_;  // of the first exposure that is repeated
  Seconds begin_{0}, length_{0};
  int repeats_ = -1;
};

}  // namespace kinescope
