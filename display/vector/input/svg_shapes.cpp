#include "display/vector/input/svg_shapes.h"

#include <algorithm>

#include "display/vector/input/svg_values.h"
#include "raster/path/svg_path.h"

namespace kinescope {
namespace {

/// Of a quarter of a circle, for its cubic.
constexpr float kHandle = 0.5522848f;

/// Lengths by attribute.
struct Lengths {
  const XmlElement& element;
  glm::vec2 viewport;
  float across(std::string_view name) const { return get(name, viewport.x); }
  float down(std::string_view name) const { return get(name, viewport.y); }
  float radius(std::string_view name) const {
    return get(name, std::sqrt(0.5f * (viewport.x * viewport.x + viewport.y * viewport.y)));
  }
  float get(std::string_view name, float whole) const {
    return svg_length(element.attribute(name), whole).value_or(0);
  }
};

Path ellipse(glm::vec2 c, glm::vec2 r) {
  const glm::vec2 h = kHandle * r;
  Path path;
  if (!(r.x > 0 && r.y > 0)) return path;
  path.move_to({c.x + r.x, c.y});
  path.cubic_to({c.x + r.x, c.y + h.y}, {c.x + h.x, c.y + r.y}, {c.x, c.y + r.y});
  path.cubic_to({c.x - h.x, c.y + r.y}, {c.x - r.x, c.y + h.y}, {c.x - r.x, c.y});
  path.cubic_to({c.x - r.x, c.y - h.y}, {c.x - h.x, c.y - r.y}, {c.x, c.y - r.y});
  path.cubic_to({c.x + h.x, c.y - r.y}, {c.x + r.x, c.y - h.y}, {c.x + r.x, c.y});
  path.close();
  return path;
}

Path rectangle(glm::vec2 a, glm::vec2 size, glm::vec2 r) {
  Path path;
  if (!(size.x > 0 && size.y > 0)) return path;
  r = {std::min(r.x, size.x / 2), std::min(r.y, size.y / 2)};
  const glm::vec2 b = a + size, h = (1 - kHandle) * r;
  if (!(r.x > 0 && r.y > 0)) {
    path.move_to(a);
    path.line_to({b.x, a.y});
    path.line_to(b);
    path.line_to({a.x, b.y});
    path.close();
    return path;
  }
  path.move_to({a.x + r.x, a.y});
  path.line_to({b.x - r.x, a.y});
  path.cubic_to({b.x - h.x, a.y}, {b.x, a.y + h.y}, {b.x, a.y + r.y});
  path.line_to({b.x, b.y - r.y});
  path.cubic_to({b.x, b.y - h.y}, {b.x - h.x, b.y}, {b.x - r.x, b.y});
  path.line_to({a.x + r.x, b.y});
  path.cubic_to({a.x + h.x, b.y}, {a.x, b.y - h.y}, {a.x, b.y - r.y});
  path.line_to({a.x, a.y + r.y});
  path.cubic_to({a.x, a.y + h.y}, {a.x + h.x, a.y}, {a.x + r.x, a.y});
  path.close();
  return path;
}

Path rectangle_of(const Lengths& n) {
  const auto rx = svg_length(n.element.attribute("rx"), n.viewport.x);
  const auto ry = svg_length(n.element.attribute("ry"), n.viewport.y);
  return rectangle({n.across("x"), n.down("y")}, {n.across("width"), n.down("height")},
                   {rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0))});
}

Path polyline(std::string_view points, bool closed) {
  const std::vector<float> n = svg_numbers(points);
  Path path;
  for (std::size_t i = 0; i + 1 < n.size(); i += 2) {
    if (i == 0) {
      path.move_to({n[0], n[1]});
    } else {
      path.line_to({n[i], n[i + 1]});
    }
  }
  if (closed && !path.verbs.empty()) path.close();
  return path;
}

}  // namespace

std::optional<Path> svg_shape(const XmlElement& element, glm::vec2 viewport) {
  const Lengths n{element, viewport};
  const std::string& name = element.name;
  if (name == "path") return parse_svg_path(element.attribute("d"));
  if (name == "rect") return rectangle_of(n);
  if (name == "circle") {
    return ellipse({n.across("cx"), n.down("cy")}, glm::vec2(n.radius("r")));
  }
  if (name == "ellipse") {
    return ellipse({n.across("cx"), n.down("cy")}, {n.across("rx"), n.down("ry")});
  }
  if (name == "line") {
    Path path;
    path.move_to({n.across("x1"), n.down("y1")});
    path.line_to({n.across("x2"), n.down("y2")});
    return path;
  }
  if (name == "polyline" || name == "polygon") {
    return polyline(element.attribute("points"), name == "polygon");
  }
  return std::nullopt;
}

}  // namespace kinescope
