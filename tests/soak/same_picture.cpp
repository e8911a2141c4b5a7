#include "tests/soak/same_picture.h"

#include <algorithm>
#include <cmath>

namespace kinescope::soak {
namespace {

bool same(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }
bool same(const LinearRgba& a, const LinearRgba& b) {
  return same(a.r, b.r) && same(a.g, b.g) && same(a.b, b.b) && same(a.a, b.a);
}
template <typename Pixel>
bool same(const Pixel& a, const Pixel& b) {
  return a == b;
}

}  // namespace

bool same_picture(const RenderTarget& a, const RenderTarget& b) {
  if (a.depth != b.depth) return false;
  return std::visit(
      [&](const auto& picture) {
        const auto& other = std::get<std::decay_t<decltype(picture)>>(b.colour);
        return std::equal(picture.pixels().begin(), picture.pixels().end(), other.pixels().begin(),
                          other.pixels().end(),
                          [](const auto& p, const auto& q) { return same(p, q); });
      },
      a.colour);
}

}  // namespace kinescope::soak
