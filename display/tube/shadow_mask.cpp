#include "display/tube/shadow_mask.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "display/tube/deflection.h"

namespace kinescope {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr int kBlock = 8;       // pixels over which the local pitch is taken as one
constexpr int kPad = 16;        // after a row, for whole vectors
constexpr int kMostTerms = 32;  // along an axis

double sinc(double x) {
  return std::abs(x) < 1e-9 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

/// 2 J1(x) / x: a disc's transform.
double jinc(double x) { return x < 1e-6 ? 1 : 2 * std::cyl_bessel_j(1.0, x) / x; }

/// What is left of a frequency, cycles a pixel: a triangle, whose transform is nowhere negative,
/// and so no series of openings becomes so.
double faded(double across, double down) {
  return std::max(0.0, 1 - 2 * std::abs(across)) * std::max(0.0, 1 - 2 * std::abs(down));
}

/// Even noise in [-1/2, 1/2) that depends on the place alone: rounding makes no pattern with it.
double dither(int x, int y) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u;
  h = (h ^ h >> 15) * 0x2c1b3c6du;
  h = (h ^ h >> 12) * 0x297a2d39u;
  return (h ^ h >> 15) * 0x1p-32 - 0.5;
}

/// Where the camera sees the glass, mm from its middle.
class GlassView {
 public:
  GlassView(const GlassSettings& glass, int width, int height)
      : camera_(glass), width_(width), height_(height) {
    const double height_mm = glass.diagonal_mm / std::hypot(glass.aspect, 1.0);
    half_x_ = 0.5 * height_mm * glass.aspect;
    half_y_ = 0.5 * height_mm;
  }
  Place mm(double x, double y) const {
    const Place p = camera_.glass_of_picture({(2 * x + 1) / width_ - 1, (2 * y + 1) / height_ - 1});
    return {p.x * half_x_, p.y * half_y_};
  }

 private:
  Camera camera_;
  double half_x_ = 0, half_y_ = 0;
  int width_, height_;
};

/// A term of the series, its amplitude for each gun; it stands for the pair k, l and -k, -l.
struct Term {
  int k, l;
  std::array<std::complex<double>, 3> amplitude;
};

std::vector<Term> all_terms(const MaskLattice& lattice) {
  std::vector<Term> terms;
  const int most_l = lattice.striped() ? 0 : kMostTerms;
  for (int k = 0; k <= kMostTerms; ++k) {
    for (int l = k == 0 ? 1 : -most_l; l <= most_l; ++l) {
      const double amplitude = 2 * lattice.amplitude(k, l);
      if (std::abs(amplitude) < 1e-4) continue;
      Term term{k, l, {}};
      for (int gun = 0; gun < 3; ++gun) {
        term.amplitude[static_cast<std::size_t>(gun)] =
            std::polar(amplitude, -kTwoPi * k / lattice.period_x() * lattice.offset_mm(gun));
      }
      terms.push_back(term);
    }
  }
  return terms;
}

/// Those that the output resolves around a place, as far as it does.
std::vector<Term> resolved_terms(const std::vector<Term>& all, const MaskLattice& lattice,
                                 const GlassView& view, double x, double y) {
  const Place left = view.mm(x - 0.5, y), right = view.mm(x + 0.5, y);
  const Place above = view.mm(x, y - 0.5), below = view.mm(x, y + 0.5);
  std::vector<Term> terms;
  for (const Term& term : all) {
    const double fx = term.k / lattice.period_x(), fy = term.l / lattice.period_y();
    const double seen = faded(fx * (right.x - left.x) + fy * (right.y - left.y),
                              fx * (below.x - above.x) + fy * (below.y - above.y));
    if (seen <= 0) continue;
    terms.push_back(term);
    for (std::complex<double>& amplitude : terms.back().amplitude) amplitude *= seen;
  }
  return terms;
}

struct Transmission {
  std::array<double, 3> gun{1, 1, 1};
};

Transmission transmission(const std::vector<Term>& terms, const MaskLattice& lattice, Place mm) {
  Transmission sum;
  if (terms.empty()) return sum;
  const double x = kTwoPi * mm.x / lattice.period_x(), y = kTwoPi * mm.y / lattice.period_y();
  for (const Term& term : terms) {
    const double phase = term.k * x + term.l * y;
    const double c = std::cos(phase), s = std::sin(phase);
    for (std::size_t gun = 0; gun < 3; ++gun) {
      sum.gun[gun] += term.amplitude[gun].real() * c - term.amplitude[gun].imag() * s;
    }
  }
  return sum;
}

/// The shadow of a grille's damper wires, spread evenly down the glass, over a pixel's height.
double wire_shadow(const MaskSettings& mask, double half_height_mm, double y_mm, double pixel_mm) {
  double light = 1;
  const double width = std::max(mask.wire_mm, pixel_mm);
  for (int wire = 1; wire <= mask.wires; ++wire) {
    const double at = half_height_mm * (2.0 * wire / (mask.wires + 1) - 1);
    const double away = std::abs(y_mm - at) / width;
    light -= mask.wire_mm / width * std::max(0.0, 1 - away);
  }
  return light;
}

}  // namespace

