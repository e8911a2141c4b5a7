#include "raster/resolve.h"

#include <algorithm>
#include <array>
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

LinearRgba sum(const LinearRgba& a, const LinearRgba& b, float weight) {
  return {a.r + b.r * weight, a.g + b.g * weight, a.b + b.b * weight, a.a + b.a * weight};
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
  const auto x0 = static_cast<std::uint32_t>(tile.rect.x0);
  if (tile.samples == 1) {
    row.assign(static_cast<std::size_t>(width), clear);
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) {
      row[(fragments.xy[i] & 0xffff) - x0] = colours[i];
    }
    return row;
  }
  // The mean of each pixel's samples: its fragments in their order, then the clear colour where
  // none is. No branch asks how many a pixel has, since nobody can predict it.
  row.assign(static_cast<std::size_t>(width), {0, 0, 0, 0});
  std::array<int, TileGrid::kMaxTile> empty;
  empty.fill(tile.samples);
  for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) {
    const std::size_t x = (fragments.xy[i] & 0xffff) - x0;
    empty[x] -= fragments.weight[i];
    row[x] = sum(row[x], colours[i], static_cast<float>(fragments.weight[i]));
  }
  const float share = 1.0f / static_cast<float>(tile.samples);
  for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
    const LinearRgba all = sum(row[x], clear, static_cast<float>(empty[x]));
    row[x] = {all.r * share, all.g * share, all.b * share, all.a * share};
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
