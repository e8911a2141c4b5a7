// Phosphors: how excitation becomes light that decays. Data: display/data/phosphors.txt.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raster/base/units.h"
#include "raster/colour/colour.h"

namespace kinescope {

/// One decaying exponential of an impulse response: light a(t) = share / tau * exp(-t / tau).
struct DecayTerm {
  double share = 0;  ///< of the whole light; shares of a phosphor add up to 1
  Seconds tau{0};
};

/// One phosphor layer: a colour and its law. Linear in energy.
struct Phosphor {
  std::string name;  ///< "P31", "P22R"
  LinearRgb colour;  ///< linear sRGB of its light at luminance 1 (may lie out of gamut)
  std::vector<DecayTerm> terms;
  std::string source;  ///< where the figures come from, and the fit's error

  /// Light still to come after t, as a share of a short pulse's whole light.
  double remaining(Seconds t) const;
  /// Brightness at t after *continuous* excitation ended, relative to that during it.
  double decay_after_steady(Seconds t) const;
};

/// A screen's phosphors: one for a monochrome tube, three (red, green, blue) for P22.
std::span<const Phosphor> phosphors();
/// @throws Error (usage) naming the known ones
const Phosphor& find_phosphor(std::string_view name);

}  // namespace kinescope
