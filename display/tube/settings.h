// What a raster tube is made of. Every field has its unit; presets are text files of these.
#pragma once

#include <array>
#include <string>

#include "display/video_mode.h"

namespace kinescope {

/// The glass. Its picture area fills the output image.
struct GlassSettings {
  double diagonal_mm = 330;  ///< of the visible picture: a 14-inch monitor shows about 13
  double aspect = 4.0 / 3;   ///< width over height
  double curvature_mm = 0;   ///< radius of a spherical faceplate; 0 is flat
  double distance_mm = 700;  ///< from the camera to the middle of the glass
  double halation = 0;       ///< share of the light that spreads within the glass
  double halation_mm = 4;    ///< standard deviation of that spread
  double ambient = 0;        ///< light of the room that the screen gives back, as a share of white
  std::array<double, 3> tint{1, 1, 1};  ///< transmission of red, green, blue
  bool operator==(const GlassSettings&) const = default;
};

/// From the video signal to beam current.
struct GunSettings {
  double gamma = 2.35;      ///< current = drive ^ gamma (EBU Tech 3273: 2.35)
  double contrast = 1;      ///< gain of the video amplifier
  double brightness = 0;    ///< added to the drive, white being 1
  double blanking = 0.15;   ///< how far below black retrace blanking drives the guns
  double sync = 0;          ///< how far below black the signal's sync tips are; 0: not on its wire
  double bandwidth_hz = 0;  ///< of the video amplifier, where it passes 1/sqrt(2); 0: unlimited
  bool operator==(const GunSettings&) const = default;
};

/// The beam's spot: a Gaussian whose deviation grows with the cube root of the current.
struct SpotSettings {
  double sigma_mm = 0.13;  ///< at white
  double least =
      0.6;           ///< share of it that is left at no current; from 0.6 on two Gaussians draw it
  double focus = 1;  ///< multiplies it; 1 is the best focus
  double astigmatism = 1.25;  ///< width over height
  /// The spot grows as the high voltage to the minus this. Current density is at most proportional
  /// to the voltage (Langmuir 1937), so one current's area goes as 1 / U: 0.5.
  double sag_power = 0.5;
  bool operator==(const SpotSettings&) const = default;
};

/// Error of one gun's landing, mm.
struct ConvergenceError {
  double x_mm = 0, y_mm = 0;            ///< everywhere
  double edge_x_mm = 0, edge_y_mm = 0;  ///< at the edges; it grows with the distance squared
  bool operator==(const ConvergenceError&) const = default;
};

/// Where the beam lands. Shares are of half the picture's width or height.
struct DeflectionSettings {
  double width = 1, height = 1;               ///< of the raster, as shares of the glass
  double shift_x = 0, shift_y = 0;            ///< to the right, down
  double pincushion_x = 0, pincushion_y = 0;  ///< how far corners stick out beyond edges' middles
  double keystone = 0;      ///< the bottom is wider by this share, the top narrower
  double rotation_deg = 0;  ///< clockwise
  double s_curve = 0;       ///< the sweep is slower at its ends by this share
  std::array<ConvergenceError, 3> convergence{};  ///< red, green, blue
  bool operator==(const DeflectionSettings&) const = default;
};

/// The oscillators that sweep the beam, and what disturbs them. As it stands they are locked to the
/// picture's sync, and each sweep lands where the last one did.
struct SweepSettings {
  double line_hz = 0;          ///< of a line oscillator that runs by itself; 0: locked
  double field_hz = 0;         ///< of a field oscillator that runs by itself; 0: locked
  double interlace_error = 0;  ///< of half a line: how late second fields start; -1 pairs them
  double hum_x = 0,
         hum_y = 0;           ///< swing of the picture with the mains' ripple, shares of half of it
  double hum_hz = 50;         ///< of that ripple
  double sag = 0;             ///< share of the anode's voltage that steady white takes off
  double sag_time_s = 0.003;  ///< in which the anode's capacitance follows
  bool operator==(const SweepSettings&) const = default;
};

enum class MaskKind { kNone, kDots, kGrille, kSlots };

/// The shadow mask of a colour tube.
struct MaskSettings {
  MaskKind kind = MaskKind::kNone;
  double pitch_mm = 0.28;  ///< across, of one triad (dots: of one colour's rows, diagonal pitch)
  double open = 0.7;       ///< share of each stripe's, dot's or slot's own width that is open
  double slot_mm = 0.6;    ///< slots: distance down from one to the next
  double bridge = 0.2;     ///< slots: share of it that is metal
  double wires = 0;        ///< grille: number of damper wires
  double wire_mm = 0.02;   ///< their thickness
  bool operator==(const MaskSettings&) const = default;
};

struct TubeSettings {
  VideoMode mode;
  std::string phosphor = "P22";  ///< of phosphors(): "P22", "P31", ...
  GlassSettings glass{};
  GunSettings gun{};
  SpotSettings spot{};
  DeflectionSettings deflection{};
  SweepSettings sweep{};
  MaskSettings mask{};
  bool operator==(const TubeSettings&) const = default;
};

}  // namespace kinescope
