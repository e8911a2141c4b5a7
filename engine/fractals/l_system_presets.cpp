#include "engine/fractals/l_system.h"
#include "raster/base/error.h"

namespace kinescope {

// Source: Prusinkiewicz and Lindenmayer, "The Algorithmic Beauty of Plants", 1990, figs. 1.6-1.24.
const std::vector<LSystem>& l_system_presets() {
  static const std::vector<LSystem> kPresets = {
      {"koch", "F", {{'F', "F+F--F+F"}}, 60, 0, 1.0 / 3},
      {"snowflake", "F--F--F", {{'F', "F+F--F+F"}}, 60, 0, 1.0 / 3},
      {"quadratic-koch", "F", {{'F', "F+F-F-F+F"}}, 90, 0, 1.0 / 3},
      {"koch-island", "F+F+F+F", {{'F', "F+F-F-FF+F+F-F"}}, 90, 0, 0.25},
      {"sierpinski-arrowhead", "F", {{'F', "G-F-G"}, {'G', "F+G+F"}}, 60, 0, 0.5},
      {"sierpinski-triangle", "F-G-G", {{'F', "F-G+F+G-F"}, {'G', "GG"}}, 120, 0, 0.5},
      {"dragon", "FX", {{'X', "X+YF+"}, {'Y', "-FX-Y"}}, 90, 0, 0.70710678118654752},
      {"levy", "F", {{'F', "+F--F+"}}, 45, 0, 0.70710678118654752},
      {"hilbert", "X", {{'X', "+YF-XFX-FY+"}, {'Y', "-XF+YFY+FX-"}}, 90, 0, 0.5},
      {"gosper",
       "F",
       {{'F', "F-G--G+F++FF+G-"}, {'G', "+F-GG--G-F++F+G"}},
       60,
       0,
       0.37796447300922722},
      {"plant", "X", {{'X', "F-[[X]+X]+F[+FX]-X"}, {'F', "FF"}}, 25, 90, 0.5},
      {"bush", "F", {{'F', "FF-[-F+F+F]+[+F-F-F]"}}, 22.5, 90, 0.5},
      {"weed", "F", {{'F', "F[+F]F[-F]F"}}, 25.7, 90, 1.0 / 3},
      {"fern", "X", {{'X', "F[+X][-X]FX"}, {'F', "FF"}}, 25.7, 90, 0.5},
  };
  return kPresets;
}

const LSystem& l_system_preset(std::string_view name) {
  std::string known;
  for (const LSystem& system : l_system_presets()) {
    if (system.name == name) return system;
    known += (known.empty() ? "" : ", ") + system.name;
  }
  throw Error(ErrorKind::kUsage, "no L-system \"" + std::string(name) + "\"; there are " + known);
}

}  // namespace kinescope
