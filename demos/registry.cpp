#include "demos/registry.h"

#include <algorithm>
#include <array>
#include <string>

#include "raster/base/error.h"

namespace kinescope {

// One function a demo, each in the demo's own file.
DemoInfo teapot_demo();
DemoInfo retrace_demo();
DemoInfo frame_buffer_demo();
DemoInfo phosphors_demo();
DemoInfo pipeline_demo();
DemoInfo test_patterns_demo();
DemoInfo tube_demo();
DemoInfo sync_demo();
DemoInfo masks_demo();
DemoInfo light_pen_raster_demo();
DemoInfo lines_demo();
DemoInfo circles_demo();
DemoInfo conics_demo();
DemoInfo strokes_demo();
DemoInfo inside_tests_demo();
DemoInfo seed_fill_demo();
DemoInfo scanline_fill_demo();
DemoInfo areas_demo();
DemoInfo characters_demo();
DemoInfo antialiasing_demo();
DemoInfo dithering_demo();
DemoInfo practical_1_demo();
DemoInfo practical_2_demo();
DemoInfo practical_3_demo();
DemoInfo practical_4_demo();
DemoInfo practical_8_demo();
DemoInfo l_systems_demo();
DemoInfo mandelbrot_demo();
DemoInfo bezier_demo();
DemoInfo b_splines_demo();
DemoInfo line_clipping_demo();
DemoInfo projections_demo();
DemoInfo transformations_demo();
DemoInfo practical_7_demo();
DemoInfo practical_9_demo();
DemoInfo practical_10_demo();
DemoInfo wireframe_demo();
DemoInfo display_file_demo();
DemoInfo rubber_band_demo();
DemoInfo light_pen_demo();
DemoInfo spacewar_demo();
DemoInfo oscilloscope_demo();
DemoInfo storage_demo();

std::span<const DemoInfo> all_demos() {
  static const std::array kDemos = {teapot_demo(),       retrace_demo(),
                                    frame_buffer_demo(), phosphors_demo(),
                                    pipeline_demo(),     test_patterns_demo(),
                                    tube_demo(),         masks_demo(),
                                    sync_demo(),         light_pen_raster_demo(),
                                    display_file_demo(), rubber_band_demo(),
                                    light_pen_demo(),    spacewar_demo(),
                                    oscilloscope_demo(), storage_demo(),
                                    wireframe_demo(),    lines_demo(),
                                    circles_demo(),      conics_demo(),
                                    strokes_demo(),      inside_tests_demo(),
                                    seed_fill_demo(),    scanline_fill_demo(),
                                    areas_demo(),        characters_demo(),
                                    antialiasing_demo(), dithering_demo(),
                                    practical_1_demo(),  practical_2_demo(),
                                    practical_3_demo(),  practical_4_demo(),
                                    practical_8_demo(),  l_systems_demo(),
                                    mandelbrot_demo(),   bezier_demo(),
                                    b_splines_demo(),    line_clipping_demo(),
                                    projections_demo(),  transformations_demo(),
                                    practical_7_demo(),  practical_9_demo(),
                                    practical_10_demo()};
  return kDemos;
}

const DemoInfo& find_demo(std::string_view name) {
  const auto demos = all_demos();
  const auto found =
      std::find_if(demos.begin(), demos.end(), [&](const DemoInfo& d) { return d.name == name; });
  if (found != demos.end()) return *found;
  std::string known;
  for (const DemoInfo& demo : demos) known.append(known.empty() ? "" : ", ").append(demo.name);
  throw Error(ErrorKind::kUsage,
              "no demo is called \"" + std::string(name) + "\"; there are " + known);
}

}  // namespace kinescope
