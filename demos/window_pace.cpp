#include "demos/window_pace.h"

#include <fmt/format.h>

#include <cmath>

namespace kinescope {

WindowPace window_pace(std::optional<Seconds> shutter, Rate monitor, Rate refresh) {
  constexpr double kNear = 0.02;  // a monitor of 59.94 or 143.9 says 59 or 143
  const WindowPace whole{refresh.period(), refresh.period(), 1, {}};
  if (!shutter) return whole;
  const double frames = shutter->count() * monitor.hertz();
  const double ticks = std::round(frames);
  if (ticks >= 1 && std::abs(frames - ticks) <= kNear * ticks) {
    return {*shutter / ticks, *shutter, static_cast<int>(ticks), {}};
  }
  WindowPace pace = whole;
  pace.remark = fmt::format(
      "slices of {:.6g} s do not fit this monitor's {:.6g} frames a second: whole refreshes of the "
      "tube are shown",
      shutter->count(), monitor.hertz());
  return pace;
}

}  // namespace kinescope
