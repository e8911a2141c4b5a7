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
  Glass(const TubeSettings& tube, int gun, int lines)
      : deflection_(tube.deflection, tube.glass, gun),
        half_(pixels_a_mm(tube.glass, 2, 2)),
        cells_(tube.mode.horizontal.active),
        lines_(lines) {}

  /// From the axis to where the beam lands, mm.
  Place from_axis(Place axis, double cell, double line) const {
    const Place at = deflection_.glass_of_sweep({2 * cell / cells_ - 1, 2 * line / lines_ - 1});
    return {(at.x - axis.x) / half_.across, (at.y - axis.y) / half_.down};
  }
  /// From the middle of the glass, mm.
  Place mm(Place glass) const { return {glass.x / half_.across, glass.y / half_.down}; }
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

/// How a line of the sweep lies on a raster that is where it should be.
struct LinePlace {
  double line, scale, shift, middle;
  double cell(double swept) const { return (swept - middle) * scale + middle + shift; }
  double swept(double cell) const { return (cell - middle - shift) / scale + middle; }
};
LinePlace place_of(const SweepWarp* warp, int line, int cells) {
  const double middle = 0.5 * cells;
  if (!warp) return {line + 0.5, 1, 0, middle};
  const auto l = static_cast<std::size_t>(line);
  return {static_cast<double>(warp->place[l]) + 0.5, static_cast<double>(warp->scale[l]),
          static_cast<double>(warp->shift[l]), middle};
}

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

SpotInView::Seen SpotInView::seen(std::size_t basis, double across_mm, double down_mm) const {
  // The product of the two Gaussians.
  const Widths& w = sigma_[basis];
  const double x = view_ * view_ / (w.across * w.across), y = view_ * view_ / (w.down * w.down);
  return {{across_mm * x, down_mm * y},
          {view_ * std::sqrt(std::max(0.0, 1 - x)), view_ * std::sqrt(std::max(0.0, 1 - y))}};
}

namespace {

/// The shares of one gun's spot along the line.
void follow_line(const PenView& view, const Glass& glass, int gun, const LinePlace& place,
                 LineInView& line) {
  const Place axis_mm = glass.mm(view.axis);
  auto& shares = line.share[static_cast<std::size_t>(gun)];
  for (int step = 0; step < line.cells * view.steps; ++step) {
    const double swept = line.first + (step + 0.5) / view.steps;
    const Place at = glass.from_axis(view.axis, place.cell(swept), place.line);
    for (std::size_t basis = 0; basis < 2; ++basis) {
      const SpotInView::Seen seen = view.spot.seen(basis, at.x, at.y);
      const Place middle{axis_mm.x + seen.middle_mm.x, axis_mm.y + seen.middle_mm.y};
      shares[basis].push_back(static_cast<float>(view.spot.share(basis, at.x, at.y) *
                                                 view.mask.share(gun, basis, middle)));
    }
  }
}

}  // namespace

std::vector<LineInView> lines_in_view(const TubeSettings& tube, const PenView& view,
                                      const SweepWarp* warp) {
  const int cells = tube.mode.horizontal.active;
  const int lines = warp ? static_cast<int>(warp->place.size()) : tube.mode.vertical.active;
  std::vector<Glass> glass;
  SweepBox box;
  for (int gun = 0; gun < view.guns; ++gun) {
    const SweepBox its = glass.emplace_back(tube, gun, lines).box(view.axis, view.spot.reach_mm());
    box = {std::min(box.left, its.left), std::max(box.right, its.right), std::min(box.top, its.top),
           std::max(box.bottom, its.bottom)};
  }
  std::vector<LineInView> in_view;
  for (int number = 0; number < lines; ++number) {
    const LinePlace place = place_of(warp, number, cells);
    if (place.line + 0.5 <= std::floor(box.top) || place.line - 0.5 >= box.bottom) continue;
    const int first = whole(place.swept(box.left), cells);
    const int last = whole(place.swept(box.right) + 1, cells);
    if (first >= last) continue;
    LineInView& line = in_view.emplace_back(LineInView{number, first, last - first, {}});
    for (int gun = 0; gun < view.guns; ++gun) {
      follow_line(view, glass[static_cast<std::size_t>(gun)], gun, place, line);
    }
  }
  return in_view;
}

double cell_mm(const TubeSettings& tube, Place place) {
  const Glass glass(tube, 0, tube.mode.vertical.active);
  const Place at = glass.cell_below(place);
  const Place before = glass.from_axis(place, at.x - 0.5, at.y);
  const Place after = glass.from_axis(place, at.x + 0.5, at.y);
  return std::hypot(after.x - before.x, after.y - before.y);
}

}  // namespace kinescope
