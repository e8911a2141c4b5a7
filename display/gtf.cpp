// Generalized Timing Formula. Source: VESA GTF Standard 1.1 (1999), refresh rate given.
#include <algorithm>
#include <cmath>

#include "display/mode_request.h"
#include "display/video_mode.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr double kCell_px = 8;
constexpr double kMinSyncAndBackPorch_us = 550;
constexpr int kFrontPorch_lines = 1;
constexpr int kSync_lines = 3;
constexpr double kSyncShareOfLine = 0.08;
// Blanking duty cycle C' - M' * line period, from C 40, J 20, K 128, M 600.
constexpr double kGradient_percent_per_ms = 128.0 / 256 * 600;
constexpr double kOffset_percent = (40.0 - 20) * 128 / 256 + 20;

int round_to(double value, double step) {
  return static_cast<int>(std::round(value / step) * step);
}

}  // namespace

VideoMode gtf_mode(int width, int height, double refresh_hz, bool interlaced) {
  const ModeRequest request{width, height, refresh_hz, interlaced};
  check_request(request);
  const double half_line = interlaced ? 0.5 : 0;
  const int fields = interlaced ? 2 : 1;
  const double field_rate_hz = refresh_hz * fields;
  const int field_lines = static_cast<int>(std::round(static_cast<double>(height) / fields));

  const double estimated_line_us = (1e6 / field_rate_hz - kMinSyncAndBackPorch_us) /
                                   (field_lines + kFrontPorch_lines + half_line);
  if (!(estimated_line_us > 0)) {
    throw Error(ErrorKind::kUsage,
                "GTF leaves no time for the picture of " + request_name(request));
  }
  const int sync_and_back_lines = std::max(
      static_cast<int>(std::round(kMinSyncAndBackPorch_us / estimated_line_us)), kSync_lines);
  const double total_lines = field_lines + sync_and_back_lines + half_line + kFrontPorch_lines;
  const double line_us = 1e6 / (field_rate_hz * total_lines);

  VideoMode mode;
  mode.name = "gtf:" + request_name(request);
  mode.interlaced = interlaced;
  SyncTiming& h = mode.horizontal;
  h.active = std::max(round_to(width, kCell_px), static_cast<int>(kCell_px));
  const double duty_percent = kOffset_percent - kGradient_percent_per_ms * line_us / 1000;
  const int blank = round_to(h.active * duty_percent / (100 - duty_percent), 2 * kCell_px);
  h.sync = round_to(kSyncShareOfLine * (h.active + blank), kCell_px);
  h.front_porch = blank / 2 - h.sync;
  h.back_porch = blank / 2;
  SyncTiming& v = mode.vertical;
  v.active = fields * field_lines;
  v.front_porch = interlaced ? 2 * kFrontPorch_lines + 1 : kFrontPorch_lines;
  v.sync = fields * kSync_lines;
  v.back_porch = fields * (sync_and_back_lines - kSync_lines);
  v.positive_sync = true;
  mode.pixel_clock_hz = std::round(h.total() / line_us * 1e6);
  mode.check();
  return mode;
}

}  // namespace kinescope
