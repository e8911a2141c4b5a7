// A raster whose sweeps land anew each time: oscillators that have lost sync, hum, a high voltage
// that sags, fields that pair. Each vertical sweep is kept apart, with its own cells in their own
// place, until the one after it has ended; what then still glows passes to the afterglow.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "display/frame_buffer.h"
#include "display/phosphor.h"
#include "display/phosphor_layer.h"
#include "display/tube/afterglow.h"
#include "display/tube/faceplate.h"
#include "display/tube/free_retrace.h"
#include "display/tube/free_sweep.h"
#include "display/tube/gun.h"
#include "display/tube/light_planes.h"
#include "display/tube/sweep_warp.h"

namespace kinescope {

class FreeRaster {
 public:
  /// @param signals that the guns follow
  /// @param layers of the faceplate, each with the index of its signal as its gun
  FreeRaster(const TubeSettings& settings, std::span<const Signal> signals,
             std::span<const FaceplateLayer> layers, std::span<const Phosphor> laws);

  /// Turns those that leave the raster where it is.
  void turn_knobs(const TubeSettings& settings);
  const FreeSweep& sweep() const { return sweep_; }
  /// Starts at a time of the video's clock, with oscillators as the other's have run until then.
  void take_over(const FreeSweep& before, BeamTime video_now);

  /// The light of [begin, end) in the video's clock, added to `sum`; pages of the buffer flip as
  /// the video, not the sweep, retraces.
  void pass(const RasterScan& scan, FrameBuffer& buffer, BeamTime begin, BeamTime end,
            const Faceplate& faceplate, FreeRetrace& retrace, Afterglow& afterglow,
            LightOverlay& sum, Workers& workers);
  /// Everything that still glows passes to the afterglow, at the end of the last pass.
  void leave(const Faceplate& faceplate, Afterglow& afterglow, Workers& workers);

 private:
  struct Field {
    SweptField swept;
    SweepWarp warp;
    std::vector<PhosphorLayer> phosphor;  // of each layer
    std::vector<LayerLight> light;        // of each layer, in this pass
  };
  struct Scratch {
    std::vector<GunDrive> video, drives;
    std::vector<CellSpan> tips;
    std::vector<float> voltage;
    LayerScratch phosphor;
  };

  void prepare(const Workers& workers);
  void begin_field(const SweptField& swept);
  void pass_sweep(const RasterScan& scan, const FrameBuffer& buffer, BeamTime begin, BeamTime end,
                  Workers& workers);
  void read_line(const RasterScan& scan, const FrameBuffer& buffer, int line, Scratch& scratch);
  void weigh_doses(const Field& field, int line);
  void bend_line(int line, double load);
  void load_voltage(BeamTime begin, BeamTime end);
  void pass_line(Field& field, BeamTime begin, BeamTime end, int line, Scratch& scratch);
  BeamTime line_begin(const SweptField& swept, int line) const;
  static int cells_begun(BeamTime since_first, int cells);
  void show(Field& field, const GunRasters& rasters, const Faceplate& faceplate, LightOverlay& sum,
            Workers& workers) const;
  void darken(LayerLight& light, Workers& workers) const;
  void left_of(Field& field, std::size_t layer, std::size_t term, LayerLight& light,
               Workers& workers) const;
  int lines_begun(const Field& field) const;
  void take_off(LayerLight& from, const LayerLight& light, double share, Workers& workers) const;
  std::pair<int, int> lit_lines(const LayerLight& light) const;
  void leave(Field& field, const GunRasters& rasters, const Faceplate& faceplate, LightOverlay* sum,
             Afterglow& afterglow, Workers& workers);

  TubeSettings settings_;
  FreeSweep sweep_;
  Gun gun_;
  std::vector<Signal> signals_;
  std::vector<FaceplateLayer> layers_;
  std::vector<Phosphor> laws_;
  int cells_, lines_;
  float dose_scale_;               // of white, to a cell of one sweep
  BeamTime now_;                   // in sweep clocks
  BeamTime pass_begin_;            // of this pass
  std::vector<Field> fields_;      // at most two: the last, and the one before
  std::vector<LayerLight> doses_;  // of each signal, of the last field
  std::vector<float> currents_;    // of each of its lines, the mean of all guns; white's is 1
  double load_ = 0;                // that the high voltage feels, of steady white's
  BeamTime loaded_until_;
  std::vector<Scratch> scratch_;     // of each worker
  std::vector<LayerLight> leaving_;  // of each term: what is left of a field
};

}  // namespace kinescope
