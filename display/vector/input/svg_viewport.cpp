#include "display/vector/input/svg_viewport.h"

#include <algorithm>

#include "display/vector/input/svg_values.h"

namespace kinescope {

glm::mat3x2 svg_viewbox_transform(const XmlElement& element, glm::vec2 viewport) {
  const std::vector<float> box = svg_numbers(element.attribute("viewBox"));
  if (box.size() < 4 || !(box[2] > 0 && box[3] > 0)) return {1, 0, 0, 1, 0, 0};
  glm::vec2 scale = viewport / glm::vec2(box[2], box[3]);
  const std::string_view aspect = element.attribute("preserveAspectRatio");
  glm::vec2 share{0.5f, 0.5f};
  if (aspect.find("none") == std::string_view::npos) {
    const bool slice = aspect.find("slice") != std::string_view::npos;
    scale = glm::vec2(slice ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y));
    if (aspect.find("xMin") != std::string_view::npos) share.x = 0;
    if (aspect.find("xMax") != std::string_view::npos) share.x = 1;
    if (aspect.find("YMin") != std::string_view::npos) share.y = 0;
    if (aspect.find("YMax") != std::string_view::npos) share.y = 1;
  }
  const glm::vec2 room = viewport - scale * glm::vec2(box[2], box[3]);
  const glm::vec2 offset = share * room - scale * glm::vec2(box[0], box[1]);
  return {scale.x, 0, 0, scale.y, offset.x, offset.y};
}

/// Source: Liang and Barsky, 1984.
bool SvgClip::cut(glm::vec2& from, glm::vec2& to) const {
  const glm::mat3x2& m = device_from_view;
  const float det = m[0].x * m[1].y - m[0].y * m[1].x;
  const auto view = [&](glm::vec2 p) {
    p -= m[2];
    return glm::vec2(m[1].y * p.x - m[1].x * p.y, m[0].x * p.y - m[0].y * p.x) / det;
  };
  const glm::vec2 a = view(from), d = view(to) - a;
  float enter = 0, leave = 1;
  for (int axis = 0; axis < 2; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const float room = side > 0 ? size[axis] - a[axis] : a[axis];
      const float towards = side * d[axis];
      if (towards == 0 && room < 0) return false;
      if (towards < 0) enter = std::max(enter, room / towards);
      if (towards > 0) leave = std::min(leave, room / towards);
    }
  }
  if (!(enter <= leave)) return false;
  const glm::vec2 whole = to - from;
  if (leave < 1) to = from + leave * whole;
  if (enter > 0) from += enter * whole;
  return true;
}

}  // namespace kinescope
