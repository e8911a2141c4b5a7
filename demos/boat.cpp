#include "demos/boat.h"

#include <cmath>

#include "raster/antialias/area_coverage.h"

namespace kinescope {

const std::array<BoatPart, 4>& boat() {
  static const std::array<BoatPart, 4> kBoatParts = {
      {{{{0, 0.72}, {1, 0.72}, {1, 1}, {0, 1}}, {0.01f, 0.08f, 0.3f}, {0.1f, 0.42f, 0.6f}},
       {{{0.2, 0.68}, {0.88, 0.68}, {0.74, 0.86}, {0.32, 0.86}},
        {0.06f, 0.02f, 0.01f},
        {0.3f, 0.12f, 0.03f}},
       {{{0.53, 0.08}, {0.53, 0.62}, {0.86, 0.62}}, {0.08f, 0.05f, 0.02f}, {1.0f, 0.8f, 0.4f}},
       {{{0.49, 0.14}, {0.49, 0.62}, {0.22, 0.62}}, {0.55f, 0.05f, 0.04f}, {0.12f, 0.01f, 0.01f}}}};
  return kBoatParts;
}

Image<LinearRgb> boat_picture(int width, int height) {
  Image<LinearRgb> light(width, height, {0.5f, 0.62f, 0.75f});
  const glm::dvec2 size(width, height);
  for (const BoatPart& part : boat()) {
    Contour contour;
    for (const glm::dvec2& corner : part.corners) contour.push_back(corner * size);
    area_coverage(
        {contour}, FillRule::kNonZero, {0, 0, width, height}, [&](int x, int y, float share) {
          const float t = (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
          LinearRgb& below = light.at(x, y);
          const auto mix = [&](float under, float left, float right) {
            return std::lerp(under, std::lerp(left, right, t), share);
          };
          below = {mix(below.r, part.left.r, part.right.r), mix(below.g, part.left.g, part.right.g),
                   mix(below.b, part.left.b, part.right.b)};
        });
  }
  return light;
}

}  // namespace kinescope
