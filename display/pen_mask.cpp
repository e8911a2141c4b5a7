#include "display/pen_mask.h"

#include <cmath>
#include <numbers>

namespace kinescope {
namespace {

constexpr int kMostTerms = 16;   // along an axis
constexpr double kLeast = 1e-4;  // amplitude that counts

/// A Gaussian's transform.
double weakened(double x, double y, Place sigma_mm) {
  const double a = x * sigma_mm.x, b = y * sigma_mm.y;
  return std::exp(-0.5 * (a * a + b * b));
}

}  // namespace

PenMask::PenMask(const MaskSettings& mask, const std::array<Place, 2>& sigma_mm) {
  if (mask.kind == MaskKind::kNone) return;
  const MaskLattice lattice(mask);
  const int most_l = lattice.striped() ? 0 : kMostTerms;
  for (int k = 0; k <= kMostTerms; ++k) {
    for (int l = k == 0 ? 1 : -most_l; l <= most_l; ++l) {
      const double x = 2 * std::numbers::pi * k / lattice.period_x();
      const double y = 2 * std::numbers::pi * l / lattice.period_y();
      const double amplitude = 2 * lattice.amplitude(k, l);
      for (std::size_t basis = 0; basis < 2; ++basis) {
        const double seen = amplitude * weakened(x, y, sigma_mm[basis]);
        if (std::abs(seen) >= kLeast) terms_[basis].push_back({x, y, seen});
      }
    }
  }
  for (int gun = 0; gun < 3; ++gun) {
    offset_mm_[static_cast<std::size_t>(gun)] = lattice.offset_mm(gun);
  }
}

double PenMask::share(int gun, std::size_t basis, Place middle_mm) const {
  const double x = middle_mm.x - offset_mm_[static_cast<std::size_t>(gun)];
  double sum = 1;
  for (const Term& term : terms_[basis]) {
    sum += term.amplitude * std::cos(term.x * x + term.y * middle_mm.y);
  }
  return sum;
}

}  // namespace kinescope
