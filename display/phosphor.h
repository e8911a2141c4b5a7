// Phosphors: how excitation becomes light that decays. Data: display/data/phosphors.txt.
#pragma once

#include <array>
#include <optional>
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

/// One layer of phosphor: a colour and its law. Linear in energy.
struct Phosphor {
  std::string name;  ///< "only"; "flash", "afterglow"; "red", "green", "blue"
  LinearRgb colour;  ///< linear sRGB of its light at luminance 1 (may lie out of gamut)
  double share = 1;  ///< of a dose's luminance, of those layers that one gun excites together
  std::vector<DecayTerm> terms;

  /// Light still to come after t, as a share of a short pulse's whole light.
  double remaining(Seconds t) const;
  /// Brightness at t after *continuous* excitation ended, relative to that during it.
  double decay_after_steady(Seconds t) const { return remaining(t); }
  /// Brightness at t after excitation that was even for `length` and then ended, relative to what
  /// continuous excitation of that strength reaches.
  double decay_after_pulse(Seconds length, Seconds t) const;
};

/// What a faceplate is coated with: one layer, or two of different colours that fade at different
/// rates under one gun, or three with a gun each.
struct PhosphorType {
  std::string name;   ///< "P31", "P7-long"
  std::string about;  ///< "blue flash, then yellowish green"
  std::vector<Phosphor> layers;
  bool colour = false;  ///< the layers are red, green and blue, each with its own gun
  /// The source's times from the end of continuous excitation to 10 %, 1 % and 0.1 %.
  std::array<std::optional<Seconds>, 3> times;
  std::string excitation;           ///< that the fit assumes: "continuous", "pulse"
  std::optional<double> fit_error;  ///< worst of the fitted times, a share; none: nothing to meet
  std::optional<double> luminance;  ///< at 10 kV, P31 = 100 (Tektronix, reference table C, 1966)
  std::string source;               ///< where the figures come from, and what was assumed

  /// The luminance of all layers together at t after continuous excitation, as a share of that
  /// during it; of a colour type, of all guns at equal luminance.
  double decay_after_steady(Seconds t) const;
};

/// All types, in the order of the table.
std::span<const PhosphorType> phosphors();
/// Their names, separated by commas, for help.
std::string phosphor_names();
/// @throws Error (usage) naming the known ones
const PhosphorType& find_phosphor(std::string_view name);

}  // namespace kinescope
