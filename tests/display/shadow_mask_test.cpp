#include "display/tube/shadow_mask.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "display/tube/mask_series.h"

namespace kinescope {
namespace {

GlassSettings glass_of(double curvature_mm) {
  GlassSettings glass;
  glass.diagonal_mm = 100;  // 80 by 60 mm
  glass.curvature_mm = curvature_mm;
  glass.distance_mm = 300;
  return glass;
}

MaskSettings mask_of(MaskKind kind, double pitch_mm) {
  MaskSettings mask;
  mask.kind = kind;
  mask.pitch_mm = pitch_mm;
  mask.slot_mm = 1.3 * pitch_mm;
  return mask;
}

constexpr MaskKind kKinds[] = {MaskKind::kGrille, MaskKind::kSlots, MaskKind::kDots};

TEST(ShadowMask, LetsThroughTheSameOfEveryGunOnAverage) {
  for (const MaskKind kind : kKinds) {
    const ShadowMask mask(mask_of(kind, 1), glass_of(0), 480, 360);  // 6 pixels a triad
    for (int gun = 0; gun < 3; ++gun) {
      double sum = 0;
      for (int y = 0; y < 360; ++y) {
        for (int x = 0; x < 480; ++x) sum += mask.row(gun, y, 0)[x];
      }
      EXPECT_NEAR(sum / (480 * 360), static_cast<double>(mask.one()),
                  0.01 * static_cast<double>(mask.one()));
    }
  }
}

TEST(ShadowMask, AGrillesStripesLieAThirdOfAPitchApart) {
  const ShadowMask mask(mask_of(MaskKind::kGrille, 2), glass_of(0), 480, 360);  // 12 pixels
  // The middle of the picture is the middle of a green stripe.
  EXPECT_GT(mask.row(1, 100, 0)[240], 1.5f * mask.one());
  EXPECT_LT(mask.row(0, 100, 0)[240], 0.4f * mask.one());
  EXPECT_GT(mask.row(2, 100, 0)[244], 1.5f * mask.one());
  EXPECT_GT(mask.row(0, 100, 0)[236], 1.5f * mask.one());
}

TEST(ShadowMask, IsATintWherePixelsCannotShowIt) {
  for (const MaskKind kind : kKinds) {
    const ShadowMask mask(mask_of(kind, 0.2), glass_of(0), 320, 240);  // 0.8 pixels a triad
    for (int x = 0; x < 320; ++x) ASSERT_EQ(mask.row(1, 77, 0)[x], mask.one());
  }
}

/// Power of a plane, less its mean, at frequencies below `highest` cycles a pixel along both axes,
/// against the mean's, dB: where a mask has no detail of its own.
double low_power_db(const ShadowMask& mask, int gun, int size, double highest) {
  const int most = static_cast<int>(highest * size);
  std::vector<std::complex<double>> rows(static_cast<std::size_t>(size * (2 * most + 1)));
  double mean = 0;
  const auto window = [&](int i) { return 1 - std::cos(2 * std::numbers::pi * (i + 0.5) / size); };
  for (int y = 0; y < size; ++y) {
    for (int k = -most; k <= most; ++k) {
      std::complex<double> sum = 0;
      for (int x = 0; x < size; ++x) {
        sum += window(x) * mask.row(gun, y, 0)[x] / 48.0 *
               std::polar(1.0, -2 * std::numbers::pi * k * x / size);
      }
      rows[static_cast<std::size_t>(y * (2 * most + 1) + k + most)] = sum;
    }
  }
  double power = 0;
  for (int k = -most; k <= most; ++k) {
    for (int l = -most; l <= most; ++l) {
      std::complex<double> sum = 0;
      for (int y = 0; y < size; ++y) {
        sum += window(y) * rows[static_cast<std::size_t>(y * (2 * most + 1) + k + most)] *
               std::polar(1.0, -2 * std::numbers::pi * l * y / size);
      }
      if (std::abs(k) <= 2 && std::abs(l) <= 2) {
        mean = std::max(mean, std::norm(sum));  // the window spreads the mean over these
      } else {
        power = std::max(power, std::norm(sum));
      }
    }
  }
  return 10 * std::log10(power / mean);
}

TEST(ShadowMask, MakesNoMoireAtAnyScale) {
  // The lowest frequency of each mask is above a third of a cycle a pitch; what lies below a fifth
  // was aliased down.
  for (const MaskKind kind : kKinds) {
    for (const double curvature_mm : {0.0, 120.0}) {
      for (const double pixels : {0.7, 1.3, 1.9, 2.2, 2.6, 3.1, 4.7, 6.3, 8.0}) {
        const int size = 160;
        MaskSettings mask = mask_of(kind, pixels * 80 / size);
        const ShadowMask plane(mask, glass_of(curvature_mm), size, size);
        const double highest = std::min(0.2 / pixels, 0.12);
        EXPECT_LT(low_power_db(plane, 1, size, highest), -50)
            << static_cast<int>(kind) << " " << curvature_mm << " " << pixels;
      }
    }
  }
}

TEST(ShadowMask, DamperWiresDarkenARow) {
  MaskSettings settings = mask_of(MaskKind::kGrille, 0.2);
  settings.wires = 1;
  settings.wire_mm = 0.1;
  const ShadowMask mask(settings, glass_of(0), 320, 240);
  EXPECT_LT(mask.row(1, 120, 0)[50], 0.95f * mask.one());
  EXPECT_EQ(mask.row(1, 60, 0)[50], mask.one());
}

/// Term by term, as the series is defined.
double direct_sum(const MaskLattice& lattice, const PixelStep& step, int gun, Place mm) {
  double sum = 1;
  for (int k = -32; k <= 32; ++k) {
    for (int l = -32; l <= 32; ++l) {
      if ((k == 0 && l == 0) || (lattice.striped() && l != 0)) continue;
      const double fx = k / lattice.period_x(), fy = l / lattice.period_y();
      const double across = std::abs(fx * step.right.x + fy * step.right.y);
      const double down = std::abs(fx * step.down.x + fy * step.down.y);
      const double seen = std::max(0.0, 1 - 2 * across) * std::max(0.0, 1 - 2 * down);
      const double turns = fx * (mm.x - lattice.offset_mm(gun)) + fy * mm.y;
      sum += seen * lattice.amplitude(k, l) * std::cos(2 * std::numbers::pi * turns);
    }
  }
  return sum;
}

TEST(MaskSeries, IsTheSumOfItsTerms) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-150, 150);
  for (const MaskKind kind : kKinds) {
    const MaskLattice lattice(mask_of(kind, 0.4));
    for (const double pixel : {0.03, 0.11, 0.19}) {
      const PixelStep step{{pixel, 0.1 * pixel}, {-0.05 * pixel, 0.9 * pixel}};
      MaskSeries series(lattice);
      series.drop_unresolved(std::span(&step, 1));
      series.set_step(step);
      const Place first{place(random), place(random)};
      const auto sums = series.at(first, step.right);
      for (std::size_t i = 0; i < MaskSeries::kPlaces; ++i) {
        const double n = static_cast<double>(i);
        const Place at{first.x + n * step.right.x, first.y + n * step.right.y};
        for (int gun = 0; gun < 3; ++gun) {
          EXPECT_NEAR(static_cast<double>(sums[static_cast<std::size_t>(gun)][i]),
                      direct_sum(lattice, step, gun, at), 5e-3)
              << pixel << " mm, mask " << static_cast<int>(kind);
        }
      }
    }
  }
}

}  // namespace
}  // namespace kinescope
