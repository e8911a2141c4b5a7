// A light pen: a photodiode held against the glass, which tells when the beam passed below it.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "display/exposure.h"
#include "display/frame_buffer.h"
#include "display/pen_view.h"
#include "display/photodiode.h"
#include "display/raster_scan.h"
#include "display/tube/free_sweep.h"
#include "display/tube/gun.h"
#include "display/tube/settings.h"

namespace kinescope {

struct LightPenSettings {
  Place place{};           ///< of its axis, on the glass
  double view_mm = 1;      ///< across what it sees at least half as well as its axis
  double threshold = 0.4;  ///< of the pulse that a lone white line below its axis gives
  Seconds rise{100e-9};    ///< time constants of its amplifier: by how much it lags,
  Seconds coupling{1e-6};  ///< and how soon steady light counts as none
};

/// A pixel by its place in the scan.
struct PixelAddress {
  std::int64_t frame = 0;
  int line = 0, pixel = 0;
  bool operator==(const PixelAddress&) const = default;
};

/// It knows the tube's light in time, and no picture: cells in view are excited when the beam comes
/// to them, their phosphor glows as its law has it, and the sum of their light, weighted by how
/// well the pen sees each, runs through photodiode and amplifier. The pen trips where that signal
/// rises beyond the threshold. So it tells the first line that is bright enough within its view:
/// with a wide view or a low threshold that is one above its axis, as in life. Before a mask it
/// sees what comes through. Of a raster that runs free or hums it tells when light came, and what
/// the video sent then: the address follows from the video's timing, not from where the sweep lies.
/// Not modelled: halation, the light of the retrace, damper wires; how far the high voltage sags;
/// the room's light is steady, and held back. The picture is taken to have stood for a frame.
class LightPen {
 public:
  LightPen(const TubeSettings& tube, const LightPenSettings& settings);
  const LightPenSettings& settings() const { return settings_; }
  const TubeSettings& tube() const { return tube_; }
  const RasterScan& scan() const { return scan_; }
  void move(Place place);
  /// Free oscillators are as those are, whose knobs may have been turned while they ran; as they
  /// stand they have run by themselves from time 0. @param sweep of the tube's own settings
  void follow(const FreeSweep& sweep) { sweep_ = sweep; }

  /// When the pen first trips in the window. @param buffer scanned as it is
  std::optional<Seconds> watch(const FrameBuffer& buffer, Exposure window) const;

  /// From the beam's passing the axis to the pen's tripping, on a lone white line: a constant of
  /// pen and tube. Negative where the light is seen as it comes into view.
  Seconds delay() const { return delay_; }
  /// Where the beam was whose light made the pen trip then.
  PixelAddress address(Seconds tripped) const;

  struct Sample {
    Seconds time{0};
    double signal = 0;  ///< 1 is the pulse of a lone white line
  };
  /// The signal in the window, densely while there is something to see.
  std::vector<Sample> record(const FrameBuffer& buffer, Exposure window) const;

 private:
  /// Told each sample in turn; whether it wants no more.
  using Visit = std::function<bool(const Sample&)>;
  struct Line;
  void look();
  void calibrate();
  void run(const FrameBuffer& buffer, Exposure window, const Visit& visit) const;
  void run_locked(const FrameBuffer& buffer, Exposure window, const Visit& visit) const;
  void run_free(const FrameBuffer& buffer, Exposure window, const Visit& visit) const;
  std::vector<LineInView> field_in_view(const SweptField& field) const;
  bool run_view(const FrameBuffer& buffer, const LineInView& view, double begins, double until,
                double first_clock, Line& line, const Visit& visit) const;
  bool run_line(const LineInView& view, Line& line, const Visit& visit) const;
  bool run_dark(double until, Line& line, const Visit& visit) const;
  void read(const FrameBuffer& buffer, const LineInView& view, double first_clock,
            Line& line) const;

  TubeSettings tube_;
  LightPenSettings settings_;
  RasterScan scan_;
  bool free_;
  FreeSweep sweep_;
  double cell_clocks_;  // of the video, that the sweep stays in a cell
  SpotModel spot_;
  Gun gun_;
  const PhosphorType* phosphor_;
  PenView view_;
  Photodiode dark_;                   // before any light
  Photodiode::Span step_, lag_step_;  // one of them; and one while the amplifier follows
  std::vector<LineInView> lines_;     // in view of a locked raster, in order of time
  double unit_ = 1;                   // a lone white line's pulse
  Seconds delay_{0};
};

}  // namespace kinescope
