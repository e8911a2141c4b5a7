// Presets of tubes: text files of "key value unit" lines. Built in ones: display/data/presets/.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "display/tube/settings.h"

namespace kinescope {

struct TubePreset {
  std::string name;
  std::string note;       ///< one line: what it stands for
  std::string mode_name;  ///< as the file has it
  TubeSettings settings;
};

/// The built-in presets; the first is the default.
std::span<const TubePreset> tube_presets();
/// Whether a name is a preset file's: its path holds a '/' or ends in ".txt".
bool names_preset_file(std::string_view name);
/// A built-in preset by name, or one read from a file.
/// @throws Error (usage) naming the presets there are, or (bad input) naming the file and line
TubePreset find_tube_preset(const std::string& name);

/// @param file for messages @throws Error (bad input) naming the line and what it should hold
TubePreset parse_tube_preset(std::string_view text, const std::string& name,
                             const std::string& file);

/// Changes one key: "spot.sigma=0.2mm". @throws Error (usage)
void override_tube_setting(TubeSettings& settings, std::string_view assignment);

/// Every key with its unit and meaning, a line each, for help.
std::string tube_setting_help();

/// One of the numbers that a preset may set.
struct TubeNumber {
  std::string_view key, unit;  ///< unit "": a bare number or a percentage
  double least, most;
  double& (*of)(TubeSettings&);
  std::string_view about;
};
std::span<const TubeNumber> tube_numbers();

}  // namespace kinescope
