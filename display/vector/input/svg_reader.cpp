#include "display/vector/input/svg_reader.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "display/vector/input/svg_dashes.h"
#include "display/vector/input/svg_shapes.h"
#include "display/vector/input/svg_style.h"
#include "display/vector/input/svg_values.h"
#include "display/vector/input/svg_viewport.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr float kTolerance = 0.05f;
constexpr int kMostUses = 16;                     ///< one within another
constexpr std::size_t kMostElements = 4'000'000;  ///< drawn, uses counted each time
constexpr std::size_t kMostSegments = 100'000'000;
constexpr float kMostUnits = 1e6f;

float size_of(const glm::mat3x2& m) {
  return std::sqrt(std::abs(m[0].x * m[1].y - m[0].y * m[1].x));
}

class SvgReader {
 public:
  SvgReader(const XmlElement& root, std::string name, VectorDrawing& out)
      : root_(root), name_(std::move(name)), out_(out) {
    collect(root);
  }

  void read() {
    const std::vector<float> box = svg_numbers(root_.attribute("viewBox"));
    const bool has_box = box.size() >= 4 && box[2] > 0 && box[3] > 0;
    const glm::vec2 usual = has_box ? glm::vec2(box[2], box[3]) : glm::vec2(300, 150);
    const glm::vec2 size{svg_length(root_.attribute("width"), usual.x).value_or(usual.x),
                         svg_length(root_.attribute("height"), usual.y).value_or(usual.y)};
    if (!(size.x > 0 && size.y > 0 && size.x <= kMostUnits && size.y <= kMostUnits)) {
      throw_bad_input("has no size that can be drawn", name_);
    }
    out_.size = size;
    const glm::mat3x2 flip{1, 0, 0, -1, 0, size.y};
    const Place place{
        then(flip, svg_viewbox_transform(root_, size)), has_box ? usual : size, {}, 0, {}};
    const SvgStyle style = sheet_.style(root_, SvgStyle{});
    if (style.displayed) children(root_, place, style);
  }

 private:
  struct Place {
    glm::mat3x2 device_from_user;
    glm::vec2 viewport;
    glm::vec2 symbol_size;  ///< that a use gives its symbol; 0: none
    int uses;
    std::vector<SvgClip> clips;  ///< of nested viewports
  };

  /// Style sheets, and what can be referred to.
  void collect(const XmlElement& element) {
    if (element.name == "style") sheet_.add(element.text);
    const std::string_view id = element.attribute("id");
    if (!id.empty()) by_id_.emplace(id, &element);
    for (const XmlElement& child : element.children) collect(child);
  }

  void children(const XmlElement& parent, const Place& place, const SvgStyle& style) {
    for (const XmlElement& child : parent.children) element(child, place, style);
  }

  void element(const XmlElement& e, Place place, const SvgStyle& inherited) {
    if (++elements_ > kMostElements) {
      throw_bad_input("draws more elements than can be meant: it refers to itself too often",
                      name_);
    }
    const SvgStyle style = sheet_.style(e, inherited);
    if (!style.displayed) return;
    place.device_from_user = then(place.device_from_user, svg_transform(e.attribute("transform")));
    if (e.name == "g" || e.name == "a" || e.name == "switch") {
      children(e, place, style);
    } else if (e.name == "svg") {
      nested(e, place, style);
    } else if (e.name == "use") {
      use(e, place, style);
    } else if (e.name == "text") {
      text(e, place, style);
    } else if (const auto path = svg_shape(e, place.viewport); path && style.visible) {
      draw(*path, place, style);
    }
  }

  void nested(const XmlElement& e, Place place, const SvgStyle& style) {
    const auto length = [&](const char* name, float whole, float otherwise) {
      return svg_length(e.attribute(name), whole).value_or(otherwise);
    };
    const glm::vec2 v = place.viewport;
    const glm::vec2 corner{length("x", v.x, 0), length("y", v.y, 0)};
    glm::vec2 size{length("width", v.x, v.x), length("height", v.y, v.y)};
    if (place.symbol_size.x > 0) size = place.symbol_size;
    const glm::mat3x2 moved{1, 0, 0, 1, corner.x, corner.y};
    const glm::mat3x2 device_from_view = then(place.device_from_user, moved);
    if (e.attribute("overflow") != "visible") place.clips.push_back({device_from_view, size});
    place.device_from_user = then(device_from_view, svg_viewbox_transform(e, size));
    const std::vector<float> box = svg_numbers(e.attribute("viewBox"));
    place.viewport = box.size() >= 4 ? glm::vec2(box[2], box[3]) : size;
    place.symbol_size = {};
    children(e, place, style);
  }

