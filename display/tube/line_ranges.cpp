#include "display/tube/line_ranges.h"

#include <algorithm>

namespace kinescope {
namespace {

int cells_started(BeamTime span, int least, int most) {
  const std::int64_t started = (span.raw() + BeamTime::kOne - 1) >> BeamTime::kBits;
  return static_cast<int>(std::clamp<std::int64_t>(started, least, most));
}

}  // namespace

LineRanges line_ranges(const RasterScan& scan, BeamTime begin, BeamTime end, int line) {
  const int width = scan.mode().horizontal.active;
  const BeamTime frame = scan.frame_clocks();
  const BeamTime since = divide(begin - scan.line_start_clocks(0, line), frame).rest;
  const BeamTime length = end - begin;
  LineRanges ranges;
  const auto add_pair = [&](std::size_t at, int first, int last, BeamTime since_zero,
                            BeamTime until_zero) {
    const int excited = cells_started(until_zero, first, last);
    const double shift = first;
    ranges[at] = {first, excited, to_clocks(since_zero) - shift, true,
                  to_clocks(until_zero) - shift};
    ranges[at + 1] = {excited, last, to_clocks(since_zero) - excited, false, 0};
  };
  const int passed = cells_started(since, 0, width);
  add_pair(0, 0, passed, since, length + since - frame);
  add_pair(2, passed, width, since + frame, length + since);
  return ranges;
}

}  // namespace kinescope
