#include "demos/ui/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace kinescope {
namespace {

float decoded(std::uint8_t code) {
  static const auto kTable = [] {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
      table[i] = decode(Srgb8{static_cast<std::uint8_t>(i), 0, 0, 255}).r;
    }
    return table;
  }();
  return kTable[code];
}

/// Distance from a rounded box's edge, negative inside.
float box_distance(glm::vec2 p, const Rect& box, float radius) {
  const glm::vec2 half = glm::vec2(box.width, box.height) * 0.5f;
  const glm::vec2 q = glm::abs(p - glm::vec2(box.x, box.y) - half) - half + radius;
  return glm::length(glm::max(q, 0.0f)) + std::min(std::max(q.x, q.y), 0.0f) - radius;
}

float segment_distance(glm::vec2 p, glm::vec2 a, glm::vec2 ab, float inv_length2) {
  const float t = std::clamp(glm::dot(p - a, ab) * inv_length2, 0.0f, 1.0f);
  return glm::length(p - a - ab * t);
}

/// Coverage of a pixel whose centre lies that far outside an edge.
float edge(float distance) { return std::clamp(0.5f - distance, 0.0f, 1.0f); }

/// The part of a line within a box, so that a line far outside costs nothing (Liang-Barsky).
bool cut(const Rect& box, glm::vec2& a, glm::vec2& b) {
  const glm::vec2 d = b - a;
  float t0 = 0, t1 = 1;
  const auto side = [&](float towards, float room) {
    if (towards == 0) return room >= 0;
    const float t = room / towards;
    (towards < 0 ? t0 = std::max(t0, t) : t1 = std::min(t1, t));
    return t0 <= t1;
  };
  if (!side(-d.x, a.x - box.x) || !side(d.x, box.right() - a.x) || !side(-d.y, a.y - box.y) ||
      !side(d.y, box.bottom() - a.y)) {
    return false;
  }
  b = a + d * t1;
  a = a + d * t0;
  return true;
}

}  // namespace

Canvas::Canvas(Image<Srgb8>& picture) : picture_(picture) { clear_clip(); }

void Canvas::clear_clip() {
  clip_ = {0, 0, static_cast<float>(picture_.width()), static_cast<float>(picture_.height())};
}

void Canvas::set_clip(const Rect& clip) {
  clear_clip();
  const float x0 = std::clamp(clip.x, 0.0f, clip_.width);
  const float y0 = std::clamp(clip.y, 0.0f, clip_.height);
  clip_ = {x0, y0, std::max(0.0f, std::min(clip.right(), clip_.right()) - x0),
           std::max(0.0f, std::min(clip.bottom(), clip_.bottom()) - y0)};
}

void Canvas::blend(int x, int y, Srgb8 colour, float coverage) {
  Srgb8& under = picture_.at(x, y);
  const float a = coverage * static_cast<float>(colour.a) / 255.0f;
  const auto mix = [a](std::uint8_t from, std::uint8_t to) {
    return decoded(from) + (decoded(to) - decoded(from)) * a;
  };
  const LinearRgb mixed{mix(under.r, colour.r), mix(under.g, colour.g), mix(under.b, colour.b)};
  under = encode_srgb8(mixed);
}

template <typename Coverage>
void Canvas::cover(float x0, float y0, float x1, float y1, Srgb8 colour, const Coverage& coverage) {
  // The clip comes first in each comparison, so that it also stands in for what is not a number;
  // its sum of start and width may be rounded past the picture. Far places are cut to it before
  // they become whole numbers.
  const int left = static_cast<int>(std::floor(std::min(clip_.right(), std::max(clip_.x, x0))));
  const int top = static_cast<int>(std::floor(std::min(clip_.bottom(), std::max(clip_.y, y0))));
  const int right =
      std::min(picture_.width(),
               static_cast<int>(std::ceil(std::max(clip_.x, std::min(clip_.right(), x1)))));
  const int bottom =
      std::min(picture_.height(),
               static_cast<int>(std::ceil(std::max(clip_.y, std::min(clip_.bottom(), y1)))));
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const float c =
          coverage(glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
      if (c > 0) blend(x, y, colour, c);
    }
  }
}

