#include "demos/ui/layer.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "demos/ui/theme.h"

namespace kinescope {
namespace {

std::uint8_t mix(std::uint8_t under, std::uint8_t over, int alpha) {
  return static_cast<std::uint8_t>((under * (255 - alpha) + over * alpha + 127) / 255);
}

}  // namespace

Layer begin_layer(int width, int height) {
  return {
      Image<Srgb8>(std::max(1, width), std::max(1, height), theme::with_alpha(theme::kPanel, 255)),
      0, 0};
}

void finish_layer(Layer& layer, float radius) {
  const Srgb8 untouched = theme::with_alpha(theme::kPanel, 255);
  const glm::vec2 half = glm::vec2(layer.image.width(), layer.image.height()) * 0.5f;
  for (int y = 0; y < layer.image.height(); ++y) {
    for (int x = 0; x < layer.image.width(); ++x) {
      Srgb8& pixel = layer.image.at(x, y);
      if (pixel == untouched) pixel.a = theme::kPanel.a;
      const glm::vec2 p = glm::vec2(x, y) + 0.5f;
      const float outside =
          glm::length(glm::max(glm::abs(p - half) - half + radius, 0.0f)) - radius + 0.5f;
      const float coverage = std::clamp(1 - outside, 0.0f, 1.0f);
      pixel.a = static_cast<std::uint8_t>(static_cast<float>(pixel.a) * coverage + 0.5f);
    }
  }
}

void composite(const Layer& layer, Image<Srgb8>& frame) {
  const int left = std::max(0, -layer.x), top = std::max(0, -layer.y);
  const int right = std::min(layer.image.width(), frame.width() - layer.x);
  const int bottom = std::min(layer.image.height(), frame.height() - layer.y);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const Srgb8 over = layer.image.at(x, y);
      Srgb8& under = frame.at(layer.x + x, layer.y + y);
      under = {mix(under.r, over.r, over.a), mix(under.g, over.g, over.a),
               mix(under.b, over.b, over.a), 255};
    }
  }
}

}  // namespace kinescope
