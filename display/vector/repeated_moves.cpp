#include "display/vector/repeated_moves.h"

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

/// Rounding to a machine's clock is no change.
constexpr Seconds kRounding{30e-9};

bool near(Seconds a, Seconds b) { return std::abs((a - b).count()) <= kRounding.count(); }

}  // namespace

bool RepeatedMoves::same(std::span<const BeamMove> moves, Seconds begin, Seconds length) const {
  if (repeats_ < 0 || moves.size() != first_.size() || !near(length, length_)) return false;
  const Seconds shift = begin - begin_;
  return std::equal(
      moves.begin(), moves.end(), first_.begin(), [&](const BeamMove& a, const BeamMove& b) {
        return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1 &&
               a.intensity == b.intensity && a.colour == b.colour && a.spread == b.spread &&
               near(a.begin, b.begin + shift) && near(a.end, b.end + shift);
      });
}

// A list out of step with the exposures is cut at another place by each: no two are the same, and
// none is kept.
int RepeatedMoves::count(std::span<const BeamMove> moves, Seconds begin, Seconds end) {
  if (same(moves, begin, end - begin)) return ++repeats_;
  first_.assign(moves.begin(), moves.end());
  begin_ = begin, length_ = end - begin;
  return repeats_ = 0;
}

}  // namespace kinescope
