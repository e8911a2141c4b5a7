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

using BlockColours = std::span<const LinearRgba, kPixels>;

/// Encodes a block's pixels to rows that lie `stride` pixels apart.
void encode_block(BlockColours in, Linear8* out, std::size_t stride) {
  quantize_block(in, out, stride);
}
void encode_block(BlockColours in, Srgb8* out, std::size_t stride) {
  std::array<Srgb8, kPixels> codes;
  encode_row(in, codes);
  for (std::size_t k = 0; k < kPixels; k += kSide, out += stride) {
    std::copy_n(codes.data() + k, kSide, out);
  }
}
void encode_block(BlockColours in, LinearRgba* out, std::size_t stride) {
  for (std::size_t k = 0; k < kPixels; k += kSide, out += stride) {
    std::copy_n(in.data() + k, kSide, out);
  }
}

void encode_pixel(const LinearRgba& in, Linear8& out) { quantize_row({&in, 1}, {&out, 1}); }
void encode_pixel(const LinearRgba& in, Srgb8& out) { out = encode_srgb8(in); }
void encode_pixel(const LinearRgba& in, LinearRgba& out) { out = in; }

/// Copies rows of kSide pixels to those of a rectangle, which may be narrower.
template <class Pixel>
void copy_rows(const Pixel* from, const PixelRect& rect, Image<Pixel>& image) {
  const int columns = rect.x1 - rect.x0;
  for (int y = rect.y0; y < rect.y1; ++y, from += kSide) {
    Pixel* const to = image.row(y) + rect.x0;
    if (columns == kSide) {
      std::memcpy(to, from, kSide * sizeof(Pixel));  // of a length that the compiler knows
    } else {
      std::copy_n(from, columns, to);
    }
  }
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

/// Writes those of a block's pixels that lie within the target.
template <class Pixel>
void write_block(BlockColours colours, const PixelRect& rect, Image<Pixel>& image) {
  if (rect.x1 - rect.x0 == kSide && rect.y1 - rect.y0 == kSide) {
    const auto stride = static_cast<std::size_t>(image.width());
    encode_block(colours, image.row(rect.y0) + rect.x0, stride);
    return;
  }
  std::array<Pixel, kPixels> codes;
  encode_block(colours, codes.data(), kSide);
  copy_rows(codes.data(), rect, image);
}

template <class Pixel>
void write_blocks(const TileBuffer& tile, const VisibleFragments& fragments,
                  std::span<const LinearRgba> colours, const LinearRgba& clear,
                  Image<Pixel>& image) {
  alignas(64) std::array<LinearRgba, kPixels> linear;
  std::array<Pixel, kPixels> nothing;
  encode_pixel(clear, nothing[0]);
  nothing.fill(nothing[0]);
  for (std::size_t at = 0; at < static_cast<std::size_t>(fragments.blocks); ++at) {
    const PixelRect rect = tile.block_rect(fragments.block[at]);
    if (rect.empty()) continue;
    const auto first = static_cast<std::size_t>(fragments.block_first[at]);
    const auto end = static_cast<std::size_t>(fragments.block_first[at + 1]);
    if (first == end) {
      copy_rows(nothing.data(), rect, image);
    } else if (fragments.block_is_whole[at]) {
      write_block(BlockColours(colours.data() + first, kPixels), rect, image);
    } else {
      put_together(fragments, colours, first, end, tile.samples, clear, linear);
      write_block(BlockColours(linear), rect, image);
    }
  }
}

}  // namespace

void resolve_blocks(const TileBuffer& tile, const VisibleFragments& fragments,
                    std::span<const LinearRgba> colours, RenderTarget& target) {
  std::visit([&](auto& image) { write_blocks(tile, fragments, colours, target.clear, image); },
             target.colour);
}

void write_whole_block(BlockColours colours, int x0, int y0, RenderTarget& target) {
  const PixelRect rect = {x0, y0, x0 + kSide, y0 + kSide};
  std::visit([&](auto& image) { write_block(colours, rect, image); }, target.colour);
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
