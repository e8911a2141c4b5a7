#include "raster/dither/threshold_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "raster/base/error.h"

namespace kinescope {

ThresholdMatrix bayer_matrix(int side) {
  if (side < 1 || side > 64 || (side & (side - 1)) != 0) {
    throw Error(ErrorKind::kUsage,
                fmt::format("a Bayer matrix has a side of 1, 2, 4 to 64, not {}", side));
  }
  ThresholdMatrix matrix;
  // Four copies of the half as large one, each cell's four places lit in the order 0 2 / 3 1.
  for (matrix.side = 1; matrix.side < side; matrix.side *= 2) {
    const int half = matrix.side;
    std::vector<std::uint16_t> ranks(static_cast<std::size_t>(4 * half * half));
    constexpr int kOrder[2][2] = {{0, 2}, {3, 1}};
    for (int y = 0; y < 2 * half; ++y) {
      for (int x = 0; x < 2 * half; ++x) {
        ranks[static_cast<std::size_t>(y * 2 * half + x)] =
            static_cast<std::uint16_t>(4 * matrix.rank(x, y) + kOrder[y / half][x / half]);
      }
    }
    matrix.ranks = std::move(ranks);
  }
  return matrix;
}

ThresholdMatrix clustered_dot_matrix(int side) {
  if (side < 2 || side > 8) {
    throw Error(ErrorKind::kUsage,
                fmt::format("a clustered-dot matrix has a side of 2 to 8, not {}", side));
  }
  ThresholdMatrix matrix{side, std::vector<std::uint16_t>(static_cast<std::size_t>(side * side))};
  std::vector<int> cells(matrix.ranks.size());
  std::iota(cells.begin(), cells.end(), 0);
  const auto growth = [side](int cell) {
    const int dx = 2 * (cell % side) - (side - 1), dy = 2 * (cell / side) - (side - 1);
    return std::tuple(dx * dx + dy * dy, std::atan2(dy, dx), cell);
  };
  std::sort(cells.begin(), cells.end(), [&](int a, int b) { return growth(a) < growth(b); });
  for (std::size_t i = 0; i < cells.size(); ++i) {
    matrix.ranks[static_cast<std::size_t>(cells[i])] = static_cast<std::uint16_t>(i);
  }
  return matrix;
}

}  // namespace kinescope
