// Box filter; where a side is odd, three taps weighted by how much of each source texel lies under
// the result (S. Guthe, P. Heckbert, "Non-power-of-two mipmapping", NVIDIA 2005).
#include "shading/mipmap.h"

#include <array>
#include <cstdint>

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

/// Two by two texels of equal weight.
void average_even_row(const Texture::Level& from, const Texture::Level& to, int y, Texel* out) {
  const Texel* top = from.row(2 * y);
  const Texel* bottom = from.row(2 * y + 1);
  const auto mean = [](int a, int b, int c, int d) {
    return static_cast<std::uint16_t>((a + b + c + d + 2) / 4);
  };
  for (int x = 0; x < to.width(); ++x, top += 2, bottom += 2) {
    out[x] = {mean(top[0].r, top[1].r, bottom[0].r, bottom[1].r),
              mean(top[0].g, top[1].g, bottom[0].g, bottom[1].g),
              mean(top[0].b, top[1].b, bottom[0].b, bottom[1].b),
              mean(top[0].a, top[1].a, bottom[0].a, bottom[1].a)};
  }
}

}  // namespace

void average_row(const Texture::Level& from, const Texture::Level& to, int y, Texel* out) {
  if (from.width() % 2 == 0 && from.height() % 2 == 0) return average_even_row(from, to, y, out);
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
