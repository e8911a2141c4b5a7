// The controller's part of a window: it reads the frame buffer where the beam passes, and the guns
// make doses of it.
#pragma once

#include <span>
#include <vector>

#include "display/frame_buffer.h"
#include "display/raster_scan.h"
#include "display/tube/gun.h"
#include "display/tube/light_planes.h"
#include "display/tube/line_ranges.h"
#include "raster/base/workers.h"

namespace kinescope {

class SignalDoses {
 public:
  /// @param signals each of which has its gun; all guns are alike
  void prepare(const RasterScan& scan, const Gun& gun, std::span<const Signal> signals,
               const Workers& workers);
  /// Doses of the cells that the beam meets in [begin, end), at most a frame; pages flip as it
  /// retraces.
  void read(const RasterScan& scan, const Gun& gun, std::span<const Signal> signals,
            FrameBuffer& buffer, BeamTime begin, BeamTime end, Workers& workers);
  /// The doses of a line's cells that the last window excited, valid until the worker's next call.
  /// @param last each cell's last dose: those of a line that is what it was a frame ago
  DoseRows of(const Gun& gun, Signal signal, std::size_t index, int line, int worker,
              DoseRows last);
  /// Takes no line for what it was.
  void forget() { drives_.clear(); }
  /// Whether, since the last call, a line was read that is not what it was a frame ago.
  bool take_changed();

 private:
  /// Work space of one worker.
  struct Scratch {
    std::vector<GunDrive> drives;
    std::vector<float> voltage, narrow, wide;
    bool changed = false;
  };
  /// What the last window read of a line.
  enum class Reading : std::uint8_t { kInPart, kSame, kWhole };
  void read_line(const Gun& gun, std::span<const Signal> signals, const FrameBuffer& buffer,
                 const LineRanges& ranges, int line, Scratch& scratch);
  void copy_ranges(const LineRanges& ranges, int line, std::size_t signal, const Scratch& scratch);

  std::vector<LayerLight> doses_;              // of each signal, of lines read in part
  std::vector<Reading> readings_;              // of each line
  std::vector<std::vector<GunDrive>> drives_;  // of each line, when it was last read whole
  std::vector<Scratch> scratch_;
};

}  // namespace kinescope
