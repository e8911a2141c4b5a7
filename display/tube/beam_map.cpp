#include "display/tube/beam_map.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "display/tube/curve_kernels.h"
#include "display/tube/deflection.h"

namespace kinescope {
namespace {

std::size_t node(const BeamMap& map, int i, int j) {
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(map.columns) +
         static_cast<std::size_t>(i);
}

/// Nodes beside a picture of a few pixels lie far outside the glass, where no sweep ends: somewhere
/// in the dark beside the raster will do.
Place near(Place sweep) {
  constexpr double kDark = 2;
  return {std::clamp(sweep.x, -kDark, kDark), std::clamp(sweep.y, -kDark, kDark)};
}

/// Follows the node column i down to where each line crosses it.
void cross_lines(BeamMap& map, int i, int lines) {
  int j = 0;
  for (int line = 0; line < lines; ++line) {
    const float at = static_cast<float>(line);
    while (j + 2 < map.rows && map.line[node(map, i, j + 1)] < at) ++j;
    const float above = map.line[node(map, i, j)], below = map.line[node(map, i, j + 1)];
    const float share = below > above ? (at - above) / (below - above) : 0;
    const float cell = map.cell[node(map, i, j)];
    map.cell_on_line[static_cast<std::size_t>(line) * static_cast<std::size_t>(map.columns) +
                     static_cast<std::size_t>(i)] =
        cell + share * (map.cell[node(map, i, j + 1)] - cell);
  }
}

/// The largest spread of lines within a tile's width and a grid row's height.
float line_span(const BeamMap& map, int tile_nodes) {
  float largest = 0;
  for (int j = 0; j + 1 < map.rows; ++j) {
    for (int i = 0; i < map.columns; i += tile_nodes) {
      const int count = std::min(tile_nodes + 1, map.columns - i);
      const float* above = map.lines_at(j, i);
      const float* below = map.lines_at(j + 1, i);
      largest = std::max(largest, *std::max_element(below, below + count) -
                                      *std::min_element(above, above + count));
    }
  }
  return largest;
}

}  // namespace

BeamMap beam_map(const TubeSettings& settings, int gun, int cells, int lines, int width, int height,
                 int tile_columns) {
  const Deflection deflection(settings.deflection, settings.glass, gun);
  const GlassCamera camera(settings.glass);
  BeamMap map;
  map.columns = (width + kGroup - 1) / kGroup + 1;
  map.rows = (height + kGroup - 1) / kGroup + 1;
  const std::size_t count =
      static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
  map.cell.resize(count);
  map.line.resize(count);
  for (int j = 0; j < map.rows; ++j) {
    for (int i = 0; i < map.columns; ++i) {
      const Place picture{(2.0 * kGroup * i + 1) / width - 1, (2.0 * kGroup * j + 1) / height - 1};
      const Place sweep = near(deflection.sweep_of_glass(camera.glass_of_picture(picture)));
      map.cell[node(map, i, j)] = static_cast<float>(0.5 * (sweep.x + 1) * cells);
      map.line[node(map, i, j)] = static_cast<float>(0.5 * (sweep.y + 1) * lines - 0.5);
    }
  }
  map.cell_on_line.resize(static_cast<std::size_t>(lines) * static_cast<std::size_t>(map.columns));
  for (int i = 0; i < map.columns; ++i) cross_lines(map, i, lines);
  set_ring(map, tile_columns);
  return map;
}

void set_ring(BeamMap& map, int tile_columns) {
  const float span = line_span(map, tile_columns / kGroup) + kLineTaps + 2;
  map.ring_lines = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(span))));
}

}  // namespace kinescope
