// A window on a tube that shows what a user gave it.
#pragma once

#include <memory>

#include "demos/display_film.h"

namespace kinescope {

/// Plays the feed until the window is closed. @param feed whose workers nobody else uses
/// @return exit code. @throws Error if there is no window to be had, or of the feed
int run_film_window(const Options& options, const DisplayPlan& plan,
                    std::unique_ptr<PictureFeed> feed);

}  // namespace kinescope
