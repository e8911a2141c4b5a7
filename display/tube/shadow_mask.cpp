#include "display/tube/shadow_mask.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "display/tube/deflection.h"
#include "display/tube/mask_series.h"

namespace kinescope {
namespace {

constexpr int kBlock = 8;  // pixels over which the local pitch is taken as one
constexpr int kPad = 16;   // after a row, for whole vectors

double sinc(double x) {
  return std::abs(x) < 1e-9 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

/// 2 J1(x) / x: a disc's transform.
double jinc(double x) { return x < 1e-6 ? 1 : 2 * std::cyl_bessel_j(1.0, x) / x; }

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
  PixelStep step(double x, double y) const {
    return {between(mm(x - 0.5, y), mm(x + 0.5, y)), between(mm(x, y - 0.5), mm(x, y + 0.5))};
  }

 private:
  static Place between(Place a, Place b) { return {b.x - a.x, b.y - a.y}; }

  GlassCamera camera_;
  double half_x_ = 0, half_y_ = 0;
  int width_, height_;
};

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

namespace {

/// Places of the glass under a block of pixels, between its corners: a camera bends so little
/// there.
class BlockPlaces {
 public:
  BlockPlaces(const GlassView& view, int left, int top)
      : corner_{view.mm(left, top), view.mm(left + kBlock, top), view.mm(left, top + kBlock),
                view.mm(left + kBlock, top + kBlock)} {}
  Place at(int x, int y) const {
    const double u = static_cast<double>(x) / kBlock, v = static_cast<double>(y) / kBlock;
    const auto mix = [&](double a, double b, double c, double d) {
      return (1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d);
    };
    return {mix(corner_[0].x, corner_[1].x, corner_[2].x, corner_[3].x),
            mix(corner_[0].y, corner_[1].y, corner_[2].y, corner_[3].y)};
  }

 private:
  Place corner_[4];
};

MaskSeries resolved_series(const MaskLattice& lattice, const GlassView& view, int width,
                           int height) {
  constexpr int kSamples = 8;  // along each axis
  std::vector<PixelStep> steps;
  for (int j = 0; j <= kSamples; ++j) {
    for (int i = 0; i <= kSamples; ++i) {
      steps.push_back(view.step(1.0 * i * width / kSamples, 1.0 * j * height / kSamples));
    }
  }
  MaskSeries series(lattice);
  series.drop_unresolved(steps);
  series.set_step(view.step(0.5 * width, 0.5 * height));
  return series;
}

}  // namespace

/// Stripes on a flat glass are alike in all rows that no wire darkens, but for the rounding: kAlike
/// rows of those do for all.
void ShadowMask::find_stored_rows(std::span<const double> light_of_row, bool alike) {
  constexpr int kAlike = 16;
  int rows = alike ? kAlike : 0;
  for (std::size_t y = 0; y < light_of_row.size(); ++y) {
    const bool shared = alike && light_of_row[y] == 1;
    stored_.push_back(shared ? static_cast<int>(y) % kAlike : rows++);
  }
  for (auto& plane : planes_) {
    plane.assign(static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(rows), kOne);
  }
}

ShadowMask::ShadowMask(const MaskSettings& mask, const GlassSettings& glass, int width,
                       int height) {
  if (mask.kind == MaskKind::kNone) return;
  const GlassView view(glass, width, height);
  pitch_ = width + kPad;
  const double half_height_mm = 0.5 * glass.diagonal_mm / std::hypot(glass.aspect, 1.0);
  const bool flat = glass.curvature_mm <= 0, stripes = mask.kind == MaskKind::kGrille;
  const bool wires = stripes && mask.wires > 0;
  std::vector<double> light(static_cast<std::size_t>(height), 1.0);
  for (int y = 0; wires && flat && y < height; ++y) {
    const double y_mm = view.mm(0, y).y;
    light[static_cast<std::size_t>(y)] =
        wire_shadow(mask, half_height_mm, y_mm, view.mm(0, y + 1).y - y_mm);
  }
  find_stored_rows(light, flat && stripes);
  MaskSeries series = resolved_series(MaskLattice(mask), view, width, height);
  std::vector<bool> done(planes_[0].size() / static_cast<std::size_t>(pitch_));
  for (int top = 0; top < height; top += kBlock) {
    for (int left = 0; left < width; left += kBlock) {
      if (!flat) series.set_step(view.step(left + 0.5 * kBlock, top + 0.5 * kBlock));
      const BlockPlaces places(view, left, top);
      for (int y = 0; y < std::min(height - top, kBlock); ++y) {
        const int row = stored_[static_cast<std::size_t>(top + y)];
        if (done[static_cast<std::size_t>(row)]) continue;
        const Place first = places.at(0, y), next = places.at(1, y);
        const double down_mm = places.at(0, y + 1).y - first.y;
        const double lit = wires ? wire_shadow(mask, half_height_mm, first.y, down_mm) : 1;
        store(series.at(first, {next.x - first.x, next.y - first.y}), lit, left, row,
              std::min(width - left, kBlock));
      }
    }
    for (int y = top; y < std::min(height, top + kBlock); ++y) {
      done[static_cast<std::size_t>(stored_[static_cast<std::size_t>(y)])] = true;
    }
  }
}

void ShadowMask::store(const std::array<std::array<float, 8>, 3>& transmission, double light,
                       int left, int y, int count) {
  for (int x = 0; x < count; ++x) {
    const double noise = dither(left + x, y);
    for (std::size_t gun = 0; gun < 3; ++gun) {
      const double share =
          light * static_cast<double>(transmission[gun][static_cast<std::size_t>(x)]);
      const double code = std::clamp(std::floor(kOne * share + noise + 0.5), 0.0, 255.0);
      planes_[gun][static_cast<std::size_t>(y * pitch_ + left + x)] =
          static_cast<std::uint8_t>(code);
    }
  }
}

}  // namespace kinescope
