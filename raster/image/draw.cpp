#include "raster/image/draw.h"

#include <algorithm>

#include "raster/line.h"

namespace kinescope {

PictureRect clipped(PictureRect rect, int width, int height) {
  using Wide = std::int64_t;
  const Wide right = std::min<Wide>(Wide{rect.x} + rect.width, width);
  const Wide bottom = std::min<Wide>(Wide{rect.y} + rect.height, height);
  const Wide left = std::max(rect.x, 0), top = std::max(rect.y, 0);
  if (right <= left || bottom <= top) return {};
  return {static_cast<int>(left), static_cast<int>(top), static_cast<int>(right - left),
          static_cast<int>(bottom - top)};
}

void blend(Srgb8& below, LinearRgba colour, float opacity) {
  const float alpha = colour.a * opacity;
  if (!(alpha > 0)) return;
  if (alpha >= 1) {
    below = encode_srgb8(LinearRgb{colour.r, colour.g, colour.b});
    return;
  }
  const LinearRgba under = decode(below);
  const float rest = under.a * (1 - alpha), total = alpha + rest;
  const auto mix = [=](float top, float bottom) { return (top * alpha + bottom * rest) / total; };
  below = encode_srgb8(
      LinearRgba{mix(colour.r, under.r), mix(colour.g, under.g), mix(colour.b, under.b), total});
}

void fill_rect(Image<Srgb8>& picture, PictureRect rect, Srgb8 colour) {
  const PictureRect area = clipped(rect, picture.width(), picture.height());
  const LinearRgba light = decode(colour);
  for (int y = area.y; y < area.y + area.height; ++y) {
    Srgb8* row = picture.row(y) + area.x;
    for (int x = 0; x < area.width; ++x) blend(row[x], light);
  }
}

void frame_rect(Image<Srgb8>& picture, PictureRect rect, Srgb8 colour, int thickness) {
  const auto [x, y, w, h] = rect;
  if (2 * thickness >= std::min(w, h)) {
    fill_rect(picture, rect, colour);
    return;
  }
  const int t = thickness;
  for (const PictureRect side :
       {PictureRect{x, y, w, t}, PictureRect{x, y + h - t, w, t},
        PictureRect{x, y + t, t, h - 2 * t}, PictureRect{x + w - t, y + t, t, h - 2 * t}}) {
    fill_rect(picture, side, colour);
  }
}

void draw_line(Image<Srgb8>& picture, int x0, int y0, int x1, int y1, Srgb8 colour) {
  const LinearRgba light = decode(colour);
  bresenham_clipped(x0, y0, x1, y1, picture.width(), picture.height(),
                    [&](int x, int y) { blend(picture.at(x, y), light); });
}

void blit(Image<Srgb8>& picture, int x, int y, const Image<Srgb8>& source) {
  const PictureRect area =
      clipped({x, y, source.width(), source.height()}, picture.width(), picture.height());
  for (int row = area.y; row < area.y + area.height; ++row) {
    Srgb8* to = picture.row(row) + area.x;
    const Srgb8* from = source.row(row - y) + (area.x - x);
    for (int i = 0; i < area.width; ++i) {
      if (from[i].a == 255) {
        to[i] = from[i];
      } else {
        blend(to[i], decode(from[i]));
      }
    }
  }
}

}  // namespace kinescope
