// One phosphor over the whole faceplate: what each cell still holds, and the light it gives in any
// window of time, in closed form. A cell is one pixel of one scan line. Everything is kept twice:
// for what the narrow and what the wide Gaussian of the spot brought, which decay alike.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "display/phosphor.h"
#include "display/tube_kernels.h"
#include "raster/aligned_vector.h"

namespace kinescope {

/// Cells [begin, end) of a line that share their history in a window [a, b). Times are in pixel
/// clocks; the next cell is excited one clock later, so its times are each less by one.
struct CellRange {
  int begin = 0, end = 0;
  double since = 0;      ///< of cell `begin`: a - the start of its last excitation, above 0
  bool excited = false;  ///< whether the window holds the cell's next excitation, a frame later
  double until = 0;      ///< of cell `begin`, if excited: b - the start of that one
};

/// Work space of one worker.
struct LayerScratch {
  AlignedVector<float> old_weight, new_weight;
};

class PhosphorLayer {
 public:
  /// @param frame_clocks time between a cell's excitations; a cell's dwell is one clock
  PhosphorLayer(const Phosphor& phosphor, double clock_hz, double frame_clocks, int width,
                int height);

  /// Sets the length of the window for the calls of pass() that follow, in clocks, at most a frame.
  void set_window(double length);

  /// Light of the cells of one range in the window, added to `light`; moves excited cells on to
  /// their new doses (1 is white's light of one frame).
  void pass(int line, const CellRange& range, DoseRows new_dose, LayerScratch& scratch,
            LightRows light);

  /// Of one term, the light that the cells of a range still have to give when a window begins that
  /// does not excite them; stored in `to_come`.
  void leave(std::size_t term, int line, const CellRange& range, LightRows to_come);

  /// Each cell's last dose.
  DoseRows doses(int line) const {
    return {doses_[0].data() + offset(line), doses_[1].data() + offset(line)};
  }
  std::size_t terms() const { return terms_.size(); }
  void darken();

 private:
  struct Term {
    double share = 0, tau = 0;      // clocks
    double in_dwell = 0;            // share of a dose's light that comes during its dwell
    double after_dwell = 0;         // share of a dose left when its dwell ends
    double window_light = 0;        // 1 - exp(-window / tau)
    double keep = 0, gain = 0;      // a frame later: of the state, of the dose
    int reach = 0;                  // clocks after which a decay table is 0
    int plane = -1;                 // of states_, for a term that outlives a frame
    std::vector<float> decay;       // exp(-(width - 1 - i) / tau)
    std::vector<float> grown_back;  // 1 - decay
    std::vector<float> grown;       // 1 - exp(-i / tau)
  };

  void fill_tables(Term& term) const;
  void carry_over(double frame_clocks);
  void emit(int line, const CellRange& range, int count, LayerScratch& scratch, LightRows light);
  void excite(int line, const CellRange& range, int count, DoseRows new_dose, LayerScratch& scratch,
              LightRows light);
  void excite_slow(const Term& term, int line, const CellRange& range, int count, LightRows light);
  void pass_dwelling_cell(std::size_t basis, int line, const CellRange& range,
                          const float* new_dose, float* light);
  float* dose_row(std::size_t basis, int line) { return doses_[basis].data() + offset(line); }
  LightRows dose_rows(int line, int cell) {
    return {dose_row(0, line) + cell, dose_row(1, line) + cell};
  }
  float* state_row(std::size_t basis, int plane, int line) {
    return states_[basis][static_cast<std::size_t>(plane)].data() + offset(line);
  }
  std::size_t offset(int line) const {
    return static_cast<std::size_t>(line) * static_cast<std::size_t>(pitch_);
  }

  int width_;
  int pitch_;  // cells from line to line, whole cache lines
  double frame_clocks_;
  double window_ = 0;
  std::vector<Term> terms_;
  std::array<AlignedVector<float>, 2> doses_;  // each cell's last dose
  // Light to come, when that dose began, of those before it.
  std::array<std::vector<AlignedVector<float>>, 2> states_;
};

}  // namespace kinescope
