#include "display/patterns/patterns.h"

#include <array>
#include <string>

#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr std::array kPatterns{
    TestPattern{"smpte-bars", "75% bars, castellations, -I, white, +Q and PLUGE (EG 1-1990)",
                smpte_bars},
    TestPattern{"ebu-bars", "100/0/75/0 bars (BT.471)", ebu_bars},
    TestPattern{"pluge", "stripes about black, steps to white: brightness and contrast", pluge},
    TestPattern{"crosshatch", "16 by 12 squares: geometry and convergence", crosshatch},
    TestPattern{"zone-plate", "rings ever finer to the sides: resolution and aliases", zone_plate},
    TestPattern{"grey-steps", "eleven steps of drive, up and down: tracking of the guns",
                grey_steps},
    TestPattern{"dots", "dots on a grid: convergence and focus", convergence_dots},
};

}  // namespace

std::span<const TestPattern> test_patterns() { return kPatterns; }

const TestPattern& find_test_pattern(std::string_view name) {
  std::string known;
  for (const TestPattern& pattern : kPatterns) {
    if (pattern.name == name) return pattern;
    known += (known.empty() ? "" : ", ") + std::string(pattern.name);
  }
  throw Error(ErrorKind::kUsage,
              "no test pattern is called \"" + std::string(name) + "\"; there are " + known);
}

}  // namespace kinescope
