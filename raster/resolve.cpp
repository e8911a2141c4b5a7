#include "raster/resolve.h"

#include <algorithm>
#include <variant>

#include "raster/colour/encode.h"
#include "raster/kernels/linear8.h"

namespace kinescope {
namespace {

void write_row(std::span<const LinearRgba> in, std::span<Srgb8> out) { encode_row(in, out); }
void write_row(std::span<const LinearRgba> in, std::span<Linear8> out) { quantize_row(in, out); }
void write_row(std::span<const LinearRgba> in, std::span<LinearRgba> out) {
  std::copy(in.begin(), in.end(), out.begin());
}

void add(const LinearRgba& c, int weight, LinearRgba& sum) {
  const auto w = static_cast<float>(weight);
  sum.r += c.r * w;
  sum.g += c.g * w;
  sum.b += c.b * w;
  sum.a += c.a * w;
}

/// The mean of a pixel's samples: fragments from `i` on, and the clear colour where none is.
/// Leaves `i` at the next pixel.
LinearRgba mean(const VisibleFragments& fragments, std::span<const LinearRgba> colours, int end,
                int samples, const LinearRgba& clear, int& i) {
  LinearRgba sum{0, 0, 0, 0};
  int covered = 0;
  const std::uint32_t xy = fragments.xy[static_cast<std::size_t>(i)];
  for (; i < end && fragments.xy[static_cast<std::size_t>(i)] == xy; ++i) {
    const auto at = static_cast<std::size_t>(i);
    add(colours[at], fragments.weight[at], sum);
    covered += fragments.weight[at];
  }
  if (covered < samples) add(clear, samples - covered, sum);
  const float share = 1.0f / static_cast<float>(samples);
  return {sum.r * share, sum.g * share, sum.b * share, sum.a * share};
}

/// One row of a tile in linear light: of the fragments' own colours if each pixel has one, else
/// put together in `row`.
std::span<const LinearRgba> row_of_pixels(const TileBuffer& tile, const VisibleFragments& fragments,
                                          std::span<const LinearRgba> colours, std::size_t r,
                                          const LinearRgba& clear, AlignedVector<LinearRgba>& row) {
  const int width = tile.rect.x1 - tile.rect.x0;
  const int first = fragments.row_first[r], end = fragments.row_first[r + 1];
  if (fragments.row_is_whole[r]) {
    return colours.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(width));
  }
  row.assign(static_cast<std::size_t>(width), clear);
  for (int i = first; i < end;) {
    const auto at = static_cast<std::size_t>(i);
    const std::uint32_t x = (fragments.xy[at] & 0xffff) - static_cast<std::uint32_t>(tile.rect.x0);
    if (tile.samples == 1 || fragments.weight[at] == tile.samples) {
      row[x] = colours[at];
      ++i;
    } else {
      row[x] = mean(fragments, colours, end, tile.samples, clear, i);
    }
  }
  return row;
}

}  // namespace

void resolve_tile(const TileBuffer& tile, const VisibleFragments& fragments,
                  std::span<const LinearRgba> colours, AlignedVector<LinearRgba>& row,
                  RenderTarget& target) {
  const int width = tile.rect.x1 - tile.rect.x0;
  const auto write_tile = [&](auto& image) {
    for (int y = tile.rect.y0; y < tile.rect.y1; ++y) {
      const auto r = static_cast<std::size_t>(y - tile.rect.y0);
      const std::span out(image.row(y) + tile.rect.x0, static_cast<std::size_t>(width));
      write_row(row_of_pixels(tile, fragments, colours, r, target.clear, row), out);
    }
  };
  std::visit(write_tile, target.colour);
  if (!target.keep_depth) return;
  for (int y = tile.rect.y0; y < tile.rect.y1; ++y) {
    const float* from = tile.depth.data() +
                        static_cast<std::ptrdiff_t>(y - tile.rect.y0) * tile.stride * tile.samples;
    float* const to = target.depth.row(y) + tile.rect.x0;
    for (int x = 0; x < width; ++x, from += tile.samples) to[x] = *from;
  }
}

}  // namespace kinescope
