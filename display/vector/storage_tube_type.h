// Storage tubes as data: display/data/storage_tubes.txt, which says what its keys mean.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raster/base/units.h"

namespace kinescope {

struct StorageTubeType {
  std::string name;    ///< "613", "4014"
  std::string note;    ///< one line: what it stands for
  std::string source;  ///< of its figures, and what was assumed
  std::string phosphor = "P1";
  int width = 1024, height = 780;  ///< addressable points
  double screen_mm = 200;          ///< width of the screen that they span
  double sigma_mm = 0.21;          ///< of the writing beam's spot
  double threshold = 0.4;          ///< of a line's dose in its middle: half stored
  double speed_mm_ms = 100;        ///< of the writing beam
  double settle_us = 14, settle_us_mm = 0.6;
  double flash = 1;            ///< light of the passing beam
  double background = 0.04;    ///< where nothing is stored; a stored line in 1/60 s is 1
  double write_through = 0.3;  ///< share of the writing current
  Seconds erase{0.9}, erase_flash{0.2};
  Seconds half_contrast{900};  ///< since the last erasure
};

/// All of them, the 613 first.
std::span<const StorageTubeType> storage_tube_types();
/// @throws Error (usage) naming the known ones
const StorageTubeType& find_storage_tube(std::string_view name);
/// @param file for messages @throws Error (bad input) naming file and line
std::vector<StorageTubeType> parse_storage_tubes(std::string_view text, const std::string& file);

}  // namespace kinescope
