#include "display/raster_scan.h"

#include <cmath>
#include <numbers>

namespace kinescope {
namespace {

/// Ends of the intervals of a sweep, in pixels or field lines from its start.
struct Ends {
  double active, front_porch, sync;
};

ScanPhase phase_at(double place, const Ends& ends) {
  if (place < ends.active) return ScanPhase::kActive;
  if (place < ends.front_porch) return ScanPhase::kFrontPorch;
  return place < ends.sync ? ScanPhase::kSync : ScanPhase::kBackPorch;
}

}  // namespace

double fly_back(double from, double to, double done) {
  return to + (from - to) * (0.5 + 0.5 * std::cos(std::numbers::pi * done));
}

RasterScan::RasterScan(const VideoMode& mode) : mode_(mode), clock_(mode.pixel_clock_hz) {
  mode_.check();
}

BeamTime RasterScan::frame_clocks() const {
  return clocks(static_cast<std::int64_t>(mode_.horizontal.total()) * mode_.vertical.total());
}

int RasterScan::picture_lines(int field) const {
  return mode_.interlaced ? (mode_.vertical.active + 1 - field) / 2 : mode_.vertical.active;
}

BeamTime RasterScan::line_start_clocks(std::int64_t frame, int line) const {
  const std::int64_t lines_passed =
      mode_.interlaced ? line / 2 + (line % 2) * ((mode_.vertical.total() + 1) / 2) : line;
  return clocks((frame * mode_.vertical.total() + lines_passed) * mode_.horizontal.total());
}

BeamTime RasterScan::retrace_start_clocks(std::int64_t frame, int field) const {
  const BeamTime first_line =
      picture_lines(field) > 0 ? line_start_clocks(frame, field) : line_start_clocks(frame, 0);
  return first_line +
         clocks(static_cast<std::int64_t>(picture_lines(field)) * mode_.horizontal.total());
}

BeamTime RasterScan::retrace_from(BeamTime t) const {
  std::int64_t frame = divide(t, frame_clocks()).whole;
  for (int field = 0;; frame += ++field / fields(), field %= fields()) {
    const BeamTime retrace = retrace_start_clocks(frame, field);
    if (retrace >= t) return retrace;
  }
}

Seconds RasterScan::line_start(std::int64_t frame, int line) const {
  return clock_.seconds(line_start_clocks(frame, line));
}

Seconds RasterScan::retrace_start(std::int64_t frame, int field) const {
  return clock_.seconds(retrace_start_clocks(frame, field));
}

BeamPosition RasterScan::at(Seconds t) const {
  const Periods in_frame = divide(clock_.at(t), frame_clocks());
  BeamPosition beam;
  beam.frame = in_frame.whole;
  const BeamTime field_clocks = BeamTime::from_raw(frame_clocks().raw() / fields());
  const Periods in_field = divide(in_frame.rest, field_clocks);
  beam.field = static_cast<int>(in_field.whole);
  beam.field_line = to_clocks(in_field.rest) / mode_.horizontal.total();
  place_across(beam, in_frame.rest);
  place_down(beam);
  beam.blanked = beam.horizontal != ScanPhase::kActive || beam.vertical != ScanPhase::kActive;
  return beam;
}

void RasterScan::place_across(BeamPosition& beam, BeamTime in_frame) const {
  const SyncTiming& h = mode_.horizontal;
  beam.pixel = to_clocks(divide(in_frame, line_clocks()).rest);
  const Ends ends{static_cast<double>(h.active), static_cast<double>(h.active + h.front_porch),
                  static_cast<double>(h.active + h.front_porch + h.sync)};
  beam.horizontal = phase_at(beam.pixel, ends);
  const double sweep = 1.0 / h.active;
  beam.x = beam.pixel * sweep;
  if (beam.pixel >= ends.front_porch) {
    const double done = (beam.pixel - ends.front_porch) / (h.sync + h.back_porch);
    beam.x = fly_back(ends.front_porch * sweep, 0, done);
  }
}

void RasterScan::place_down(BeamPosition& beam) const {
  const SyncTiming& v = mode_.vertical;
  const double fields_a_frame = fields();
  // The second field's picture starts with a whole line, half a line after the field does. Sync
  // recurs exactly once a field, so its front porch is the shorter by that half line.
  const double late = beam.field * 0.5;
  const Ends ends{picture_lines(beam.field) + late, (v.active + v.front_porch) / fields_a_frame,
                  (v.active + v.front_porch + v.sync) / fields_a_frame};
  beam.vertical = beam.field_line < late ? ScanPhase::kBackPorch : phase_at(beam.field_line, ends);
  beam.line = static_cast<int>(std::floor(beam.field_line + late)) - beam.field;
  if (mode_.interlaced) beam.line = 2 * beam.line + beam.field;

  const double sweep = fields_a_frame / v.active;
  const double top = mode_.interlaced ? -0.5 / v.active : 0;
  beam.y = top + beam.field_line * sweep;
  if (beam.field_line >= ends.front_porch) {
    const double whole = v.total() / fields_a_frame;
    const double done = (beam.field_line - ends.front_porch) / (whole - ends.front_porch);
    beam.y = fly_back(top + ends.front_porch * sweep, top, done);
  }
}

}  // namespace kinescope
