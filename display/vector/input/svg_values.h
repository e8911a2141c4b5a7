// The values of SVG's attributes. Source: W3C, SVG 1.1, chapters 4, 7 and 11.
#pragma once

#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "raster/colour/colour.h"

namespace kinescope {

/// Numbers, whatever stands between them; what is no number ends the list.
std::vector<float> svg_numbers(std::string_view text);

/// A length in user units. @param whole what 100% is
std::optional<float> svg_length(std::string_view text, float whole);

/// "translate(1,2) rotate(30)": one after another. What is wrong ends the list.
glm::mat3x2 svg_transform(std::string_view text);

/// The point or transform b, then a.
glm::mat3x2 then(const glm::mat3x2& a, const glm::mat3x2& b);

/// A colour; no value for "none". One that is not known, or a gradient, counts as white.
std::optional<Srgb8> svg_colour(std::string_view text);

std::string_view svg_trimmed(std::string_view text);

}  // namespace kinescope
