// A palette by median cut: the box of colours that is longest is cut where half its pixels lie on
// either side, until there are as many boxes as the palette has entries.
// Source: P. S. Heckbert, "Color image quantization for frame buffer display", 1982.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/image/image.h"

namespace kinescope {

using Palette = std::vector<Srgb8>;

/// Cuts one box a step. Colours are told apart to 5 bits a channel, as in the source; alpha is left
/// out.
class MedianCut {
 public:
  /// Ranges of 5-bit channels, both ends included, and the pixels within.
  struct Box {
    std::array<int, 3> low{0, 0, 0}, high{31, 31, 31};
    std::int64_t pixels = 0;
  };

  /// @param entries 1 to 256. @throws Error (usage) for others
  MedianCut(const Image<Srgb8>& image, int entries);

  /// Cuts a box; false when there are enough, or none that holds two colours.
  bool next();
  std::span<const Box> boxes() const { return boxes_; }
  /// The mean colour of each box; empty for an empty picture.
  Palette palette() const;

 private:
  struct Cell {
    std::int64_t pixels = 0;
    std::array<std::int64_t, 3> sums{};
  };
  template <typename Sink>
  void for_each_cell(const Box& box, Sink&& sink) const;
  void shrink(Box& box) const;

  std::vector<Cell> cells_;
  std::vector<Box> boxes_;
  std::size_t entries_;
};

Palette median_cut(const Image<Srgb8>& image, int entries);

}  // namespace kinescope
