// From the video signal to the doses that the beam lays down: amplifier, gun and spot.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "display/frame_buffer.h"
#include "display/tube/settings.h"
#include "display/tube/spot.h"
#include "display/tube_kernels.h"

namespace kinescope {

/// Which drive a gun follows.
enum class Signal { kRed, kGreen, kBlue, kGrey };

/// Cells [begin, end) of a line.
struct CellSpan {
  int begin = 0, end = 0;
};

class Gun {
 public:
  Gun(const GunSettings& settings, const SpotModel& spot, double pixel_clock_hz);

  /// A line's doses, 1 being white's, as the narrow and as the wide Gaussian draw them. The
  /// amplifier's memory reaches across pixels, so a whole line is asked for.
  /// @param voltage work space, of drives.size() + 2 * reach() floats
  /// @param tips where the signal is at its sync tips instead
  void doses(std::span<const GunDrive> drives, Signal signal, std::span<float> voltage,
             float* narrow, float* wide, std::span<const CellSpan> tips = {}) const;
  int reach() const { return static_cast<int>(response_.size()) / 2; }

  /// Beam current of a drive, white's being 1.
  double current(double drive) const;
  /// That of the blanked beam, while the signal is black, and at its sync tips.
  double blanked_current(bool sync_tip) const;

 private:
  struct Dose {
    float narrow = 0, wide = 0;
  };
  Dose dose(double drive) const;

  GunSettings settings_;
  SpotModel spot_;
  std::vector<float> response_;  // of the amplifier, a pixel clock each, around its middle
  std::vector<Dose> of_code_;    // of the 256 drives
  GunLaw law_{};                 // the same for drives between them
};

}  // namespace kinescope
