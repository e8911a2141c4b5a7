#include "demos/tube_pictures.h"

#include "demos/gamma_correction.h"
#include "demos/test_card.h"
#include "display/patterns/patterns.h"

namespace kinescope {

std::vector<std::string> tube_picture_names() {
  std::vector<std::string> names = {"test card"};
  for (const TestPattern& pattern : test_patterns()) names.emplace_back(pattern.name);
  return names;
}

Image<Srgb8> tube_picture(int which, const TubeSettings& tube, Studio& studio) {
  const int width = tube.mode.horizontal.active, height = tube.mode.vertical.active;
  if (which > 0) return test_patterns()[static_cast<std::size_t>(which - 1)].draw(width, height);
  GammaCorrection correct(tube.gun.gamma);
  return correct(test_card(studio, width, height), studio.workers);
}

}  // namespace kinescope
