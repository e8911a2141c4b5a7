#include "shading/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <string>

#include "raster/base/error.h"
#include "shading/mipmap.h"

namespace kinescope {
namespace {

std::uint16_t to_unorm16(float value) {
  return static_cast<std::uint16_t>(std::lround(value * 65535.0f));
}

std::array<std::uint16_t, 256> srgb_table() {
  std::array<std::uint16_t, 256> table;
  for (int i = 0; i < 256; ++i) {
    table[static_cast<std::size_t>(i)] = to_unorm16(srgb_decode(static_cast<float>(i) / 255.0f));
  }
  return table;
}

std::uint16_t widen(std::uint8_t value) { return static_cast<std::uint16_t>(value * 257); }

}  // namespace

Texture::Texture(const Image<Srgb8>& picture, Filter filter_in, Wrap wrap_u_in, Wrap wrap_v_in)
    : filter(filter_in), wrap_u(wrap_u_in), wrap_v(wrap_v_in) {
  if (picture.empty()) return;
  lay_out(picture.width(), picture.height());
  const std::array<std::uint16_t, 256> light = srgb_table();
  for (int y = 0; y < picture.height(); ++y) {
    std::transform(picture.row(y), picture.row(y) + picture.width(), mutable_row(0, y),
                   [&](Srgb8 p) {
                     return Texel{light[p.r], light[p.g], light[p.b], widen(p.a)};
                   });
  }
  build_chain();
}

Texture::Texture(const Image<Linear8>& picture, Filter filter_in, Wrap wrap_u_in, Wrap wrap_v_in)
    : filter(filter_in), wrap_u(wrap_u_in), wrap_v(wrap_v_in) {
  if (picture.empty()) return;
  lay_out(picture.width(), picture.height());
  for (int y = 0; y < picture.height(); ++y) {
    std::transform(picture.row(y), picture.row(y) + picture.width(), mutable_row(0, y),
                   [](Linear8 p) {
                     return Texel{widen(p.r), widen(p.g), widen(p.b), widen(p.a)};
                   });
  }
  build_chain();
}

void Texture::lay_out(int width, int height) {
  std::size_t texels = 0;
  while (true) {
    places_.push_back({width, height, texels});
    texels += (static_cast<std::size_t>(width) + 1) * (static_cast<std::size_t>(height) + 1);
    if (width == 1 && height == 1) break;
    width = std::max(1, width / 2);
    height = std::max(1, height / 2);
  }
  // Lookups address texels by 32-bit numbers.
  if (texels > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw_bad_input("a texture of more than 2^31 texels");
  }
  try {
    texels_.resize(texels);
  } catch (const std::bad_alloc&) {
    throw_bad_input("too little memory for a texture of " + std::to_string(places_[0].width) +
                    " x " + std::to_string(places_[0].height) + " texels");
  }
}

Texel* Texture::mutable_row(int i, int y) {
  return texels_.data() + (view(i).row(y) - texels_.data());
}

Image<Texel> Texture::level(int i) const {
  const Level from = view(i);
  Image<Texel> copy(from.width(), from.height());
  for (int y = 0; y < from.height(); ++y) std::copy_n(from.row(y), from.width(), copy.row(y));
  return copy;
}

void Texture::pad(int i) {
  const Level place = view(i);
  for (int y = 0; y < place.height(); ++y) {
    Texel* row = mutable_row(i, y);
    row[place.width()] = row[0];
  }
  std::copy_n(place.row(0), place.stride(), mutable_row(i, place.height()));
}

void Texture::build_chain() {
  for (int i = 0; i < levels(); ++i) {
    if (i > 0) {
      for (int y = 0; y < view(i).height(); ++y) {
        average_row(view(i - 1), view(i), y, mutable_row(i, y));
      }
    }
    pad(i);
  }
  const Level picture = view(0);
  for (int y = 0; y < picture.height() && !has_alpha_; ++y) {
    has_alpha_ = std::any_of(picture.row(y), picture.row(y) + picture.width(),
                             [](const Texel& t) { return t.a != 65535; });
  }
}

}  // namespace kinescope
