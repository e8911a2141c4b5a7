#include "raster/dither/palette_dither.h"

#include <algorithm>
#include <limits>

#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr std::size_t kRemembered = 1 << 16;

}  // namespace

NearestEntry::NearestEntry(const Palette& palette) : palette_(palette), found_(kRemembered) {
  if (palette.empty() || palette.size() > 256) {
    throw Error(ErrorKind::kUsage, "a palette has 1 to 256 entries");
  }
}

std::uint8_t NearestEntry::operator()(int r, int g, int b) {
  const auto colour = static_cast<std::uint32_t>(r << 16 | g << 8 | b);
  // Multiplied by a constant of the golden ratio, colours spread over the places.
  Found& found = found_[(colour * 0x9e3779b1u) >> 16];
  if (found.colour == colour) return found.entry;
  int best = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < palette_.size(); ++i) {
    const int dr = palette_[i].r - r, dg = palette_[i].g - g, db = palette_[i].b - b;
    const int distance = dr * dr + dg * dg + db * db;
    if (distance >= best) continue;
    best = distance;
    found = {colour, static_cast<std::uint8_t>(i)};
  }
  return found.entry;
}

Image<std::uint8_t> to_palette(const Image<Srgb8>& image, const Palette& palette) {
  NearestEntry nearest(palette);
  Image<std::uint8_t> result(image.width(), image.height());
  for (std::size_t i = 0; i < result.pixels().size(); ++i) {
    const Srgb8 p = image.pixels()[i];
    result.pixels()[i] = nearest(p.r, p.g, p.b);
  }
  return result;
}

Image<std::uint8_t> diffuse_to_palette(const Image<Srgb8>& image, const Palette& palette) {
  constexpr int kOne = 16;
  using Channels = std::array<int, 3>;
  NearestEntry nearest(palette);
  const int width = image.width();
  Image<std::uint8_t> result(width, image.height());
  // A pixel more at each end takes what leaves the picture.
  std::vector<Channels> here(static_cast<std::size_t>(width) + 2), below(here.size());
  for (int y = 0; y < image.height(); ++y) {
    const int direction = y % 2 ? -1 : 1;
    for (int i = 0; i < width; ++i) {
      const int x = direction > 0 ? i : width - 1 - i;
      const Srgb8 p = image.at(x, y);
      const Channels codes{p.r, p.g, p.b};
      Channels value, shown;
      const auto place = static_cast<std::size_t>(x + 1);
      for (std::size_t c = 0; c < 3; ++c) {
        value[c] = codes[c] * kOne + here[place][c];
        shown[c] = std::clamp((value[c] + kOne / 2) >> 4, 0, 255);
      }
      const std::uint8_t entry = nearest(shown[0], shown[1], shown[2]);
      result.at(x, y) = entry;
      const Srgb8 q = palette[entry];
      const Channels taken{q.r, q.g, q.b};
      const std::size_t ahead = place + static_cast<std::size_t>(direction);
      const std::size_t behind = place - static_cast<std::size_t>(direction);
      for (std::size_t c = 0; c < 3; ++c) {
        // Clamped, so that colours no entry can mix do not pile up an error without end.
        const int error = std::clamp(value[c], -128 * kOne, 383 * kOne) - taken[c] * kOne;
        const int right = error * 7 / 16, low_left = error * 3 / 16, low_right = error / 16;
        here[ahead][c] += right;
        below[behind][c] += low_left;
        below[ahead][c] += low_right;
        below[place][c] += error - right - low_left - low_right;
      }
    }
    std::swap(here, below);
    std::fill(below.begin(), below.end(), Channels{});
  }
  return result;
}

}  // namespace kinescope
