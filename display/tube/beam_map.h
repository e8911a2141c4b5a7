// Which part of the sweep each pixel of a picture shows, for one gun of a tube whose raster is
// curved: at nodes every kGroup columns and rows, between which it is all but straight.
#pragma once

#include <vector>

#include "display/tube/settings.h"

namespace kinescope {

struct BeamMap {
  int columns = 0, rows = 0;  ///< of nodes: node (i, j) is the middle of pixel (8 i, 8 j)
  std::vector<float> cell;    ///< cells from the line's beginning
  std::vector<float> line;    ///< a whole number is the middle of that line
  /// Where each line meets the node columns: cell_on_line[line * columns + i].
  std::vector<float> cell_on_line;
  int ring_lines = 0;  ///< a power of two: lines that a group of rows' columns may need at once

  const float* cells_of(int line_number) const {
    return cell_on_line.data() + static_cast<std::ptrdiff_t>(line_number) * columns;
  }
  /// Lines at the nodes of grid row j, from a node on.
  const float* lines_at(int j, int first_node) const {
    return line.data() + static_cast<std::ptrdiff_t>(j) * columns + first_node;
  }
};

/// @param tile_columns that are drawn together, so that the ring holds all their lines
BeamMap beam_map(const TubeSettings& settings, int gun, int cells, int lines, int width, int height,
                 int tile_columns);
/// Finds how large the ring must be.
void set_ring(BeamMap& map, int tile_columns);

}  // namespace kinescope
