// Viewports: what a viewBox becomes, and where strokes end.
#pragma once

#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>

#include "display/vector/input/xml.h"

namespace kinescope {

/// The viewport's units from those of its viewBox. Source: SVG 1.1, 7.8.
glm::mat3x2 svg_viewbox_transform(const XmlElement& element, glm::vec2 viewport);

/// A viewport as strokes are cut to it: [0, size] in units of its own.
struct SvgClip {
  glm::mat3x2 device_from_view;
  glm::vec2 size;

  /// @return whether anything is left of the stroke
  bool cut(glm::vec2& from, glm::vec2& to) const;
};

}  // namespace kinescope
