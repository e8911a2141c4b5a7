#include "demos/picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "raster/colour/encode.h"

namespace kinescope {
namespace {

/// Encodes row by row; `fetch` gives row y as linear light, in `buffer` where it must be made.
template <typename To, typename From, typename Fetch>
Image<To> encode_rows(const Image<From>& light, Workers& workers, const Fetch& fetch) {
  Image<To> out(light.width(), light.height());
  const auto width = static_cast<std::size_t>(light.width());
  std::vector<std::vector<LinearRgb>> buffers(static_cast<std::size_t>(workers.count()));
  workers.run(light.height(), [&](int y, int worker) {
    auto& buffer = buffers[static_cast<std::size_t>(worker)];
    buffer.resize(width);
    const std::span<const From> row(light.row(y), width);
    encode_row(fetch(row, std::span(buffer)), std::span<To>(out.row(y), width));
  });
  return out;
}

template <typename To>
Image<To> encode_with_gain(const Image<LinearRgb>& light, float gain, Workers& workers) {
  using Row = std::span<const LinearRgb>;
  return encode_rows<To>(light, workers, [gain](Row row, std::span<LinearRgb> buffer) -> Row {
    if (gain == 1) return row;
    std::transform(row.begin(), row.end(), buffer.begin(), [gain](LinearRgb c) {
      return LinearRgb{c.r * gain, c.g * gain, c.b * gain};
    });
    return buffer;
  });
}

}  // namespace

Image<Srgb8> encode_picture(const Image<LinearRgb>& light, float gain, Workers& workers) {
  return encode_with_gain<Srgb8>(light, gain, workers);
}

Image<Srgb16> encode_picture16(const Image<LinearRgb>& light, float gain, Workers& workers) {
  return encode_with_gain<Srgb16>(light, gain, workers);
}

Image<Srgb16> encode_picture16(const Image<LinearRgba>& light, Workers& workers) {
  using Row = std::span<const LinearRgba>;
  const auto opaque = [](Row row, std::span<LinearRgb> buffer) -> std::span<const LinearRgb> {
    std::transform(row.begin(), row.end(), buffer.begin(), [](LinearRgba c) {
      return LinearRgb{c.r, c.g, c.b};
    });
    return buffer;
  };
  Image<Srgb16> out = encode_rows<Srgb16>(light, workers, opaque);
  std::transform(
      light.pixels().begin(), light.pixels().end(), out.pixels().begin(), out.pixels().begin(),
      [](LinearRgba from, Srgb16 to) {
        to.a = static_cast<std::uint16_t>(std::lround(std::clamp(from.a, 0.0f, 1.0f) * 65535.0f));
        return to;
      });
  return out;
}

Size fit_within(Size room, double aspect) {
  const Size by_width{room.width, static_cast<int>(std::lround(room.width / aspect))};
  const Size by_height{static_cast<int>(std::lround(room.height * aspect)), room.height};
  const Size best = by_width.height <= room.height ? by_width : by_height;
  return {std::clamp(best.width, 1, room.width), std::clamp(best.height, 1, room.height)};
}

template <typename Pixel>
Image<Pixel> centre_on_black(Image<Pixel> picture, Size size) {
  if (picture.width() == size.width && picture.height() == size.height) return picture;
  Image<Pixel> out(size.width, size.height);
  const int left = (size.width - picture.width()) / 2, top = (size.height - picture.height()) / 2;
  for (int y = 0; y < picture.height(); ++y) {
    std::copy_n(picture.row(y), picture.width(), out.row(top + y) + left);
  }
  return out;
}
template Image<Srgb8> centre_on_black(Image<Srgb8>, Size);
template Image<Srgb16> centre_on_black(Image<Srgb16>, Size);

std::uint64_t hash_bytes(std::span<const std::uint8_t> bytes, std::uint64_t seed) {
  constexpr std::uint64_t kOffset = 0xcbf29ce484222325, kPrime = 0x100000001b3;
  std::uint64_t hash = (kOffset ^ seed) * kPrime ^ bytes.size();
  while (!bytes.empty()) {
    const std::size_t count = std::min<std::size_t>(8, bytes.size());
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), count);
    hash = (hash ^ word) * kPrime;
    hash ^= hash >> 32;  // a plain multiply never carries high bits down
    bytes = bytes.subspan(count);
  }
  return hash;
}

std::uint64_t hash_picture(const Image<Srgb8>& picture) {
  static_assert(sizeof(Srgb8) == 4);
  const auto pixels = picture.pixels();
  const auto seed = static_cast<std::uint64_t>(picture.width()) << 32 |
                    static_cast<std::uint64_t>(picture.height());
  return hash_bytes({reinterpret_cast<const std::uint8_t*>(pixels.data()), pixels.size_bytes()},
                    seed);
}

}  // namespace kinescope
