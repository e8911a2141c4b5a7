// The pixels that were blended: the mean of their samples in linear light, encoded.
#include <algorithm>
#include <array>
#include <variant>

#include "raster/colour/encode.h"
#include "raster/kernels/linear8.h"
#include "raster/ordered/ordered_tile.h"

namespace kinescope {
namespace {

void write_row(std::span<const LinearRgba> in, std::span<Srgb8> out) { encode_row(in, out); }
void write_row(std::span<const LinearRgba> in, std::span<Linear8> out) { quantize_row(in, out); }
void write_row(std::span<const LinearRgba> in, std::span<LinearRgba> out) {
  std::copy(in.begin(), in.end(), out.begin());
}

/// In the order of the samples, so that no tile's place changes the sum.
LinearRgba mean(const LinearRgba* samples, std::size_t count) {
  LinearRgba sum = samples[0];
  for (std::size_t s = 1; s < count; ++s) {
    sum = {sum.r + samples[s].r, sum.g + samples[s].g, sum.b + samples[s].b, sum.a + samples[s].a};
  }
  const float share = 1.0f / static_cast<float>(count);
  return {sum.r * share, sum.g * share, sum.b * share, sum.a * share};
}

}  // namespace

void OrderedTile::resolve(const TileBuffer& tile, RenderTarget& target) {
  const auto width = static_cast<std::size_t>(tile.rect.x1 - tile.rect.x0);
  const auto samples = static_cast<std::size_t>(tile.samples);
  row_.resize(TileGrid::kMaxTile);
  const auto write_tile = [&]<typename Pixel>(Image<Pixel>& image) {
    std::array<Pixel, TileGrid::kMaxTile> encoded;
    for (int y = tile.rect.y0; y < tile.rect.y1; ++y) {
      const std::size_t row =
          static_cast<std::size_t>(y - tile.rect.y0) * static_cast<std::size_t>(tile.stride);
      const std::uint8_t* const touched = &colours_.touched[row];
      if (std::find(touched, touched + width, 1) == touched + width) continue;
      const LinearRgba* from = &colours_.samples[row * samples];
      for (std::size_t x = 0; x < width; ++x) row_[x] = mean(from + x * samples, samples);
      write_row(std::span(row_).first(width), std::span(encoded).first(width));
      Pixel* const out = image.row(y) + tile.rect.x0;
      for (std::size_t x = 0; x < width; ++x) {
        if (touched[x] != 0) out[x] = encoded[x];
      }
    }
  };
  std::visit(write_tile, target.colour);
}

}  // namespace kinescope
