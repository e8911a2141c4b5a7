// A texture: a mipmap chain and how it is looked up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "raster/colour/colour.h"
#include "raster/image/image.h"

namespace kinescope {

/// kNearest and kBilinear look at the full-size picture only; kTrilinear mixes the bilinear values
/// of the two nearest levels of the mipmap chain.
enum class Filter { kNearest, kBilinear, kTrilinear };
enum class Wrap { kRepeat, kMirror, kClamp };

/// One texel, linear light in 16-bit unsigned normalized channels: 64 bits, loaded as one.
struct Texel {
  std::uint16_t r = 0, g = 0, b = 0, a = 65535;
  bool operator==(const Texel&) const = default;
};

/// Texels in linear light. u runs right, v down from the top row; (0, 0) is the top left corner.
/// A texture without levels is white. Coordinates that are not finite count as 0.
class Texture {
 public:
  /// One picture of the chain. Its rows are padded by one texel, a copy of the row's first, and one
  /// row, a copy of the top one, follows the last: the right and the lower neighbour of a texel
  /// always lie beside it in memory.
  class Level {
   public:
    Level(const Texel* texels, int width, int height)
        : texels_(texels), width_(width), height_(height) {}
    int width() const { return width_; }
    int height() const { return height_; }
    int stride() const { return width_ + 1; }
    const Texel* row(int y) const {
      return texels_ + static_cast<std::size_t>(y) * static_cast<std::size_t>(stride());
    }
    const Texel& at(int x, int y) const { return row(y)[x]; }

   private:
    const Texel* texels_;
    int width_;
    int height_;
  };

  Texture() = default;
  /// Decodes the picture to linear light and averages it down to one texel; alpha is a channel like
  /// the others.
  /// @throws Error (bad input) if the chain would hold 2^31 texels or does not fit into memory
  explicit Texture(const Image<Srgb8>& picture, Filter filter = Filter::kTrilinear,
                   Wrap wrap_u = Wrap::kRepeat, Wrap wrap_v = Wrap::kRepeat);
  /// The same from values that are linear already.
  explicit Texture(const Image<Linear8>& picture, Filter filter = Filter::kTrilinear,
                   Wrap wrap_u = Wrap::kRepeat, Wrap wrap_v = Wrap::kRepeat);

  std::string name;
  Filter filter = Filter::kTrilinear;
  Wrap wrap_u = Wrap::kRepeat;
  Wrap wrap_v = Wrap::kRepeat;

  int levels() const { return static_cast<int>(places_.size()); }
  /// A copy of level i, without padding.
  Image<Texel> level(int i) const;
  /// Level i in place.
  Level view(int i) const {
    const Place& place = places_[static_cast<std::size_t>(i)];
    return {texels_.data() + place.offset, place.width, place.height};
  }
  bool has_alpha() const { return has_alpha_; }

  /// The scalar reference: looks up (u, v) with the texture's filter at level of detail `lod`
  /// (0: full size, 1: half; clamped to the chain).
  LinearRgba sample(float u, float v, float lod) const;

 private:
  struct Place {
    int width = 0;
    int height = 0;
    std::size_t offset = 0;  ///< of the level's first texel in texels_
  };

  void lay_out(int width, int height);
  Texel* mutable_row(int level, int y);
  void pad(int level);
  void build_chain();

  std::vector<Place> places_;
  std::vector<Texel> texels_;  ///< all levels, the largest first
  bool has_alpha_ = false;
};

/// The level of detail of a footprint: log2 of the longer of its two sides in texels, where a side
/// is the step of (u, v) from one pixel to its right or lower neighbour (OpenGL 4.6, 8.14.1).
float level_of_detail(const Texture& texture, float du_dx, float dv_dx, float du_dy, float dv_dy);

}  // namespace kinescope
