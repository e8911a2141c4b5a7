#include "demos/displays.h"

#include <sstream>
#include <vector>

#include "displays_table.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

std::vector<DisplayPreset> read_table() {
  std::vector<DisplayPreset> presets;
  std::istringstream table{std::string(embedded::displays_table())};
  for (std::string line; std::getline(table, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream fields(line);
    DisplayPreset preset;
    fields >> preset.name >> preset.mode >> preset.phosphor >> std::ws;
    std::getline(fields, preset.note);
    presets.push_back(preset);
  }
  return presets;
}

}  // namespace

TubeSettings DisplayPreset::settings() const {
  TubeSettings settings;
  settings.mode = parse_mode(mode);
  settings.phosphor = phosphor;
  return settings;
}

std::span<const DisplayPreset> display_presets() {
  static const std::vector<DisplayPreset> presets = read_table();
  return presets;
}

const DisplayPreset& find_display(std::string_view name) {
  std::string known = "none";
  for (const DisplayPreset& preset : display_presets()) {
    if (preset.name == name) return preset;
    known += ", " + preset.name;
  }
  throw Error(ErrorKind::kUsage,
              "no display is called \"" + std::string(name) + "\"; there are " + known,
              "--display");
}

}  // namespace kinescope
