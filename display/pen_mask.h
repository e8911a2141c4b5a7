// What a shadow mask lets a light pen see of a spot: the integral of view, spot and mask over the
// glass, in closed form. View and spot are Gaussians, so their product is one; the mask is its
// Fourier series, each term of which the product's width weakens.
#pragma once

#include <array>
#include <vector>

#include "display/tube/deflection.h"
#include "display/tube/shadow_mask.h"

namespace kinescope {

class PenMask {
 public:
  /// Lets everything through.
  PenMask() = default;
  /// A grille's damper wires are left out.
  /// @param sigma_mm deviations of the product, of the narrow and the wide part of the spot
  PenMask(const MaskSettings& mask, const std::array<Place, 2>& sigma_mm);

  /// Of such a product with that middle, mm from the glass's: the share of its light that comes
  /// through a gun's openings, the mask's mean being 1.
  double share(int gun, std::size_t basis, Place middle_mm) const;

 private:
  struct Term {
    double x, y;       // radians a mm
    double amplitude;  // weakened
  };
  std::array<std::vector<Term>, 2> terms_;
  std::array<double, 3> offset_mm_{};
};

}  // namespace kinescope
