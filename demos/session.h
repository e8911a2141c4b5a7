// Running demos: in a window, or headless from a script.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "demos/demo.h"
#include "demos/input_script.h"
#include "raster/base/units.h"
#include "raster/image/image.h"

namespace kinescope {

struct DemoOptions {
  int width = 1280, height = 960;  ///< of the window or picture, pixels
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: one a core
};

/// Opens a window on one demo and returns when it is closed.
/// @return exit code. @throws Error (usage) if there is no window to be had
int run_demo_window(const DemoInfo& demo, const DemoOptions& options);

/// Opens the gallery, from which demos are started. Returns when it is closed.
int run_gallery_window(const DemoOptions& options);

/// A film of a demo with nobody there.
struct DemoFilm {
  std::int64_t first_frame = 0;
  std::int64_t last_frame = 0;     ///< inclusive; frames before the first run unseen
  std::optional<Rate> fps;         ///< default: the demo's refresh
  std::optional<Seconds> shutter;  ///< light gathered a frame; default: one refresh period
  InputScript script;
};

/// The rate at which a demo's film plays: fps, or else the demo's exact refresh.
Rate film_rate(const DemoInfo& demo, const DemoOptions& options, const DemoFilm& film);

/// Renders the frames in order; `show` gets each and may return false to stop early. Without fps
/// and shutter the script's Space, `.`, `,`, `[` and `]` work as in the window, one frame a tick.
/// @throws Error (usage) if the shutter is longer than a frame lasts or not positive
void render_demo(const DemoInfo& demo, const DemoOptions& options, const DemoFilm& film,
                 const std::function<bool(std::int64_t frame, const Image<Srgb8>& picture)>& show);

}  // namespace kinescope
