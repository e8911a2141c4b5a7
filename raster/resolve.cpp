#include "raster/resolve.h"

#include <algorithm>
#include <variant>

namespace kinescope {
namespace {

std::uint8_t to_byte(float v) {
  return static_cast<std::uint8_t>(std::min(std::max(v, 0.0f), 1.0f) * 255.0f + 0.5f);
}

struct EncodeRow {
  const LinearRgba* row;
  int x, y, width;

  void operator()(Image<Srgb8>& to) const {
    Srgb8* const out = to.row(y) + x;
    for (int i = 0; i < width; ++i) out[i] = encode_srgb8(row[i]);
  }
  void operator()(Image<Linear8>& to) const {
    Linear8* const out = to.row(y) + x;
    for (int i = 0; i < width; ++i) {
      out[i] = {to_byte(row[i].r), to_byte(row[i].g), to_byte(row[i].b), to_byte(row[i].a)};
    }
  }
  void operator()(Image<LinearRgba>& to) const { std::copy_n(row, width, to.row(y) + x); }
};

/// Walks the fragments in screen order.
class FragmentCursor {
 public:
  FragmentCursor(const VisibleFragments& fragments, std::span<const LinearRgba> colours,
                 const LinearRgba& clear, int samples)
      : fragments_(fragments),
        colours_(colours),
        clear_(clear),
        samples_(samples),
        share_(1.0f / static_cast<float>(samples)) {}

  /// The mean over the pixel's samples; those that nothing covers show the clear colour.
  LinearRgba pixel(int x, int y) {
    LinearRgba sum{0, 0, 0, 0};
    int covered = 0;
    for (; at_ < fragments_.size && here(x, y); ++at_) {
      const auto i = static_cast<std::size_t>(at_);
      if (fragments_.weight[i] == samples_) return colours_[static_cast<std::size_t>(at_++)];
      add(colours_[i], fragments_.weight[i], sum);
      covered += fragments_.weight[i];
    }
    if (covered == 0) return clear_;
    add(clear_, samples_ - covered, sum);
    return {sum.r * share_, sum.g * share_, sum.b * share_, sum.a * share_};
  }

 private:
  bool here(int x, int y) const {
    const auto i = static_cast<std::size_t>(at_);
    return fragments_.x[i] == x && fragments_.y[i] == y;
  }
  static void add(const LinearRgba& c, int weight, LinearRgba& sum) {
    const auto w = static_cast<float>(weight);
    sum.r += c.r * w;
    sum.g += c.g * w;
    sum.b += c.b * w;
    sum.a += c.a * w;
  }

  const VisibleFragments& fragments_;
  std::span<const LinearRgba> colours_;
  LinearRgba clear_;
  int samples_;
  float share_;
  int at_ = 0;
};

}  // namespace

void resolve_tile(const TileBuffer& tile, const VisibleFragments& fragments,
                  std::span<const LinearRgba> colours, AlignedVector<LinearRgba>& row,
                  RenderTarget& target) {
  const int width = tile.rect.x1 - tile.rect.x0;
  row.resize(static_cast<std::size_t>(tile.stride));
  FragmentCursor cursor(fragments, colours, target.clear, tile.samples);
  for (int y = tile.rect.y0; y < tile.rect.y1; ++y) {
    for (int i = 0; i < width; ++i) {
      row[static_cast<std::size_t>(i)] = cursor.pixel(tile.rect.x0 + i, y);
    }
    std::visit(
        [&](auto& image) {
          EncodeRow{row.data(), tile.rect.x0, y, width}(image);
        },
        target.colour);
    if (!target.keep_depth) continue;
    const auto at = static_cast<std::ptrdiff_t>(y - tile.rect.y0) * tile.stride;
    std::copy_n(tile.depth.begin() + at, width, target.depth.row(y) + tile.rect.x0);
  }
}

}  // namespace kinescope
