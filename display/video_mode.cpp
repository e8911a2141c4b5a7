#include "display/video_mode.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "raster/base/error.h"

namespace kinescope {
namespace {

// What no monitor goes beyond: the limits that check() states.
constexpr int kLongestActive = 16384;
constexpr int kLongestInterval = 16384;
constexpr double kSlowestFrame_hz = 10;
constexpr double kFastestFrame_hz = 1000;
constexpr double kSlowestClock_hz = 10e3;
constexpr double kFastestClock_hz = 5e9;

[[noreturn]] void refuse(const VideoMode& mode, const std::string& why) {
  throw Error(ErrorKind::kUsage, fmt::format("no monitor has the mode \"{}\": {}", mode.name, why));
}

void check_axis(const VideoMode& mode, const SyncTiming& axis, const char* name) {
  const auto check_interval = [&](int value, const char* interval, int least, int most) {
    if (value < least || value > most) {
      refuse(mode,
             fmt::format("{} {} is {}, must be {} to {}", name, interval, value, least, most));
    }
  };
  check_interval(axis.active, "active", 1, kLongestActive);
  check_interval(axis.front_porch, "front porch", 0, kLongestInterval);
  check_interval(axis.sync, "sync", 1, kLongestInterval);
  check_interval(axis.back_porch, "back porch", 0, kLongestInterval);
}

}  // namespace

double VideoMode::line_rate_hz() const { return pixel_clock_hz / horizontal.total(); }

Seconds VideoMode::pixel_period() const { return Seconds(1 / pixel_clock_hz); }

Seconds VideoMode::line_period() const { return Seconds(horizontal.total() / pixel_clock_hz); }

Seconds VideoMode::frame_period() const {
  return Seconds(static_cast<double>(horizontal.total()) * vertical.total() / pixel_clock_hz);
}

Seconds VideoMode::field_period() const { return frame_period() / (interlaced ? 2 : 1); }

Rate VideoMode::frame_rate() const {
  return Rate{std::llround(pixel_clock_hz),
              static_cast<std::int64_t>(horizontal.total()) * vertical.total()}
      .reduced();
}

std::string VideoMode::modeline() const {
  const auto ends = [](const SyncTiming& t) {
    return fmt::format("{} {} {} {}", t.active, t.active + t.front_porch,
                       t.active + t.front_porch + t.sync, t.total());
  };
  return fmt::format("Modeline \"{}\" {:.6g} {} {} {}{}hsync {}vsync", name, pixel_clock_hz / 1e6,
                     ends(horizontal), ends(vertical), interlaced ? "interlace " : "",
                     horizontal.positive_sync ? '+' : '-', vertical.positive_sync ? '+' : '-');
}

void VideoMode::check() const {
  check_axis(*this, horizontal, "horizontal");
  check_axis(*this, vertical, "vertical");
  if (!(pixel_clock_hz >= kSlowestClock_hz && pixel_clock_hz <= kFastestClock_hz)) {
    refuse(*this, fmt::format("the pixel clock is {:g} Hz, must be {:g} to {:g}", pixel_clock_hz,
                              kSlowestClock_hz, kFastestClock_hz));
  }
  const double sweeps_hz = 1 / field_period().count();
  if (sweeps_hz < kSlowestFrame_hz || sweeps_hz > kFastestFrame_hz) {
    refuse(*this, fmt::format("{:.4g} sweeps a second, must be {:g} to {:g}", sweeps_hz,
                              kSlowestFrame_hz, kFastestFrame_hz));
  }
  if (interlaced && vertical.total() % 2 == 0) {
    refuse(*this, fmt::format("interlaced with {} lines, must be odd", vertical.total()));
  }
}

}  // namespace kinescope
