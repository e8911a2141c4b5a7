// Models that a user names, as one scene.
#pragma once

#include <string>
#include <vector>

#include "demos/options.h"
#include "engine/scene.h"
#include "raster/base/error.h"

namespace kinescope {

/// All models side by side. @throws Error (bad input) naming the file, also if it draws nothing
Scene import_models(const std::vector<std::string>& paths, Warnings& warnings);

/// STL files come from machine drawing, where z is up; the others keep y.
RenderOptions with_up_of_files(RenderOptions options);

}  // namespace kinescope
