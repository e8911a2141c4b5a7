#include "display/pen_view.h"

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

constexpr double kReach = 4;  // standard deviations: three parts in ten thousand are left

/// Cells and lines from the beginning of the sweep; a whole number is where one begins.
struct SweepBox {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
};

class Glass {
 public:
  Glass(const TubeSettings& tube, int gun)
      : deflection_(tube.deflection, tube.glass, gun),
        half_(pixels_a_mm(tube.glass, 2, 2)),
        cells_(tube.mode.horizontal.active),
        lines_(tube.mode.vertical.active) {}

  /// From the axis to where the beam lands, mm.
  Place from_axis(Place axis, double cell, double line) const {
    const Place at = deflection_.glass_of_sweep({2 * cell / cells_ - 1, 2 * line / lines_ - 1});
    return {(at.x - axis.x) / half_.across, (at.y - axis.y) / half_.down};
  }
  /// Cell and line below a place.
  Place cell_below(Place glass) const {
    const Place sweep = deflection_.sweep_of_glass(glass);
    return {0.5 * (sweep.x + 1) * cells_, 0.5 * (sweep.y + 1) * lines_};
  }
  SweepBox box(Place axis, double reach_mm) const {
    SweepBox box;
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        const Place at =
            cell_below({axis.x + i * reach_mm * half_.across, axis.y + j * reach_mm * half_.down});
        box = {std::min(box.left, at.x), std::max(box.right, at.x), std::min(box.top, at.y),
               std::max(box.bottom, at.y)};
      }
    }
    return box;
  }

 private:
  Deflection deflection_;
  PixelsAMm half_;  // shares of half a side a millimetre
  double cells_, lines_;
};

int whole(double at, int most) {
  return static_cast<int>(std::clamp(std::floor(at), 0.0, static_cast<double>(most)));
}

}  // namespace

SpotInView::SpotInView(const SpotModel& spot, double view_mm)
    : view_(view_mm / (2 * std::sqrt(2 * std::log(2.0)))) {
  const std::array<double, 2> down = {spot.narrow_mm(), spot.wide_mm()};
  for (std::size_t basis = 0; basis < 2; ++basis) {
    sigma_[basis] = {std::hypot(view_, down[basis] * spot.astigmatism()),
                     std::hypot(view_, down[basis])};
  }
}

double SpotInView::peak(const Widths& w) const { return view_ * view_ / (w.across * w.down); }

double SpotInView::share(std::size_t basis, double across_mm, double down_mm) const {
  const Widths& w = sigma_[basis];
  const double x = across_mm / w.across, y = down_mm / w.down;
  return peak(w) * std::exp(-0.5 * (x * x + y * y));
}

double SpotInView::reach_mm() const {
  return kReach * std::max({sigma_[0].across, sigma_[0].down, sigma_[1].across, sigma_[1].down});
}

double SpotInView::least_mm() const {
  return std::min({sigma_[0].across, sigma_[0].down, sigma_[1].across, sigma_[1].down});
}

std::vector<LineInView> lines_in_view(const TubeSettings& tube, const SpotInView& spot, int guns,
                                      Place axis, int steps) {
  const int cells = tube.mode.horizontal.active, lines = tube.mode.vertical.active;
  std::vector<Glass> glass;
  SweepBox box;
  for (int gun = 0; gun < guns; ++gun) {
    const SweepBox its = glass.emplace_back(tube, gun).box(axis, spot.reach_mm());
    box = {std::min(box.left, its.left), std::max(box.right, its.right), std::min(box.top, its.top),
           std::max(box.bottom, its.bottom)};
  }
  std::vector<LineInView> in_view;
  const int first = whole(box.left, cells), last = whole(box.right + 1, cells);
  if (first >= last) return in_view;
  for (int line = whole(box.top, lines); line < whole(box.bottom + 1, lines); ++line) {
    LineInView& view = in_view.emplace_back(LineInView{line, first, last - first, {}});
    for (std::size_t gun = 0; gun < glass.size(); ++gun) {
      for (int step = 0; step < view.cells * steps; ++step) {
        const Place at = glass[gun].from_axis(axis, first + (step + 0.5) / steps, line + 0.5);
        for (std::size_t basis = 0; basis < 2; ++basis) {
          view.share[gun][basis].push_back(static_cast<float>(spot.share(basis, at.x, at.y)));
        }
      }
    }
  }
  return in_view;
}

double cell_mm(const TubeSettings& tube, Place place) {
  const Glass glass(tube, 0);
  const Place at = glass.cell_below(place);
  const Place before = glass.from_axis(place, at.x - 0.5, at.y);
  const Place after = glass.from_axis(place, at.x + 0.5, at.y);
  return std::hypot(after.x - before.x, after.y - before.y);
}

}  // namespace kinescope
