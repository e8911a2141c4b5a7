#include "engine/fractals/escape_time.h"

#include "raster/base/error.h"
#include "raster/base/workers.h"

namespace kinescope {

std::vector<std::int32_t> escape_times(const EscapeView& view, Workers& workers) {
  if (view.width <= 0 || view.height <= 0 || view.width > (1 << 26) / view.height) {
    throw_bad_input("a picture of an escape-time fractal has 1 to 2^26 pixels");
  }
  const auto width = static_cast<std::size_t>(view.width);
  std::vector<std::int32_t> times(width * static_cast<std::size_t>(view.height));
  workers.run(view.height, [&](int j, int) {
    escape_row(view, j, times.data() + width * static_cast<std::size_t>(j));
  });
  return times;
}

}  // namespace kinescope