void Canvas::fill(const Rect& rect, Srgb8 colour, float radius) {
  cover(rect.x, rect.y, rect.right(), rect.bottom(), colour,
        [&](glm::vec2 p) { return edge(box_distance(p, rect, radius)); });
}

void Canvas::frame(const Rect& rect, float width, Srgb8 colour, float radius) {
  cover(rect.x, rect.y, rect.right(), rect.bottom(), colour, [&](glm::vec2 p) {
    const float d = box_distance(p, rect, radius);
    return std::min(edge(d), edge(-width - d));
  });
}

void Canvas::line(glm::vec2 a, glm::vec2 b, float width, Srgb8 colour) {
  const float half = width * 0.5f;
  const Rect room = clip_.shrunk(-half - 1);
  if (!cut(room, a, b)) return;
  const glm::vec2 ab = b - a;
  const float length2 = glm::dot(ab, ab);
  const float inv_length2 = length2 > 0 ? 1 / length2 : 0;
  const auto coverage = [&](glm::vec2 p) {
    // Lines thinner than a pixel are fainter, not narrower.
    return edge(segment_distance(p, a, ab, inv_length2) - std::max(half, 0.5f)) *
           std::min(width, 1.0f);
  };
  // Pixel by pixel along the longer axis, a few across: no box far larger than the line.
  const bool flat = std::abs(ab.x) >= std::abs(ab.y);
  const glm::vec2 major = flat ? glm::vec2(a.x, b.x) : glm::vec2(a.y, b.y);
  const float run = major.y - major.x, rise = flat ? ab.y : ab.x;
  const float slope = run != 0 ? rise / run : 0;
  const float low = std::min(major.x, major.y), high = std::max(major.x, major.y);
  const float reach = half + 1, slack = 2 * reach + 1;
  for (float m = std::floor(low - reach); m < high + reach; ++m) {
    const float centre = (flat ? a.y : a.x) + (std::clamp(m, low, high) - major.x) * slope;
    if (flat) {
      cover(m, centre - slack, m + 1, centre + slack, colour, coverage);
    } else {
      cover(centre - slack, m, centre + slack, m + 1, colour, coverage);
    }
  }
}

void Canvas::dashed(glm::vec2 a, glm::vec2 b, float width, float dash, float gap, Srgb8 colour) {
  const float length = glm::length(b - a);
  if (!(length > 0) || length > 1e5f) return;
  const glm::vec2 along = (b - a) / length;
  for (float s = 0; s < length; s += dash + gap) {
    line(a + along * s, a + along * std::min(s + dash, length), width, colour);
  }
}

void Canvas::polyline(std::span<const glm::vec2> points, float width, Srgb8 colour) {
  for (std::size_t i = 1; i < points.size(); ++i) line(points[i - 1], points[i], width, colour);
}

void Canvas::arrow(glm::vec2 from, glm::vec2 to, float width, Srgb8 colour) {
  line(from, to, width, colour);
  const float length = glm::length(to - from);
  if (!(length > 0)) return;
  const glm::vec2 back = (from - to) / length * (width * 4 + 2);
  const glm::vec2 across{-back.y * 0.45f, back.x * 0.45f};
  line(to, to + back + across, width, colour);
  line(to, to + back - across, width, colour);
}

void Canvas::disc(glm::vec2 centre, float radius, Srgb8 colour) {
  cover(centre.x - radius - 1, centre.y - radius - 1, centre.x + radius + 1, centre.y + radius + 1,
        colour, [&](glm::vec2 p) { return edge(glm::length(p - centre) - radius); });
}

void Canvas::text(const Font& font, glm::vec2 place, std::string_view text, float size,
                  Srgb8 colour, Align align) {
  if (!(size > 0)) return;  // laid out in a picture of a pixel or two
  const float width = font.width_px(text, size);
  if (align != Align::kLeft) place.x -= align == Align::kRight ? width : width * 0.5f;
  if (place.x > clip_.right() || place.x + width < clip_.x || place.y - size > clip_.bottom() ||
      place.y + size < clip_.y) {
    return;
  }
  font.draw(picture_, place.x, place.y, text, size, colour);
}

}  // namespace kinescope