  void use(const XmlElement& e, Place place, const SvgStyle& style) {
    const std::string_view reference = e.attribute("href");
    if (!reference.starts_with('#') || ++place.uses > kMostUses) return;
    const auto found = by_id_.find(reference.substr(1));
    if (found == by_id_.end()) return;
    const auto length = [&](const char* name, float whole) {
      return svg_length(e.attribute(name), whole).value_or(0);
    };
    const glm::mat3x2 moved{
        1, 0, 0, 1, length("x", place.viewport.x), length("y", place.viewport.y)};
    place.device_from_user = then(place.device_from_user, moved);
    place.symbol_size = {length("width", place.viewport.x), length("height", place.viewport.y)};
    if (found->second->name == "symbol") {
      nested(*found->second, place, sheet_.style(*found->second, style));
    } else {
      element(*found->second, place, style);
    }
  }

  /// Black ink is white light.
  static Srgb8 light_of(Srgb8 ink) { return ink == Srgb8{0, 0, 0} ? Srgb8{255, 255, 255} : ink; }

  void draw(const Path& path, const Place& place, const SvgStyle& style) {
    const glm::mat3x2& device_from_user = place.device_from_user;
    if (!style.has_stroke && !style.has_fill) return;
    VectorPen pen;
    pen.colour = light_of(style.has_stroke ? style.stroke : style.fill);
    if (style.has_stroke) pen.width = style.stroke_width * size_of(device_from_user);
    out_.use(pen);
    const float intensity =
        style.opacity * (style.has_stroke ? style.stroke_opacity : style.fill_opacity);
    SvgDashes dashes(style, size_of(device_from_user));
    for_each_chord(path, device_from_user, kTolerance,
                   [&](glm::vec2 from, glm::vec2 to, bool begins) {
                     if (begins) dashes.restart();
                     dashes.line(from, to, [&](glm::vec2 a, glm::vec2 b) {
                       for (const SvgClip& clip : place.clips) {
                         if (!clip.cut(a, b)) return;
                       }
                       line(a, b, intensity);
                     });
                   });
  }

  void line(glm::vec2 from, glm::vec2 to, float intensity) {
    const auto far = [](glm::vec2 p) { return !(std::max(std::abs(p.x), std::abs(p.y)) < 1e9f); };
    if (far(from) || far(to)) return;
    if (out_.segments.size() >= kMostSegments) throw_bad_input("has too many strokes", name_);
    out_.line(from, to, intensity);
  }

  /// A line of it, in the stroke font: letters 0.6 of the font's size apart.
  void text(const XmlElement& e, const Place& place, const SvgStyle& style) {
    std::string all;
    gather(e, all);
    const std::string shown(svg_trimmed(all));
    if (shown.empty() || !style.visible || !(style.has_fill || style.has_stroke)) return;
    const auto first = [&](const char* name) {
      const std::vector<float> n = svg_numbers(e.attribute(name));
      return n.empty() ? 0.0f : n[0];
    };
    const glm::mat3x2& m = place.device_from_user;
    DrawnText drawn;
    drawn.text = shown;
    drawn.advance = 0.6f * style.font_size * m[0];
    drawn.up = -0.7f * style.font_size * m[1];
    drawn.place = m * glm::vec3(first("x"), first("y"), 1) -
                  style.anchor * static_cast<float>(shown.size()) * drawn.advance;
    drawn.intensity = style.opacity * (style.has_fill ? style.fill_opacity : style.stroke_opacity);
    drawn.pen.colour = light_of(style.has_fill ? style.fill : style.stroke);
    drawn.segments = out_.segments.size();
    out_.texts.push_back(std::move(drawn));
  }
  /// Blanks count as one; letters outside ASCII as one question mark each.
  static void gather(const XmlElement& e, std::string& to) {
    for (const char c : e.text) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte >= 0x80) {
        if (byte >= 0xc0) to += '?';
      } else if (byte > ' ') {
        to += c;
      } else if (!to.empty() && to.back() != ' ') {
        to += ' ';
      }
    }
    for (const XmlElement& child : e.children) gather(child, to);
  }

  const XmlElement& root_;
  std::string name_;
  VectorDrawing& out_;
  SvgStyleSheet sheet_;
  std::unordered_map<std::string_view, const XmlElement*> by_id_;
  std::size_t elements_ = 0;
};

}  // namespace

VectorDrawing read_svg(std::span<const std::uint8_t> bytes, const std::string& name) {
  const XmlElement root = parse_xml(bytes, name);
  if (root.name != "svg") throw_bad_input("is XML, but no SVG", name);
  VectorDrawing drawing;
  SvgReader(root, name, drawing).read();
  return drawing;
}

}  // namespace kinescope