MaskLattice::MaskLattice(const MaskSettings& mask) : kind_(mask.kind) {
  switch (kind_) {
    case MaskKind::kNone:
      break;
    case MaskKind::kGrille:
      period_x_ = mask.pitch_mm;
      open_x_mm_ = mask.open * mask.pitch_mm / 3;
      break;
    case MaskKind::kSlots:
      // Neighbouring columns of slots are half a slot apart.
      period_x_ = 2 * mask.pitch_mm;
      period_y_ = mask.slot_mm;
      open_x_mm_ = mask.open * mask.pitch_mm / 3;
      open_y_mm_ = (1 - mask.bridge) * mask.slot_mm;
      break;
    case MaskKind::kDots:
      // Like-coloured dots form a hexagonal lattice, the pitch apart; the three colours together
      // a denser one.
      period_x_ = std::numbers::sqrt3 * mask.pitch_mm;
      period_y_ = mask.pitch_mm;
      open_x_mm_ = mask.open * mask.pitch_mm / std::numbers::sqrt3;
      break;
  }
}

double MaskLattice::amplitude(int k, int l) const {
  const double fx = k / period_x_, fy = l / period_y_;
  if (kind_ == MaskKind::kGrille) return l == 0 ? sinc(fx * open_x_mm_) : 0;
  if ((k + l) % 2 != 0) return 0;
  if (kind_ == MaskKind::kSlots) return sinc(fx * open_x_mm_) * sinc(fy * open_y_mm_);
  return jinc(std::numbers::pi * std::hypot(fx, fy) * open_x_mm_);
}

double MaskLattice::offset_mm(int gun) const {
  return (gun - 1) * (kind_ == MaskKind::kSlots ? period_x_ / 6 : period_x_ / 3);
}

ShadowMask::ShadowMask(const MaskSettings& mask, const GlassSettings& glass, int width,
                       int height) {
  if (mask.kind == MaskKind::kNone) return;
  const MaskLattice lattice(mask);
  const GlassView view(glass, width, height);
  pitch_ = width + kPad;
  for (auto& plane : planes_) {
    plane.assign(static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(height), kOne);
  }
  const double half_height_mm = 0.5 * glass.diagonal_mm / std::hypot(glass.aspect, 1.0);
  const bool flat = glass.curvature_mm <= 0;
  const std::vector<Term> all = all_terms(lattice);
  std::vector<Term> terms = resolved_terms(all, lattice, view, 0.5 * width, 0.5 * height);
  for (int top = 0; top < height; top += kBlock) {
    for (int left = 0; left < width; left += kBlock) {
      if (!flat)
        terms = resolved_terms(all, lattice, view, left + 0.5 * kBlock, top + 0.5 * kBlock);
      for (int y = top; y < std::min(height, top + kBlock); ++y) {
        const Place here = view.mm(left, y), next = view.mm(left, y + 1);
        const double wires = mask.kind == MaskKind::kGrille && mask.wires > 0
                                 ? wire_shadow(mask, half_height_mm, here.y, next.y - here.y)
                                 : 1;
        for (int x = left; x < std::min(width, left + kBlock); ++x) {
          const double noise = dither(x, y);
          const Transmission t = transmission(terms, lattice, view.mm(x, y));
          for (std::size_t gun = 0; gun < 3; ++gun) {
            const double code =
                std::clamp(std::floor(kOne * wires * t.gun[gun] + noise + 0.5), 0.0, 255.0);
            planes_[gun][static_cast<std::size_t>(y * pitch_ + x)] =
                static_cast<std::uint8_t>(code);
          }
        }
      }
    }
  }
}

}  // namespace kinescope
