#include "engine/fractals/plasma.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "raster/base/error.h"

namespace kinescope {

DiamondSquare::DiamondSquare(int levels, double hurst, std::uint64_t seed)
    : stride(1), deviation_(1.0), fall_(std::exp2(-0.5 * hurst)), random_(seed) {
  if (levels < 0 || levels > 12) throw_bad_input("a landscape has 0 to 12 levels");
  if (!(hurst >= 0.0 && hurst <= 1.0))
    throw_bad_input("a landscape's exponent lies within 0 and 1");
  stride = 1 << levels;
  field.side = stride + 1;
  field.height.resize(static_cast<std::size_t>(field.side) * static_cast<std::size_t>(field.side));
  for (const int j : {0, stride}) {
    for (const int i : {0, stride}) field.at(i, j) = random_.normal();
  }
}

void DiamondSquare::squares() {
  const int half = stride / 2;
  for (int j = half; j < field.side; j += stride) {
    for (int i = half; i < field.side; i += stride) {
      const double sum = field.at(i - half, j - half) + field.at(i + half, j - half) +
                         field.at(i - half, j + half) + field.at(i + half, j + half);
      field.at(i, j) = 0.25 * sum + deviation_ * random_.normal();
    }
  }
}

void DiamondSquare::diamonds() {
  const int half = stride / 2;
  for (int j = 0; j < field.side; j += half) {
    for (int i = (j / half) % 2 == 0 ? half : 0; i < field.side; i += stride) {
      double sum = 0.0;
      int count = 0;
      const auto add = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= field.side || y >= field.side) return;
        sum += field.at(x, y);
        ++count;
      };
      add(i - half, j);
      add(i + half, j);
      add(i, j - half);
      add(i, j + half);
      field.at(i, j) = sum / count + deviation_ * random_.normal();
    }
  }
}

bool DiamondSquare::next() {
  if (stride == 1) return false;
  // Diamonds lie 1 / sqrt 2 as far apart as the squares before them.
  deviation_ *= fall_;
  if (diamonds_next) {
    diamonds();
    stride /= 2;
  } else {
    squares();
  }
  diamonds_next = !diamonds_next;
  return true;
}

glm::ivec2 DiamondSquare::nearest_made(int column, int row) const {
  const int s = stride, half = s / 2;
  const glm::ivec2 corner((column + half) / s * s, (row + half) / s * s);
  if (!diamonds_next) return corner;
  const int most = field.side - 1 - half;
  const glm::ivec2 centre(std::min(column / s * s + half, most),
                          std::min(row / s * s + half, most));
  const auto away = [&](const glm::ivec2& p) {
    return std::abs(p.x - column) + std::abs(p.y - row);
  };
  return away(centre) < away(corner) ? centre : corner;
}

double DiamondSquare::height_between(double x, double y) const {
  const int s = stride, most = field.side - 1 - s;
  const int i = std::min(static_cast<int>(x) / s * s, most);
  const int j = std::min(static_cast<int>(y) / s * s, most);
  const double u = (x - i) / s, v = (y - j) / s;
  return std::lerp(std::lerp(field.at(i, j), field.at(i + s, j), u),
                   std::lerp(field.at(i, j + s), field.at(i + s, j + s), u), v);
}

HeightField plasma(int levels, double hurst, std::uint64_t seed) {
  DiamondSquare steps(levels, hurst, seed);
  while (steps.next()) {
  }
  return std::move(steps.field);
}

}  // namespace kinescope
