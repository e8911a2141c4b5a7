#include "display/tube/gun.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kinescope {
namespace {

constexpr int kCodes = 256;

/// A Gaussian low-pass that passes 1/sqrt(2) at the bandwidth; its delay is the deflection's too.
std::vector<float> gaussian_response(double bandwidth_hz, double pixel_clock_hz) {
  if (bandwidth_hz <= 0) return {1.0f};
  const double sigma =
      std::sqrt(std::numbers::ln2) / (2 * std::numbers::pi * bandwidth_hz) * pixel_clock_hz;
  const int reach = static_cast<int>(std::ceil(3.5 * sigma));
  std::vector<double> exact;
  double sum = 0;
  for (int i = -reach; i <= reach; ++i) {
    const double scale = 1 / (sigma * std::numbers::sqrt2);
    exact.push_back(0.5 * (std::erf((i + 0.5) * scale) - std::erf((i - 0.5) * scale)));
    sum += exact.back();
  }
  std::vector<float> response;
  for (const double w : exact) response.push_back(static_cast<float>(w / sum));
  return response;
}

/// Calls body(code_of), by which a gun finds its drive, once for a line rather than for a pixel.
template <typename Body>
void with_signal(Signal signal, const Body& body) {
  switch (signal) {
    case Signal::kRed:
      return body([](const GunDrive& d) { return d.r; });
    case Signal::kGreen:
      return body([](const GunDrive& d) { return d.g; });
    case Signal::kBlue:
      return body([](const GunDrive& d) { return d.b; });
    case Signal::kGrey:
      return body([](const GunDrive& d) {
        return static_cast<std::uint8_t>((77 * d.r + 150 * d.g + 29 * d.b + 128) >> 8);
      });
  }
}

}  // namespace

Gun::Gun(const GunSettings& settings, const SpotModel& spot, double pixel_clock_hz)
    : settings_(settings),
      spot_(spot),
      response_(gaussian_response(settings.bandwidth_hz, pixel_clock_hz)) {
  for (int code = 0; code < kCodes; ++code) of_code_.push_back(dose(code / 255.0));
  const auto as_float = [](double v) { return static_cast<float>(v); };
  law_.contrast = as_float(settings.contrast / 255);
  law_.brightness = as_float(settings.brightness);
  law_.third_of_gamma = as_float(settings.gamma / 3);
  const double none = std::max(spot.sigma_mm(0), 1e-6);
  law_.least = as_float(none);
  law_.growth = as_float(spot.sigma_mm(1) - none);
  const double narrow = std::max(spot.narrow_mm(), none), wide = std::max(spot.wide_mm(), none);
  law_.narrow = as_float(narrow);
  law_.wide = as_float(wide);
  if (wide > narrow * (1 + 1e-9)) {
    // As SpotModel::wide_part has it.
    const double between = 1 / (narrow * narrow) - 1 / (wide * wide);
    law_.at_wide = as_float(1 / (narrow * narrow) / between);
    law_.by_square = as_float(1 / between);
  }
}

double Gun::current(double drive) const {
  const double grid = settings_.contrast * drive + settings_.brightness;
  return grid > 0 ? std::pow(grid, settings_.gamma) : 0;
}

double Gun::blanked_current(bool sync_tip) const {
  return current(-settings_.blanking - (sync_tip ? settings_.sync : 0));
}

Gun::Dose Gun::dose(double drive) const {
  const double all = current(drive), wide = spot_.wide_part(all);
  return {static_cast<float>(all - wide), static_cast<float>(wide)};
}

void Gun::doses(std::span<const GunDrive> drives, Signal signal, std::span<float> voltage,
                float* narrow, float* wide, std::span<const CellSpan> tips) const {
  const std::size_t n = drives.size(), pad = static_cast<std::size_t>(reach());
  with_signal(signal, [&](auto code_of) {
    if (pad == 0) {
      for (std::size_t i = 0; i < n; ++i) {
        const Dose d = of_code_[code_of(drives[i])];
        narrow[i] = d.narrow;
        wide[i] = d.wide;
      }
    } else {
      for (std::size_t i = 0; i < n; ++i) voltage[pad + i] = code_of(drives[i]);
    }
  });
  if (pad == 0) {
    const Dose tip = dose(-settings_.sync);
    for (const CellSpan& span : tips) {
      std::fill(narrow + span.begin, narrow + span.end, tip.narrow);
      std::fill(wide + span.begin, wide + span.end, tip.wide);
    }
    return;
  }
  for (const CellSpan& span : tips) {
    const auto first = voltage.begin() + static_cast<std::ptrdiff_t>(pad);
    std::fill(first + span.begin, first + span.end, static_cast<float>(-255 * settings_.sync));
  }
  std::fill_n(voltage.begin(), pad, 0.0f);
  std::fill_n(voltage.begin() + static_cast<std::ptrdiff_t>(pad + n), pad, 0.0f);
  amplify(static_cast<int>(n), response_, law_, voltage.data(), narrow, wide);
}

}  // namespace kinescope
