// Many anti-aliased lines onto a picture, on all workers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/base/workers.h"
#include "raster/image/image.h"
#include "raster/path/line_kernel.h"

namespace kinescope {

/// Draws lines in the order given, each pixel's share exact: the picture is the same for any
/// number of workers and any instruction set. Keeps its memory from call to call.
class LinePainter {
 public:
  explicit LinePainter(Workers& workers) : workers_(workers) {}

  /// Lines that are not finite are left out; what lies outside the picture is clipped. Where ends
  /// of lines overlap, both are laid.
  void draw(std::span<const InkedLine> lines, const Stroke& stroke, Mixing mixing,
            Image<Linear8>& picture);
  void draw(std::span<const InkedLine> lines, const Stroke& stroke, Mixing mixing,
            Image<LinearRgba>& picture);

 private:
  template <typename Pixel>
  void draw_any(std::span<const InkedLine> lines, const Stroke& stroke, Mixing mixing,
                Image<Pixel>& picture);
  void sort_into_bands(std::span<const InkedLine> lines, const Stroke& stroke, int height);

  /// The bands that a line touches, [first, last).
  struct Bands {
    std::uint16_t first, last;
  };

  Workers& workers_;
  std::vector<Bands> bands_;           // of each line
  std::vector<std::uint32_t> starts_;  // of each band, and of each chunk of lines in it
  std::vector<std::uint32_t> order_;   // lines' numbers, band by band
};

}  // namespace kinescope
