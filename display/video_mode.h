// A video mode: every interval of a raster, in pixels and lines, and from these in time.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raster/base/units.h"

namespace kinescope {

/// Intervals along one axis in the order in which they pass: pixels across, or frame lines down.
struct SyncTiming {
  int active = 0, front_porch = 0, sync = 0, back_porch = 0;
  bool positive_sync = false;
  constexpr int total() const { return active + front_porch + sync + back_porch; }
  bool operator==(const SyncTiming&) const = default;
};

/// One modeline. Of an interlaced mode, vertical counts are of the whole frame (two fields), and
/// `vertical.total()` is odd.
struct VideoMode {
  std::string name;
  double pixel_clock_hz = 0;
  SyncTiming horizontal;
  SyncTiming vertical;
  bool interlaced = false;

  double line_rate_hz() const;
  Seconds pixel_period() const;
  Seconds line_period() const;
  Seconds field_period() const;  ///< one vertical sweep
  Seconds frame_period() const;  ///< all lines once: two fields if interlaced
  /// Frames a second, exact in whole hertz of the pixel clock.
  Rate frame_rate() const;
  /// "Modeline ..." as X servers take it.
  std::string modeline() const;
  /// @throws Error (usage) naming the interval that is zero, negative or absurd
  void check() const;
  bool operator==(const VideoMode&) const = default;
};

/// The table of display/data/modes.txt.
std::span<const VideoMode> standard_modes();

// Timing formulas. `refresh_hz` counts whole frames, of two fields if interlaced. They throw Error
// (usage) for what check() refuses.

/// VESA GTF 1.1 with its default parameters (C 40, J 20, K 128, M 600).
VideoMode gtf_mode(int width, int height, double refresh_hz, bool interlaced = false);
/// VESA CVT 1.1: normal or reduced blanking (version 1). Widths are rounded up to 8 pixels, as
/// Debian's cvt does.
VideoMode cvt_mode(int width, int height, double refresh_hz, bool reduced_blanking = false,
                   bool interlaced = false);

/// A mode from what a user types: a name of the table ("640x480@60"), "gtf:WxH@HZ", "cvt:WxH@HZ",
/// "cvtrb:WxH@HZ", a Modeline, or WxH@HZ (the table's entry of that rate within 0.05 Hz, or CVT);
/// an "i" after HZ makes it interlaced, with HZ fields a second.
/// @throws Error (usage) naming what is wrong
VideoMode parse_mode(std::string_view text);

}  // namespace kinescope
