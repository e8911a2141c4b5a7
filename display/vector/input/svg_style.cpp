#include "display/vector/input/svg_style.h"

#include <algorithm>
#include <optional>

#include "display/vector/input/svg_values.h"

namespace kinescope {
namespace {

void set_colour(std::string_view value, Srgb8 current, bool& has, Srgb8& colour) {
  if (value == "currentColor") {
    has = true;
    colour = current;
    return;
  }
  const auto parsed = svg_colour(value);
  has = parsed.has_value();
  if (parsed) colour = *parsed;
}

float opacity_of(std::string_view value, float otherwise) {
  return std::clamp(svg_length(value, 1).value_or(otherwise), 0.0f, 1.0f);
}

void set_dashes(std::string_view value, SvgStyle& style) {
  style.dashes = svg_numbers(value);
  const auto sum = [&] {
    float total = 0;
    for (const float dash : style.dashes) total += dash;
    return total;
  };
  const bool negative =
      std::any_of(style.dashes.begin(), style.dashes.end(), [](float d) { return d < 0; });
  if (negative || !(sum() > 0)) style.dashes.clear();
  if (style.dashes.size() % 2 == 1) {
    const std::vector<float> once = style.dashes;
    style.dashes.insert(style.dashes.end(), once.begin(), once.end());
  }
}

void set(std::string_view name, std::string_view value, SvgStyle& style) {
  value = svg_trimmed(value);
  if (value == "inherit") return;
  if (name == "stroke") set_colour(value, style.colour, style.has_stroke, style.stroke);
  if (name == "fill") set_colour(value, style.colour, style.has_fill, style.fill);
  if (name == "color") style.colour = svg_colour(value).value_or(style.colour);
  if (name == "stroke-width")
    style.stroke_width = svg_length(value, 100).value_or(style.stroke_width);
  if (name == "stroke-opacity") style.stroke_opacity = opacity_of(value, style.stroke_opacity);
  if (name == "fill-opacity") style.fill_opacity = opacity_of(value, style.fill_opacity);
  if (name == "opacity") style.opacity *= opacity_of(value, 1);
  if (name == "font-size")
    style.font_size = svg_length(value, style.font_size).value_or(style.font_size);
  if (name == "text-anchor") style.anchor = value == "middle" ? 0.5f : value == "end" ? 1.0f : 0.0f;
  if (name == "stroke-dasharray") set_dashes(value, style);
  if (name == "stroke-dashoffset") style.dash_offset = svg_length(value, 100).value_or(0);
  if (name == "visibility") style.visible = value == "visible";
  if (name == "display" && value == "none") style.displayed = false;
}

/// "name: value; ...": those that are marked as important, or the others.
void set_all(std::string_view declarations, bool important, SvgStyle& style) {
  while (!declarations.empty()) {
    const std::size_t end = std::min(declarations.find(';'), declarations.size());
    const std::string_view one = declarations.substr(0, end);
    if (const std::size_t colon = one.find(':'); colon != std::string_view::npos) {
      const std::string_view value = one.substr(colon + 1);
      const std::size_t mark = value.find('!');
      if ((mark != std::string_view::npos) == important) {
        set(svg_trimmed(one.substr(0, colon)), value.substr(0, mark), style);
      }
    }
    declarations.remove_prefix(std::min(end + 1, declarations.size()));
  }
}

std::string without_comments(std::string_view css) {
  std::string out;
  while (!css.empty()) {
    const std::size_t begin = std::min(css.find("/*"), css.size());
    out += css.substr(0, begin);
    css.remove_prefix(begin);
    const std::size_t end = css.find("*/");
    css.remove_prefix(end == std::string_view::npos ? css.size() : end + 2);
  }
  return out;
}

}  // namespace

void SvgStyleSheet::add(std::string_view css) {
  const std::string text = without_comments(css);
  std::string_view left = text;
  for (;;) {
    const std::size_t open = left.find('{'), close = left.find('}');
    if (close == std::string_view::npos || open > close) return;
    std::string_view selectors = left.substr(0, open);
    while (!selectors.empty()) {
      const std::size_t comma = std::min(selectors.find(','), selectors.size());
      std::string& rule = rules_[std::string(svg_trimmed(selectors.substr(0, comma)))];
      rule += left.substr(open + 1, close - open - 1);
      rule += ';';
      selectors.remove_prefix(std::min(comma + 1, selectors.size()));
    }
    left.remove_prefix(close + 1);
  }
}

void SvgStyleSheet::apply(std::string_view selector, bool important, SvgStyle& style) const {
  if (const auto found = rules_.find(selector); found != rules_.end()) {
    set_all(found->second, important, style);
  }
}

void SvgStyleSheet::apply_all(const XmlElement& element, bool important, SvgStyle& style) const {
  if (rules_.empty()) return;
  apply("*", important, style);
  apply(element.name, important, style);
  std::string_view classes = element.attribute("class");
  while (!classes.empty()) {
    const std::size_t space = std::min(classes.find(' '), classes.size());
    if (space > 0) apply("." + std::string(classes.substr(0, space)), important, style);
    classes.remove_prefix(std::min(space + 1, classes.size()));
  }
  const std::string_view id = element.attribute("id");
  if (!id.empty()) apply("#" + std::string(id), important, style);
}

SvgStyle SvgStyleSheet::style(const XmlElement& element, const SvgStyle& inherited) const {
  SvgStyle style = inherited;
  for (const auto& [name, value] : element.attributes) set(name, value, style);
  apply_all(element, false, style);
  set_all(element.attribute("style"), false, style);
  apply_all(element, true, style);
  set_all(element.attribute("style"), true, style);
  return style;
}

}  // namespace kinescope
