// What a light pen held against the glass sees of the beam: which cells of which lines, how well.
#pragma once

#include <array>
#include <vector>

#include "display/pen_mask.h"
#include "display/tube/deflection.h"
#include "display/tube/settings.h"
#include "display/tube/spot.h"
#include "display/tube/sweep_warp.h"

namespace kinescope {

/// A spot at some distance from the pen's axis, as a share of what a point below the axis sends it.
/// The pen sees a Gaussian's worth of the glass, so what it sees of a Gaussian spot is one too.
class SpotInView {
 public:
  /// @param view_mm across what is seen at least half as well as the axis
  SpotInView(const SpotModel& spot, double view_mm);
  /// @param basis 0 of the narrow, 1 of the wide part of the spot
  double share(std::size_t basis, double across_mm, double down_mm) const;
  /// Where the light that the pen sees of it lies: its middle, from the axis, and its deviations.
  struct Seen {
    Place middle_mm, sigma_mm;
  };
  Seen seen(std::size_t basis, double across_mm, double down_mm) const;
  /// Beyond this distance the pen sees nothing.
  double reach_mm() const;
  /// The least of all widths, as a standard deviation.
  double least_mm() const;

 private:
  struct Widths {
    double across = 0, down = 0;
  };
  double peak(const Widths& w) const;
  double view_;                  // standard deviation
  std::array<Widths, 2> sigma_;  // of spot and view together
};

/// A line's cells in view.
struct LineInView {
  int line = 0, first = 0, cells = 0;
  /// Shares of each gun's spot, step by step while it crosses the cells: [gun][basis].
  std::array<std::array<std::vector<float>, 2>, 3> share;
};

/// What the pen looks through and at.
struct PenView {
  SpotInView spot;
  PenMask mask;
  Place axis;
  int guns = 1;
  int steps = 4;  ///< that a cell is cut into, in which the beam stands
};

/// The lines in view, from the top.
/// @param warp how one sweep of a free raster lies, whose lines they then are; or null
std::vector<LineInView> lines_in_view(const TubeSettings& tube, const PenView& view,
                                      const SweepWarp* warp);

/// How far the beam moves along the glass near a place while a cell is written.
double cell_mm(const TubeSettings& tube, Place place);

}  // namespace kinescope
