#include "raster/visible_fragments.h"

namespace kinescope {
namespace {

void gather_pixel(const TileBuffer& tile, std::size_t at, int x, int y, VisibleFragments& out) {
  const auto plane = static_cast<std::size_t>(tile.plane);
  const int first = out.size;
  for (int s = 0; s < tile.samples; ++s) {
    const std::uint32_t id = tile.id[at + static_cast<std::size_t>(s) * plane];
    if (id == TileBuffer::kNothing) continue;
    int i = first;
    while (i < out.size && out.id[static_cast<std::size_t>(i)] != id) ++i;
    const auto slot = static_cast<std::size_t>(i);
    if (i < out.size) {
      ++out.weight[slot];
      continue;
    }
    out.id[slot] = id;
    out.x[slot] = static_cast<std::uint16_t>(x);
    out.y[slot] = static_cast<std::uint16_t>(y);
    out.weight[slot] = 1;
    ++out.size;
  }
}

}  // namespace

void VisibleFragments::reserve(int count) {
  const auto n = static_cast<std::size_t>(count);
  if (id.size() >= n) return;
  id.resize(n);
  x.resize(n);
  y.resize(n);
  weight.resize(n);
}

void gather_visible(const TileBuffer& tile, VisibleFragments& out) {
  out.size = 0;
  out.reserve(tile.plane * tile.samples);
  for (int y = tile.rect.y0; y < tile.rect.y1; ++y) {
    auto at = static_cast<std::size_t>((y - tile.rect.y0) * tile.stride);
    for (int x = tile.rect.x0; x < tile.rect.x1; ++x, ++at) gather_pixel(tile, at, x, y, out);
  }
}

}  // namespace kinescope
