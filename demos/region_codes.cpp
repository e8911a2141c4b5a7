#include "demos/region_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace kinescope {

std::string code_bits(Outcode code) { return fmt::format("{:04b}", static_cast<unsigned>(code)); }

Overlay region_codes(const World& world, const ClipWindow& window) {
  Overlay over;
  const glm::dvec2 size(world.columns(), world.rows());
  // Rows from the top, whichever of the window's sides is named first.
  const glm::dvec2 a = world.middle_of(window.min), b = world.middle_of(window.max);
  const std::array<double, 4> x = {0, std::min(a.x, b.x), std::max(a.x, b.x), size.x},
                              y = {0, std::min(a.y, b.y), std::max(a.y, b.y), size.y};
  const glm::dvec2 room = glm::dvec2(48, 24) / double(world.cell), off = 0.5 * room;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const glm::dvec2 low = glm::max(glm::dvec2(x[column], y[row]), glm::dvec2(0)),
                       high = glm::min(glm::dvec2(x[column + 1], y[row + 1]), size);
      if (high.x - low.x < room.x || high.y - low.y < room.y) continue;
      const glm::dvec2 middle = 0.5 * (low + high);
      over.labels.push_back(
          {low + off, code_bits(outcode(window, world.named(middle - 0.5))), theme::kCool, 0});
    }
  }
  return over;
}

}  // namespace kinescope
