#include "demos/chosen_tube.h"

#include <gtest/gtest.h>

#include "display/raster_tube.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

TEST(ChosenTube, EveryPresetMakesATube) {
  EXPECT_EQ(chosen_tube({}).name, "vga-colour");
  for (const TubePreset& preset : tube_presets()) {
    const TubeSettings& settings = preset.settings;
    EXPECT_NO_THROW(settings.mode.check()) << preset.name;
    Workers workers(1);
    RasterTube tube(settings, 40, 30);
    FrameBuffer buffer(settings.mode.horizontal.active, settings.mode.vertical.active,
                       PixelFormat::kXrgb8888);
    EXPECT_NO_THROW(tube.expose(buffer, Seconds(1e-4), workers)) << preset.name;
  }
}

TEST(ChosenTube, IsTheNamedOneWithItsChanges) {
  PictureOptions picture;
  picture.display = "arcade";
  picture.changes = {"mask.kind=none", "spot.focus=2"};
  const TubePreset preset = chosen_tube(picture);
  EXPECT_EQ(preset.name, "arcade");
  EXPECT_EQ(preset.settings.mode.vertical.active, 240);
  EXPECT_EQ(preset.settings.mask.kind, MaskKind::kNone);
  EXPECT_EQ(preset.settings.spot.focus, 2);
  picture.display = "none";
  EXPECT_EQ(chosen_tube(picture).name, "vga-colour");
  picture.display = "plasma";
  EXPECT_THROW(chosen_tube(picture), Error);
}

}  // namespace
}  // namespace kinescope
