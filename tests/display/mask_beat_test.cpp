// Scan lines seen through a mask. Both are patterns; their product holds the sums and differences
// of their frequencies. Differences are beats that a real tube shows. Sums that the picture's
// pixels cannot hold would fold back as beats that it does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "display/tube/shadow_mask.h"
#include "tests/display/tube_fixtures.h"

namespace kinescope {
namespace {

constexpr int kSize = 192;           // of the picture, both ways
constexpr double kGlass_mm = kSize;  // a pixel a millimetre
constexpr int kMostOrder = 3;        // harmonics of mask and lines that are looked for
constexpr double kCoarse = 0.3;      // cycles a pixel: what is finer is no beat to the eye

struct Frequency {
  double x = 0, y = 0;  // cycles a pixel
};

double folded(double f) { return f - std::round(f); }

TubeSettings tube_of(MaskKind kind, double pitch, int lines) {
  VideoMode mode;
  mode.name = "lines";
  mode.horizontal = {kSize, 10, 20, 30};
  mode.vertical = {lines, 2, 3, 9};
  mode.pixel_clock_hz = 60.0 * mode.horizontal.total() * mode.vertical.total();
  TubeSettings tube{mode};
  tube.glass.aspect = 1;
  tube.glass.diagonal_mm = kGlass_mm * std::numbers::sqrt2;
  tube.spot.sigma_mm = 0.3 * kSize / lines;  // lines well apart
  tube.mask.kind = kind;
  tube.mask.pitch_mm = pitch;
  tube.mask.slot_mm = 1.3 * pitch;
  return tube;
}

/// One gun's light in white, mean 1.
std::vector<double> white(const TubeSettings& tube) {
  RasterTube raster(tube, kSize, kSize);
  FrameBuffer buffer = buffer_for(tube.mode, 1);
  fill(buffer, 0, 0x00ff00);
  Workers workers(2);
  raster.expose(buffer, 4 * tube.mode.frame_period(), workers);
  const Image<LinearRgb>& light = raster.expose(buffer, 5 * tube.mode.frame_period(), workers);
  std::vector<double> plane;
  for (const LinearRgb& c : light.pixels()) plane.push_back(static_cast<double>(c.g));
  return plane;
}

/// What a window of raised cosines leaves apart, cycles a pixel.
constexpr double kSpread = 3.0 / kSize;

bool are_near(Frequency a, Frequency b) {
  const auto apart = [](double p, double q) { return std::abs(folded(p - q)); };
  return (apart(a.x, b.x) < kSpread && apart(a.y, b.y) < kSpread) ||
         (apart(a.x, -b.x) < kSpread && apart(a.y, -b.y) < kSpread);
}

/// Amplitude of a frequency, the mean's being 1.
double amplitude(const std::vector<double>& plane, Frequency f) {
  std::vector<std::complex<double>> across;
  const auto window = [](int i) { return 1 - std::cos(2 * std::numbers::pi * (i + 0.5) / kSize); };
  for (int x = 0; x < kSize; ++x) {
    across.push_back(window(x) * std::polar(1.0, -2 * std::numbers::pi * f.x * x));
  }
  std::complex<double> sum = 0;
  double mean = 0;
  for (int y = 0; y < kSize; ++y) {
    std::complex<double> row = 0;
    for (int x = 0; x < kSize; ++x) {
      const auto at = static_cast<std::size_t>(x);
      const double value = plane[static_cast<std::size_t>(y * kSize) + at];
      row += value * across[at];
      mean += value * window(x) * window(y);
    }
    sum += row * window(y) * std::polar(1.0, -2 * std::numbers::pi * f.y * y);
  }
  return 2 * std::abs(sum) / mean;
}

/// Frequencies of mask times lines: those that the picture holds, and where the others would fold
/// to, if that is coarse and apart from the first.
struct Products {
  std::vector<Frequency> held, folds;
};
Products products_of(const TubeSettings& tube) {
  const MaskLattice lattice(tube.mask);
  const double line = static_cast<double>(tube.mode.vertical.active) / kSize;
  Products all;
  for (int k = 0; k <= kMostOrder; ++k) {
    for (int l = -kMostOrder; l <= kMostOrder; ++l) {
      for (int m = -kMostOrder; m <= kMostOrder; ++m) {
        const Frequency f{k / lattice.period_x(), l / lattice.period_y() + m * line};
        const Frequency fold{folded(f.x), folded(f.y)};
        if (f.x == fold.x && f.y == fold.y) {
          all.held.push_back(f);
        } else if (std::hypot(fold.x, fold.y) < kCoarse) {
          all.folds.push_back(fold);
        }
      }
    }
  }
  std::erase_if(all.folds, [&](const Frequency& fold) {
    return std::any_of(all.held.begin(), all.held.end(),
                       [&](const Frequency& f) { return are_near(f, fold); });
  });
  return all;
}

/// The strongest fold, dB against the mean. @param looked_at gets how many there were
double worst_fold_db(const TubeSettings& tube, std::size_t& looked_at) {
  const Products products = products_of(tube);
  const std::vector<double> plane = white(tube);
  double worst = 1e-9;
  for (const Frequency& fold : products.folds) worst = std::max(worst, amplitude(plane, fold));
  looked_at += products.folds.size();
  return 20 * std::log10(worst);
}

TEST(MaskBeat, LinesAndBeatsOfARealTubeAreSeen) {
  const TubeSettings tube = tube_of(MaskKind::kSlots, 4.4, 55);
  const MaskLattice lattice(tube.mask);
  const std::vector<double> plane = white(tube);
  const double line = 55.0 / kSize;
  EXPECT_GT(amplitude(plane, {0, line}), 0.1);
  EXPECT_GT(amplitude(plane, {0, 2 / lattice.period_y() - line}), 0.01);
}

TEST(MaskBeat, LinesBeatWithNoMaskUnlessARealTubesDo) {
  std::size_t looked_at = 0;
  for (const MaskKind kind : {MaskKind::kGrille, MaskKind::kSlots, MaskKind::kDots}) {
    for (const int lines : {64, 61, 55, 48, 43, 37, 31, 26}) {  // 3 to 7.4 rows a line
      for (const double pitch : {2.3, 3.1, 4.4, 6.3}) {
        const double db = worst_fold_db(tube_of(kind, pitch, lines), looked_at);
        EXPECT_LT(db, -30) << static_cast<int>(kind) << " " << lines << " lines, pitch " << pitch;
      }
    }
  }
  EXPECT_GT(looked_at, 500u);
}

}  // namespace
}  // namespace kinescope
