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
DemoInfo four_operations_demo();
DemoInfo samples_demo();
DemoInfo coordinates_demo();
DemoInfo charts_demo();
DemoInfo cad_part_demo();
DemoInfo paint_demo();
DemoInfo enhancement_demo();
DemoInfo windows_demo();
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
DemoInfo practical_5_demo();
DemoInfo practical_6_demo();
DemoInfo practical_8_demo();
DemoInfo l_systems_demo();
DemoInfo mandelbrot_demo();
DemoInfo bezier_demo();
DemoInfo b_splines_demo();
DemoInfo splines_demo();
DemoInfo continuity_demo();
DemoInfo nurbs_demo();
DemoInfo curve_properties_demo();
DemoInfo iterated_functions_demo();
DemoInfo gaskets_demo();
DemoInfo plasma_demo();
DemoInfo brownian_demo();
DemoInfo aggregation_demo();
DemoInfo coastline_demo();
DemoInfo fractal_compression_demo();
DemoInfo self_similarity_demo();
DemoInfo generator_curves_demo();
DemoInfo line_clipping_demo();
DemoInfo window_to_viewport_demo();
DemoInfo polygon_clipping_demo();
DemoInfo curve_clipping_demo();
DemoInfo text_clipping_demo();
DemoInfo viewing_steps_demo();
DemoInfo projections_demo();
DemoInfo view_confusion_demo();
DemoInfo transformations_demo();
DemoInfo transformations_3d_demo();
DemoInfo planes_and_normals_demo();
DemoInfo practical_7_demo();
DemoInfo practical_9_demo();
DemoInfo practical_10_demo();
DemoInfo practical_11_demo();
DemoInfo practical_12_demo();
DemoInfo wireframe_demo();
DemoInfo display_file_demo();
DemoInfo rubber_band_demo();
DemoInfo light_pen_demo();
DemoInfo spacewar_demo();
DemoInfo oscilloscope_demo();
DemoInfo storage_demo();

std::span<const DemoInfo> all_demos() {
  static const std::array kDemos = {teapot_demo(),
                                    retrace_demo(),
                                    frame_buffer_demo(),
                                    phosphors_demo(),
                                    pipeline_demo(),
                                    test_patterns_demo(),
                                    tube_demo(),
                                    masks_demo(),
                                    sync_demo(),
                                    light_pen_raster_demo(),
                                    display_file_demo(),
                                    rubber_band_demo(),
                                    light_pen_demo(),
                                    spacewar_demo(),
                                    oscilloscope_demo(),
                                    storage_demo(),
                                    wireframe_demo(),
                                    four_operations_demo(),
                                    samples_demo(),
                                    coordinates_demo(),
                                    cad_part_demo(),
                                    charts_demo(),
                                    paint_demo(),
                                    enhancement_demo(),
                                    windows_demo(),
                                    lines_demo(),
                                    circles_demo(),
                                    conics_demo(),
                                    strokes_demo(),
                                    inside_tests_demo(),
                                    seed_fill_demo(),
                                    scanline_fill_demo(),
                                    areas_demo(),
                                    characters_demo(),
                                    antialiasing_demo(),
                                    dithering_demo(),
                                    practical_1_demo(),
                                    practical_2_demo(),
                                    practical_3_demo(),
                                    practical_4_demo(),
                                    practical_5_demo(),
                                    practical_6_demo(),
                                    practical_8_demo(),
                                    l_systems_demo(),
                                    mandelbrot_demo(),
                                    bezier_demo(),
                                    b_splines_demo(),
                                    splines_demo(),
                                    continuity_demo(),
                                    nurbs_demo(),
                                    curve_properties_demo(),
                                    iterated_functions_demo(),
                                    gaskets_demo(),
                                    plasma_demo(),
                                    brownian_demo(),
                                    aggregation_demo(),
                                    coastline_demo(),
                                    fractal_compression_demo(),
                                    self_similarity_demo(),
                                    generator_curves_demo(),
                                    line_clipping_demo(),
                                    window_to_viewport_demo(),
                                    polygon_clipping_demo(),
                                    curve_clipping_demo(),
                                    text_clipping_demo(),
                                    viewing_steps_demo(),
                                    projections_demo(),
                                    view_confusion_demo(),
                                    transformations_demo(),
                                    transformations_3d_demo(),
                                    planes_and_normals_demo(),
                                    practical_7_demo(),
                                    practical_9_demo(),
                                    practical_10_demo(),
                                    practical_11_demo(),
                                    practical_12_demo()};
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
