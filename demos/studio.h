// What all demos of a program share: threads and typefaces. It holds no demo's state.
#pragma once

#include "raster/base/workers.h"
#include "raster/path/font.h"

namespace kinescope {

struct Studio {
  /// @param threads 0: one a core
  explicit Studio(int threads = 0) : workers(threads) {}

  Workers workers;
  Font sans = Font::sans();
  Font mono = Font::mono();
};

}  // namespace kinescope
