// A raster whose sweeps all land alike: its cells keep their light from frame to frame.
#pragma once

#include <span>
#include <vector>

#include "display/frame_buffer.h"
#include "display/phosphor.h"
#include "display/phosphor_layer.h"
#include "display/raster_scan.h"
#include "display/tube/afterglow.h"
#include "display/tube/faceplate.h"
#include "display/tube/gun.h"
#include "display/tube/light_planes.h"
#include "display/tube/signal_doses.h"

namespace kinescope {

class LockedRaster {
 public:
  /// @param signals that the guns follow
  /// @param layers of the faceplate, each with the index of its signal as its gun
  LockedRaster(const VideoMode& mode, std::span<const Signal> signals,
               std::span<const FaceplateLayer> layers, std::span<const Phosphor> laws);

  /// What an exposure spends where, ms.
  struct Times {
    double guns = 0, phosphor = 0;
  };
  /// Gathers the light of [begin, end), which follows the last pass.
  /// @param still whether nothing else glows that fades
  /// @return whether it differs from the last pass's: a still picture's is soon steady
  bool pass(const RasterScan& scan, const Gun& gun, FrameBuffer& buffer, BeamTime begin,
            BeamTime end, bool still, Workers& workers, Times& times);
  /// The light that the last pass gathered, of each layer's cells.
  std::span<const LayerLight> light() const { return work_.light; }

  /// Everything that still glows at a time passes to the afterglow.
  void leave(const RasterScan& scan, BeamTime now, const Faceplate& faceplate, Afterglow& afterglow,
             Workers& workers);
  void darken();
  /// Forgets what it has read: guns or their knobs are others.
  void forget() { work_ = Work(); }

 private:
  struct Layer {
    PhosphorLayer phosphor;
    std::size_t signal;
  };
  /// Nothing of it outlives an exposure but what tells a still picture, so a copy starts with none.
  struct Work {
    SignalDoses doses;
    std::vector<LayerLight> light;      // of each layer, of the exposure
    std::vector<LayerScratch> scratch;  // of each worker
    int steady_frames = 0;              // whole ones that passed while no line changed

    Work() = default;
    Work(const Work&) : Work() {}
    Work& operator=(const Work&) { return *this = Work(); }
    Work(Work&&) = default;
    Work& operator=(Work&&) = default;
    ~Work() = default;
  };

  void prepare(const RasterScan& scan, const Gun& gun, Workers& workers);
  bool is_steady(bool still);
  void pass_window(const RasterScan& scan, const Gun& gun, BeamTime begin, BeamTime end, bool first,
                   Workers& workers);
  void pass_line(const LineRanges& ranges, const Gun& gun, int line, bool first, int worker);

  int cells_, lines_;
  std::vector<Signal> signals_;
  std::vector<Layer> layers_;
  int settling_frames_ = 0;  // until the light of a still picture is steady
  Work work_;
};

}  // namespace kinescope
