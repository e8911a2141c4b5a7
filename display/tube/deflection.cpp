#include "display/tube/deflection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kinescope {
namespace {

double half_height_mm(const GlassSettings& glass) {
  return 0.5 * glass.diagonal_mm / std::hypot(glass.aspect, 1.0);
}

/// A sweep whose ends are slower by `share` than its middle, from -1 to 1 as before.
double s_shaped(double t, double share) { return t * (1 + 0.5 * share * (1 - t * t)); }

}  // namespace

PixelsAMm pixels_a_mm(const GlassSettings& glass, int width, int height) {
  const double half = half_height_mm(glass);
  return {0.5 * width / (half * glass.aspect), 0.5 * height / half};
}

Deflection::Deflection(const DeflectionSettings& settings, const GlassSettings& glass, int gun)
    : d_(settings),
      error_(settings.convergence[static_cast<std::size_t>(gun)]),
      half_width_mm_(half_height_mm(glass) * glass.aspect),
      half_height_mm_(half_height_mm(glass)),
      cos_(std::cos(settings.rotation_deg * std::numbers::pi / 180)),
      sin_(std::sin(settings.rotation_deg * std::numbers::pi / 180)) {}

Place Deflection::glass_of_sweep(Place sweep) const {
  const double s = s_shaped(sweep.x, d_.s_curve), t = s_shaped(sweep.y, d_.s_curve);
  const double x =
      d_.width * s * (1 + d_.keystone * t) * (1 + d_.pincushion_x * (t * t - 1)) + d_.shift_x;
  const double y = d_.height * t * (1 + d_.pincushion_y * (s * s - 1)) + d_.shift_y;
  // Rotated in millimetres, so that the picture stays a rectangle.
  const double x_mm = x * half_width_mm_, y_mm = y * half_height_mm_;
  const double far = s * s + t * t;
  return {(x_mm * cos_ - y_mm * sin_ + error_.x_mm + error_.edge_x_mm * far * s) / half_width_mm_,
          (x_mm * sin_ + y_mm * cos_ + error_.y_mm + error_.edge_y_mm * far * t) / half_height_mm_};
}

Place Deflection::sweep_of_glass(Place glass) const {
  constexpr double kStep = 1e-5, kClose = 1e-10;
  constexpr int kMostRounds = 30;
  Place sweep = glass;
  for (int round = 0; round < kMostRounds; ++round) {
    const Place at = glass_of_sweep(sweep);
    const double ex = glass.x - at.x, ey = glass.y - at.y;
    if (std::abs(ex) + std::abs(ey) < kClose) break;
    const Place right = glass_of_sweep({sweep.x + kStep, sweep.y});
    const Place below = glass_of_sweep({sweep.x, sweep.y + kStep});
    const double a = (right.x - at.x) / kStep, b = (below.x - at.x) / kStep;
    const double c = (right.y - at.y) / kStep, d = (below.y - at.y) / kStep;
    const double det = a * d - b * c;
    if (!(std::abs(det) > 1e-9)) break;
    sweep.x += (d * ex - b * ey) / det;
    sweep.y += (a * ey - c * ex) / det;
  }
  return sweep;
}

bool is_separable(const TubeSettings& settings) {
  const DeflectionSettings& d = settings.deflection;
  bool apart = settings.glass.curvature_mm == 0 && d.pincushion_x == 0 && d.pincushion_y == 0 &&
               d.keystone == 0 && d.rotation_deg == 0;
  for (const ConvergenceError& e : d.convergence) apart &= e.edge_x_mm == 0 && e.edge_y_mm == 0;
  return apart;
}

GlassCamera::GlassCamera(const GlassSettings& glass)
    : half_width_mm_(half_height_mm(glass) * glass.aspect),
      half_height_mm_(half_height_mm(glass)),
      radius_mm_(glass.curvature_mm),
      distance_mm_(glass.distance_mm),
      scale_(1) {
  if (radius_mm_ <= 0) return;
  // The ends of the picture's horizontal axis lie at the ends of the glass's.
  const double angle = half_width_mm_ / radius_mm_;
  const double from_axis = radius_mm_ * std::sin(angle);
  const double depth = distance_mm_ + radius_mm_ * (1 - std::cos(angle));
  scale_ = from_axis / depth / half_width_mm_;
}

/// Along the sphere from its middle, of what the camera sees `slope` from its axis.
double GlassCamera::along_glass(double slope) const {
  // The ray (slope * z, z) meets the sphere about (0, distance + radius).
  const double centre = distance_mm_ + radius_mm_;
  const double a = 1 + slope * slope;
  const double c = centre * centre - radius_mm_ * radius_mm_;
  const double root = centre * centre - a * c;
  if (root <= 0) return 10 * radius_mm_;  // beside the tube
  const double z = (centre - std::sqrt(root)) / a;
  return radius_mm_ * std::asin(slope * z / radius_mm_);
}

Place GlassCamera::glass_of_picture(Place picture) const {
  if (radius_mm_ <= 0) return picture;
  const double x = picture.x * half_width_mm_ * scale_, y = picture.y * half_height_mm_ * scale_;
  const double slope = std::hypot(x, y);
  if (slope < 1e-12) return {0, 0};
  const double along = along_glass(slope);
  return {along * x / slope / half_width_mm_, along * y / slope / half_height_mm_};
}

Place GlassCamera::picture_of_glass(Place glass) const {
  if (radius_mm_ <= 0) return glass;
  const double x = glass.x * half_width_mm_, y = glass.y * half_height_mm_;
  const double along = std::hypot(x, y);
  if (along < 1e-12) return {0, 0};
  const double angle = std::min(along / radius_mm_, 0.5 * std::numbers::pi);
  const double depth = distance_mm_ + radius_mm_ * (1 - std::cos(angle));
  const double slope = radius_mm_ * std::sin(angle) / depth / along / scale_;
  return {slope * x / half_width_mm_, slope * y / half_height_mm_};
}

}  // namespace kinescope
