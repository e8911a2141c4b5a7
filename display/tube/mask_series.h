// A mask's Fourier series, as far as a picture's pixels resolve it: summed first over the terms
// that share a frequency across, so that the guns, whose openings differ by a shift across, share
// most of the work.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "display/tube/deflection.h"
#include "display/tube/shadow_mask.h"

namespace kinescope {

/// Millimetres of glass from one output pixel to the next, to the right and down.
struct PixelStep {
  Place right, down;
};

class MaskSeries {
 public:
  static constexpr int kPlaces = 8;
  using Row = std::array<float, kPlaces>;

  explicit MaskSeries(const MaskLattice& lattice);
  /// Drops the terms that none of these places resolves, nor any between them.
  void drop_unresolved(std::span<const PixelStep> places);
  /// Sums from now on for pixels of that size.
  void set_step(const PixelStep& step);
  /// Transmission of the three guns, the mean being 1, at a row of places on the glass, mm.
  /// @param step from each place to the next
  std::array<Row, 3> at(Place first, Place step) const;

 private:
  /// Of the pair k, l and -k, -l.
  struct Term {
    int k, l;
    float amplitude;
  };
  /// k, l and k, -l together: even * cos(l y) + i odd * sin(l y).
  struct Pair {
    int l = 0;
    float even = 0, odd = 0;
  };
  double seen(const Term& term, const PixelStep& step) const;

  double period_x_, period_y_;
  std::vector<Term> terms_;
  std::vector<std::vector<Pair>> pairs_;  // of each k, as far as they are resolved
  int most_l_ = 0;
  std::vector<std::array<float, 3>> gun_cos_, gun_sin_;  // of each gun's shift, of each k
};

}  // namespace kinescope
