// Draws text, lines and boxes on a finished picture, smooth at its own resolution.
#pragma once

#include <algorithm>
#include <glm/vec2.hpp>
#include <span>
#include <string_view>

#include "raster/image/image.h"
#include "raster/path/font.h"

namespace kinescope {

/// A rectangle, pixels.
struct Rect {
  float x = 0, y = 0, width = 0, height = 0;
  float right() const { return x + width; }
  float bottom() const { return y + height; }
  bool contains(float px, float py) const {
    return px >= x && py >= y && px < right() && py < bottom();
  }
  /// By that much at each side, at most to a point or a line at its centre.
  Rect shrunk(float by) const {
    const float across = std::min(by, width * 0.5f), down = std::min(by, height * 0.5f);
    return {x + across, y + down, width - 2 * across, height - 2 * down};
  }
};

/// Where text stands from its x.
enum class Align { kLeft, kCentre, kRight };

/// Everything is blended in linear light by the colour's alpha and clipped to clip().
class Canvas {
 public:
  explicit Canvas(Image<Srgb8>& picture);

  const Rect& clip() const { return clip_; }
  /// Cut to the picture.
  void set_clip(const Rect& clip);
  void clear_clip();

  void fill(const Rect& rect, Srgb8 colour, float radius = 0);
  /// The border of a rectangle, its width inside.
  void frame(const Rect& rect, float width, Srgb8 colour, float radius = 0);
  void line(glm::vec2 a, glm::vec2 b, float width, Srgb8 colour);
  void dashed(glm::vec2 a, glm::vec2 b, float width, float dash, float gap, Srgb8 colour);
  void polyline(std::span<const glm::vec2> points, float width, Srgb8 colour);
  void arrow(glm::vec2 from, glm::vec2 to, float width, Srgb8 colour);
  void disc(glm::vec2 centre, float radius, Srgb8 colour);
  /// One line of text on its baseline; left out where it does not lie within the clip at all.
  void text(const Font& font, glm::vec2 place, std::string_view text, float size, Srgb8 colour,
            Align align = Align::kLeft);

 private:
  template <typename Coverage>
  void cover(float x0, float y0, float x1, float y1, Srgb8 colour, const Coverage& coverage);
  void blend(int x, int y, Srgb8 colour, float coverage);

  Image<Srgb8>& picture_;
  Rect clip_;
};

}  // namespace kinescope
