// What the demos of tubes show: the test card, or a test pattern.
#pragma once

#include <string>
#include <vector>

#include "demos/studio.h"
#include "display/tube/settings.h"
#include "raster/image/image.h"

namespace kinescope {

/// "test card", then the patterns' names.
std::vector<std::string> tube_picture_names();
/// Gun drive of the mode's size. A pattern is drive as it is; the card is corrected for the gun.
/// @param which of the names
Image<Srgb8> tube_picture(int which, const TubeSettings& tube, Studio& studio);

}  // namespace kinescope
