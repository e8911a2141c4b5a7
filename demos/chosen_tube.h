// The tube that a user's options name.
#pragma once

#include "demos/options.h"
#include "display/tube/preset.h"

namespace kinescope {

/// The preset of --display, or the first one, with what --set changes.
/// @throws Error
TubePreset chosen_tube(const PictureOptions& picture);

}  // namespace kinescope
