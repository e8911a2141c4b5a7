// What commands and demos do with a finished picture: fit it, hash it, encode it deeply.
#pragma once

#include <cstdint>
#include <span>

#include "raster/base/workers.h"
#include "raster/image/image.h"

namespace kinescope {

/// Pixels across and down.
struct Size {
  int width = 0, height = 0;
  bool operator==(const Size&) const = default;
};

/// A bare picture of linear light in 16 bits a channel.
Image<Srgb16> encode_picture16(const Image<LinearRgba>& light, Workers& workers);

/// The largest picture of width over height `aspect` that lies within `room`; at least 1x1.
Size fit_within(Size room, double aspect);

/// The picture centred on black of the given size; a picture of that size already is returned as
/// it is.
template <typename Pixel>
Image<Pixel> centre_on_black(Image<Pixel> picture, Size size);

/// 64 bits that depend on the size and every channel of every pixel (FNV-1a on 64-bit words).
std::uint64_t hash_picture(const Image<Srgb8>& picture);
std::uint64_t hash_bytes(std::span<const std::uint8_t> bytes, std::uint64_t seed = 0);

}  // namespace kinescope
