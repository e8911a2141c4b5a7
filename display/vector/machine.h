// Vector display machines as data: display/data/machines/*.txt.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raster/base/units.h"

namespace kinescope {

/// How long an instruction takes: so much, and so much more for each device unit that the beam
/// travels.
struct InstructionCost {
  std::string name;
  double fixed_us = 0, per_unit_us = 0;
};

/// A display machine. Times are the machine's own; see each file for where they come from.
struct VectorMachine {
  std::string name;                 ///< "generic", "dvg"
  std::string note;                 ///< one line: what it stands for
  std::string source;               ///< of its figures, and what was assumed
  std::string words = "generic";    ///< its instruction set
  int width = 4096, height = 4096;  ///< addressable points; (0, 0) is the lower left one
  double screen_mm = 250;           ///< width of the screen that they span
  int memory_words = 65536;
  int stack = 8;              ///< calls within calls
  double clock_hz = 10e6;     ///< in which its times are counted
  double sync_hz = 60;        ///< of the clock that `sync` waits for; 0: none
  double restart_hz = 0;      ///< a halted list is started anew this often; 0: never
  double blink_hz = 2;        ///< half the time dark
  double watchdog_ms = 100;   ///< so long without a stroke or a wait counts as an endless loop
  double speed_units_us = 1;  ///< at which a full current makes lines as bright as white
  double spot_sigma_mm = 0.2;
  double deflection_khz = 0;  ///< bandwidth of its amplifiers (DeflectionLaw); 0: not limited
  double damping = 0.7;       ///< of them
  double slew_mm_us = 0;      ///< most speed of each axis; 0: not limited
  double intensity_mhz = 0;   ///< bandwidth of the beam's current, first order; 0: not limited
  double spot_growth = 0;     ///< its width is as the current to this power
  double edge_spread = 0;     ///< share by which it is wider half a screen's width off the middle
  std::string phosphor = "P31";
  bool penetration = false;  ///< its voltage picks layers: a move's colour is the share of each
  std::vector<std::string> lacks;  ///< instructions of its words that it does not know
  bool knows(std::string_view instruction) const;
  std::vector<InstructionCost> costs;

  /// In clocks, at least one, for so long a way.
  std::int64_t clocks(std::string_view instruction, double units = 0) const;
};

/// All built-in machines, the generic one first.
std::span<const VectorMachine> vector_machines();
/// @throws Error (usage) naming the known ones
const VectorMachine& find_vector_machine(std::string_view name);
/// @param file for messages @throws Error (bad input) naming file and line
VectorMachine parse_vector_machine(std::string_view text, const std::string& name,
                                   const std::string& file);

}  // namespace kinescope
