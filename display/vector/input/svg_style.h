// What an SVG element inherits and sets: attributes, the style attribute, and simple style sheets
// (selectors of one element name, class or id).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "display/vector/input/xml.h"
#include "raster/colour/colour.h"

namespace kinescope {

struct SvgStyle {
  bool has_stroke = false, has_fill = true;
  Srgb8 stroke{0, 0, 0}, fill{0, 0, 0}, colour{0, 0, 0};
  float stroke_width = 1, opacity = 1, stroke_opacity = 1, fill_opacity = 1;
  float font_size = 16;
  float anchor = 0;  ///< of text: 0 start, 0.5 middle, 1 end
  std::vector<float> dashes;
  float dash_offset = 0;
  bool visible = true, displayed = true;
};

/// Rules by selector: "path", ".class", "#id".
class SvgStyleSheet {
 public:
  void add(std::string_view css);
  /// The element's own style on top of what it inherits.
  SvgStyle style(const XmlElement& element, const SvgStyle& inherited) const;

 private:
  void apply(std::string_view selector, bool important, SvgStyle& style) const;
  void apply_all(const XmlElement& element, bool important, SvgStyle& style) const;
  std::map<std::string, std::string, std::less<>> rules_;
};

}  // namespace kinescope
