#include "raster/resolve.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <variant>

#include "raster/colour/encode.h"
#include "raster/kernels/average_samples.h"
#include "raster/kernels/linear8.h"

namespace kinescope {
namespace {

constexpr int kSide = TileBuffer::kBlock;
constexpr std::size_t kPixels = TileBuffer::kBlockPixels;

void encode(std::span<const LinearRgba> in, std::span<Srgb8> out) { encode_row(in, out); }
void encode(std::span<const LinearRgba> in, std::span<Linear8> out) { quantize_row(in, out); }
void encode(std::span<const LinearRgba> in, std::span<LinearRgba> out) {
  std::copy(in.begin(), in.end(), out.begin());
}

/// The fragments of a block, put together to its 64 pixels.
void put_together(const VisibleFragments& fragments, std::span<const LinearRgba> colours,
                  std::size_t first, std::size_t end, int samples, const LinearRgba& clear,
                  std::array<LinearRgba, kPixels>& out) {
  if (samples > 1) {
    average_samples(fragments, colours, first, end, samples, clear, out);
    return;
  }
  out.fill(clear);
  for (std::size_t i = first; i < end; ++i) out[pixel_in_block(fragments.xy[i])] = colours[i];
}

template <class Pixel>
void write_block(const std::array<Pixel, kPixels>& codes, const PixelRect& rect,
                 Image<Pixel>& image) {
  const Pixel* from = codes.data();
  const bool whole = rect.x1 - rect.x0 == kSide;
  for (int y = rect.y0; y < rect.y1; ++y, from += kSide) {
    Pixel* const to = image.row(y) + rect.x0;
    if (whole) {
      std::memcpy(to, from, kSide * sizeof(Pixel));  // of a length that the compiler knows
    } else {
      std::copy_n(from, rect.x1 - rect.x0, to);
    }
  }
}

template <class Pixel>
void write_blocks(const TileBuffer& tile, const VisibleFragments& fragments,
                  std::span<const LinearRgba> colours, const LinearRgba& clear,
                  Image<Pixel>& image) {
  Pixel clear_code{};
  encode({&clear, 1}, {&clear_code, 1});
  alignas(64) std::array<LinearRgba, kPixels> linear;
  alignas(64) std::array<Pixel, kPixels> codes;
  for (int block = fragments.first_block; block < fragments.end_block; ++block) {
    const PixelRect rect = tile.block_rect(block);
    if (rect.empty()) continue;
    const auto at = static_cast<std::size_t>(block - fragments.first_block);
    const int first = fragments.block_first[at], end = fragments.block_first[at + 1];
    if (first == end) {
      codes.fill(clear_code);
    } else if (fragments.block_is_whole[at]) {
      encode(colours.subspan(static_cast<std::size_t>(first), kPixels), codes);
    } else {
      put_together(fragments, colours, static_cast<std::size_t>(first),
                   static_cast<std::size_t>(end), tile.samples, clear, linear);
      encode(linear, codes);
    }
    write_block(codes, rect, image);
  }
}

}  // namespace

void resolve_blocks(const TileBuffer& tile, const VisibleFragments& fragments,
                    std::span<const LinearRgba> colours, RenderTarget& target) {
  std::visit([&](auto& image) { write_blocks(tile, fragments, colours, target.clear, image); },
             target.colour);
}

void keep_depth(const TileBuffer& tile, Image<float>& depth) {
  const int width = tile.rect.x1 - tile.rect.x0;
  for (int y = tile.rect.y0; y < tile.rect.y1; ++y) {
    const float* from = tile.depth.data() +
                        static_cast<std::ptrdiff_t>(y - tile.rect.y0) * tile.stride * tile.samples;
    float* const to = depth.row(y) + tile.rect.x0;
    for (int x = 0; x < width; ++x, from += tile.samples) to[x] = *from;
  }
}

}  // namespace kinescope
