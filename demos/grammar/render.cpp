#include <array>
#include <cmath>
#include <optional>

#include "demos/grammar/commands.h"
#include "demos/grammar/options.h"
#include "raster/base/error.h"

namespace kinescope::grammar {

void add_camera(CLI::App& app, RenderOptions& render) {
  const auto angle = [&app](const std::string& name, const std::string& help,
                            std::optional<double>& to, double least, double most) {
    add(app, name, "DEGREES", help,
        [&to, least, most](const std::string& text, const std::string& option) {
          to = parse_number(text, option);
          if (*to >= least && *to <= most) return;
          throw Error(ErrorKind::kUsage,
                      text + " is not between " + std::to_string(std::lround(least)) + " and " +
                          std::to_string(std::lround(most)),
                      option);
        });
  };
  angle("--azimuth", "camera's angle about the vertical, from +z (default: 34)", render.azimuth_deg,
        -3600, 3600);
  angle("--elevation", "camera's angle above the horizon (default: 20)", render.elevation_deg, -90,
        90);
  angle("--fov", "vertical field of view (default: 40)", render.fov_deg, 1, 170);
  const auto vector = [&app](const std::string& name, const std::string& help,
                             std::optional<glm::vec3>& to) {
    add(app, name, "X,Y,Z", help, [&to](const std::string& text, const std::string& option) {
      to = parse_vector(text, option);
    });
  };
  vector("--eye", "where the camera stands (default: where all is seen)", render.eye);
  vector("--look", "the point it looks at (default: the middle)", render.look);
  vector("--up", "which way is up in the model (default: 0,0,1 for STL, else 0,1,0)", render.up);
}

void add_render(CLI::App& app, Options& options) {
  RenderOptions& render = options.render;
  app.add_option("MODEL", render.models,
                 "glTF, GLB, OBJ, PLY, STL or OFF; several stand side by side along x, scaled to "
                 "one size")
      ->required()
      ->type_name("");
  add_picture(app, options.picture);
  add_display(app, options.picture, true);
  add_depth(app, options.picture);
  add_choice(app, "--shading", {"flat", "gouraud", "phong", "blinn", "unlit", "wireframe"},
             "how surfaces are lit (default: phong)", [&render](std::size_t i) {
               constexpr std::array kModels{ShadingModel::kFlat, ShadingModel::kGouraud,
                                            ShadingModel::kPhong, ShadingModel::kBlinn,
                                            ShadingModel::kUnlit};
               if (i == kModels.size()) render.wireframe = true;
               if (i < kModels.size()) render.shading = kModels[i];
             });
  app.add_flag("--wireframe", render.wireframe, "edges only");
  add_choice(app, "--samples,--aa", {"1", "4", "8"}, "samples a pixel (default: 4)",
             [&render](std::size_t i) {
               render.samples = std::array{1, 4, 8}[i];
             });
  add_camera(app, render);
  app.add_flag("--turntable", render.turntable,
               "a film of exactly one turn in --frames (default: six seconds)");
  add_common(app, options.common);
}

}  // namespace kinescope::grammar
