#include "demos/displays.h"

#include <gtest/gtest.h>

#include "raster/base/error.h"

namespace kinescope {
namespace {

TEST(Displays, EveryPresetMakesATube) {
  ASSERT_FALSE(display_presets().empty());
  EXPECT_EQ(display_presets().front().name, "vga-colour");
  for (const DisplayPreset& preset : display_presets()) {
    const TubeSettings settings = preset.settings();
    EXPECT_NO_THROW(settings.mode.check()) << preset.name;
    EXPECT_FALSE(preset.note.empty()) << preset.name;
    Workers workers(1);
    RasterTube tube(settings, 8, 6);
    FrameBuffer buffer(settings.mode.horizontal.active, settings.mode.vertical.active,
                       PixelFormat::kXrgb8888);
    EXPECT_NO_THROW(tube.expose(buffer, Seconds(1e-4), workers)) << preset.name;
  }
}

TEST(Displays, UnknownOnesAreToldWhichThereAre) {
  EXPECT_EQ(find_display("svga").mode, "800x600@60");
  try {
    find_display("plasma");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), 2);
    EXPECT_NE(std::string(error.what()).find("vga-green"), std::string::npos);
  }
}

}  // namespace
}  // namespace kinescope
