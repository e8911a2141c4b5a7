#include "raster/antialias/edge_blur.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace kinescope {
namespace {

/// Brightness as the eye sees it, near enough.
float brightness(const LinearRgb& c) {
  const float light = 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
  return light > 0 ? std::sqrt(light) : 0;  // NaN too
}

LinearRgb mixed(const LinearRgb& a, const LinearRgb& b, float t) {
  return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
}

class Blur {
 public:
  Blur(const Image<LinearRgb>& image, const EdgeBlur& settings) : image_(image), s_(settings) {}

  LinearRgb at(int x, int y) const {
    const LinearRgb& here = pixel(x, y);
    const float m = brightness(here);
    const float nw = corner(x, y, -1, -1), ne = corner(x, y, 1, -1);
    const float sw = corner(x, y, -1, 1), se = corner(x, y, 1, 1);
    const float low = std::min({m, nw, ne, sw, se}), high = std::max({m, nw, ne, sw, se});
    if (!(high - low >= std::max(s_.least_contrast, s_.relative_contrast * high))) return here;
    // Across the gradient lies the edge; the flatter it is, the further along is looked.
    glm::vec2 along(-((nw + ne) - (sw + se)), (nw + sw) - (ne + se));
    const float least = std::min(std::abs(along.x), std::abs(along.y)) + (nw + ne + sw + se) / 32;
    along = glm::clamp(along / std::max(least, 1.0f / 128), -s_.reach_px, s_.reach_px);
    const glm::vec2 p(x, y);
    const LinearRgb near = mixed(sample(p - along / 6.0f), sample(p + along / 6.0f), 0.5f);
    const LinearRgb far = mixed(sample(p - along / 2.0f), sample(p + along / 2.0f), 0.5f);
    const LinearRgb wide = mixed(near, far, 0.5f);
    const float b = brightness(wide);
    return b < low || b > high ? near : wide;  // it ran over the end of the edge
  }

 private:
  const LinearRgb& pixel(int x, int y) const {
    return image_.at(std::clamp(x, 0, image_.width() - 1), std::clamp(y, 0, image_.height() - 1));
  }
  /// The mean of the four pixels around a corner.
  float corner(int x, int y, int dx, int dy) const {
    return (brightness(pixel(x, y)) + brightness(pixel(x + dx, y)) + brightness(pixel(x, y + dy)) +
            brightness(pixel(x + dx, y + dy))) /
           4;
  }
  LinearRgb sample(glm::vec2 p) const {  // between pixels
    const glm::vec2 base = glm::floor(p), t = p - base;
    const int x = static_cast<int>(base.x), y = static_cast<int>(base.y);
    return mixed(mixed(pixel(x, y), pixel(x + 1, y), t.x),
                 mixed(pixel(x, y + 1), pixel(x + 1, y + 1), t.x), t.y);
  }

  const Image<LinearRgb>& image_;
  const EdgeBlur& s_;
};

}  // namespace

Image<LinearRgb> blur_edges(const Image<LinearRgb>& image, const EdgeBlur& settings) {
  Image<LinearRgb> result(image.width(), image.height());
  const Blur blur(image, settings);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) result.at(x, y) = blur.at(x, y);
  }
  return result;
}

}  // namespace kinescope
