#include "demos/picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace kinescope {

Image<Srgb16> encode_picture16(const Image<LinearRgba>& light, Workers& workers) {
  Image<Srgb16> out(light.width(), light.height());
  workers.run(light.height(), [&](int y, int) {
    std::transform(light.row(y), light.row(y) + light.width(), out.row(y), [](LinearRgba c) {
      Srgb16 code = encode_srgb16(LinearRgb{c.r, c.g, c.b});
      code.a = static_cast<std::uint16_t>(std::lround(std::clamp(c.a, 0.0f, 1.0f) * 65535.0f));
      return code;
    });
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
