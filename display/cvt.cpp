// Coordinated Video Timings, normal and with reduced blanking (version 1).
// Source: VESA CVT Standard 1.1 (2003); roundings as Debian's cvt (package xcvt) does them.
#include <algorithm>
#include <cmath>

#include "display/mode_request.h"
#include "display/video_mode.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr int kCell_px = 8;
constexpr double kClockStep_hz = 250e3;
constexpr int kFrontPorch_lines = 3;
constexpr int kMinBackPorch_lines = 3;  // cvt's; the standard has 6
constexpr int kMinReducedBackPorch_lines = 6;

/// What the formula settles per field; the clock before it is cut to a step.
struct FieldTiming {
  int sync_and_back_lines = 0;
  double clock_hz = 0;
};

/// The sync's length tells the monitor the aspect ratio.
int sync_lines(int width, int height) {
  struct Aspect {
    int across, down, lines;
  };
  for (const Aspect a : {Aspect{4, 3, 4}, {16, 9, 5}, {16, 10, 6}, {5, 4, 7}, {15, 9, 7}}) {
    if (height * a.across == width * a.down) return a.lines;
  }
  return 10;
}

FieldTiming normal_blanking(SyncTiming& h, int field_lines, int sync, double half_line,
                            double field_rate_hz) {
  constexpr double kMinSyncAndBackPorch_us = 550;
  constexpr double kMinDuty_percent = 20;
  constexpr double kGradient_percent_per_ms = 300;  // M' of M 600, K 128
  constexpr double kOffset_percent = 30;            // C' of C 40, J 20, K 128
  constexpr double kSyncShareOfLine = 0.08;
  const double line_us = (1e6 / field_rate_hz - kMinSyncAndBackPorch_us) /
                         (field_lines + kFrontPorch_lines + half_line);
  if (!(line_us > 0)) return {};
  FieldTiming field;
  field.sync_and_back_lines =
      std::max(static_cast<int>(kMinSyncAndBackPorch_us / line_us) + 1, sync + kMinBackPorch_lines);
  const double duty_percent =
      std::max(kOffset_percent - kGradient_percent_per_ms * line_us / 1000, kMinDuty_percent);
  const int blank = static_cast<int>(h.active * duty_percent / (100 - duty_percent)) /
                    (2 * kCell_px) * (2 * kCell_px);
  const int total = h.active + blank;
  const int sync_end = h.active + blank / 2;
  int sync_start = sync_end - static_cast<int>(total * kSyncShareOfLine);
  sync_start += kCell_px - sync_start % kCell_px;
  h.front_porch = sync_start - h.active;
  h.sync = sync_end - sync_start;
  h.back_porch = blank / 2;
  field.clock_hz = total / line_us * 1e6;
  return field;
}

FieldTiming reduced_blanking(SyncTiming& h, int field_lines, int sync, double field_rate_hz) {
  constexpr double kMinBlank_us = 460;
  h.front_porch = 48;
  h.sync = 32;
  h.back_porch = 80;
  const double line_us = (1e6 / field_rate_hz - kMinBlank_us) / field_lines;
  if (!(line_us > 0)) return {};
  const int blank_lines = std::max(static_cast<int>(kMinBlank_us / line_us) + 1,
                                   kFrontPorch_lines + sync + kMinReducedBackPorch_lines);
  // As cvt has it, from the line's period before whole lines of blanking were settled.
  return {blank_lines - kFrontPorch_lines, h.total() / line_us * 1e6};
}

}  // namespace

VideoMode cvt_mode(int width, int height, double refresh_hz, bool reduced, bool interlaced) {
  const ModeRequest request{width, height, refresh_hz, interlaced};
  check_request(request);
  const int fields = interlaced ? 2 : 1;
  const int field_lines = height / fields;
  const int sync = sync_lines((width + kCell_px - 1) / kCell_px * kCell_px, height);

  VideoMode mode;
  mode.name = (reduced ? "cvtrb:" : "cvt:") + request_name(request);
  mode.interlaced = interlaced;
  mode.horizontal.active = (width + kCell_px - 1) / kCell_px * kCell_px;
  FieldTiming field;
  if (field_lines > 0 && reduced) {
    field = reduced_blanking(mode.horizontal, field_lines, sync, refresh_hz * fields);
  } else if (field_lines > 0) {
    field = normal_blanking(mode.horizontal, field_lines, sync, interlaced ? 0.5 : 0,
                            refresh_hz * fields);
  }
  if (!(field.clock_hz > 0)) {
    throw Error(ErrorKind::kUsage,
                "CVT leaves no time for the picture of " + request_name(request));
  }
  mode.pixel_clock_hz = std::floor(field.clock_hz / kClockStep_hz) * kClockStep_hz;
  SyncTiming& v = mode.vertical;
  v.active = fields * field_lines;
  // The half line of interlace lengthens the front porch: the whole frame's total is odd.
  v.front_porch = fields * kFrontPorch_lines + (interlaced ? 1 : 0);
  v.sync = fields * sync;
  v.back_porch = fields * (field.sync_and_back_lines - sync);
  mode.horizontal.positive_sync = reduced;
  v.positive_sync = !reduced;
  mode.check();
  return mode;
}

}  // namespace kinescope
