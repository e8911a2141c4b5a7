// A texture: a mipmap chain and how it is looked up.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raster/colour/colour.h"
#include "raster/image/image.h"

namespace kinescope {

enum class Filter { kNearest, kBilinear, kTrilinear };
enum class Wrap { kRepeat, kMirror, kClamp };

/// One texel, linear light in 16-bit unsigned normalized channels: 64 bits, loaded as one.
struct Texel {
  std::uint16_t r = 0, g = 0, b = 0, a = 65535;
  bool operator==(const Texel&) const = default;
};

/// Texels in linear light. u runs right, v down from the top row; (0, 0) is the top left corner.
class Texture {
 public:
  Texture() = default;
  /// Decodes the picture to linear light and averages it down to one texel.
  explicit Texture(const Image<Srgb8>& picture, Filter filter = Filter::kTrilinear,
                   Wrap wrap_u = Wrap::kRepeat, Wrap wrap_v = Wrap::kRepeat);
  /// The same from values that are linear already.
  explicit Texture(const Image<Linear8>& picture, Filter filter = Filter::kTrilinear,
                   Wrap wrap_u = Wrap::kRepeat, Wrap wrap_v = Wrap::kRepeat);

  std::string name;
  Filter filter = Filter::kTrilinear;
  Wrap wrap_u = Wrap::kRepeat;
  Wrap wrap_v = Wrap::kRepeat;

  int levels() const { return static_cast<int>(levels_.size()); }
  const Image<Texel>& level(int i) const { return levels_[static_cast<std::size_t>(i)]; }
  bool has_alpha() const { return has_alpha_; }

  /// The scalar reference: looks up (u, v) with the texture's filter at level of detail `lod`.
  LinearRgba sample(float u, float v, float lod) const;

 private:
  std::vector<Image<Texel>> levels_;
  bool has_alpha_ = false;
};

}  // namespace kinescope
