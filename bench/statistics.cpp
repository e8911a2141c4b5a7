#include "bench/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace kinescope::bench {

double median(std::vector<double> values) {
  assert(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

PictureDifference compare(const Image<Linear8>& a, const Image<Linear8>& b, int tolerance) {
  assert(a.width() == b.width() && a.height() == b.height());
  PictureDifference result;
  double squares = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Linear8 p = a.pixels()[i], q = b.pixels()[i];
    const int apart[] = {p.r - q.r, p.g - q.g, p.b - q.b};
    bool differs = false;
    for (const int d : apart) {
      squares += d * d;
      differs |= std::abs(d) > tolerance;
    }
    result.pixels_differing += differs;
  }
  const double mean = squares / (3.0 * static_cast<double>(a.pixels().size()));
  result.psnr_db =
      mean > 0 ? 10 * std::log10(255.0 * 255.0 / mean) : std::numeric_limits<double>::infinity();
  return result;
}

}  // namespace kinescope::bench
