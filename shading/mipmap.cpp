// Box filter; where a side is odd, three taps weighted by how much of each source texel lies under
// the result (S. Guthe, P. Heckbert, "Non-power-of-two mipmapping", NVIDIA 2005).
#include "shading/mipmap.h"

#include <array>

namespace kinescope {
namespace {

/// How the texels of one source row or column are weighted for one result.
struct Taps {
  int first = 0;
  int count = 0;
  std::array<std::uint64_t, 3> weight{};
};

/// A side of n = 2m + 1 texels becomes m, each n/m wide: with weights m - i, m and i + 1 over n.
Taps taps(int from, int to, int i) {
  if (from == to) return {i, 1, {1, 0, 0}};
  if (from % 2 == 0) return {2 * i, 2, {1, 1, 0}};
  const auto m = static_cast<std::uint64_t>(to);
  const auto at = static_cast<std::uint64_t>(i);
  return {2 * i, 3, {m - at, m, at + 1}};
}

}  // namespace

void average_row(const Texture::Level& from, const Texture::Level& to, int y, Texel* out) {
  const Taps down = taps(from.height(), to.height(), y);
  for (int x = 0; x < to.width(); ++x) {
    const Taps across = taps(from.width(), to.width(), x);
    std::uint64_t r = 0, g = 0, b = 0, a = 0, total = 0;
    for (int j = 0; j < down.count; ++j) {
      const Texel* row = from.row(down.first + j) + across.first;
      for (int i = 0; i < across.count; ++i) {
        const std::uint64_t weight =
            down.weight[static_cast<std::size_t>(j)] * across.weight[static_cast<std::size_t>(i)];
        r += weight * row[i].r;
        g += weight * row[i].g;
        b += weight * row[i].b;
        a += weight * row[i].a;
        total += weight;
      }
    }
    const auto mean = [total](std::uint64_t sum) {
      return static_cast<std::uint16_t>((sum + total / 2) / total);
    };
    out[x] = {mean(r), mean(g), mean(b), mean(a)};
  }
}

}  // namespace kinescope
