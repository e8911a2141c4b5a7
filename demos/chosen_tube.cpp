#include "demos/chosen_tube.h"

namespace kinescope {

TubePreset chosen_tube(const PictureOptions& picture) {
  const bool named = picture.display && *picture.display != "none";
  TubePreset preset = named ? find_tube_preset(*picture.display) : tube_presets().front();
  for (const std::string& change : picture.changes) {
    override_tube_setting(preset.settings, change);
  }
  return preset;
}

}  // namespace kinescope
