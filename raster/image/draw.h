// What panels and labels need on a finished picture: a few clipped 2-D operations, blended in
// linear light.
#pragma once

#include "raster/image/image.h"

namespace kinescope {

/// Pixels [x, x + width) x [y, y + height), y downwards. May lie anywhere.
struct PictureRect {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PictureRect&) const = default;
};

/// The part of `rect` within a picture of this size; empty (width or height 0) if there is none.
PictureRect clipped(PictureRect rect, int width, int height);

/// Lays `colour` over `below`. Opacity in [0, 1] multiplies colour.a; 0 leaves `below` as it is,
/// 1 replaces it exactly.
void blend(Srgb8& below, LinearRgba colour, float opacity = 1);

void fill_rect(Image<Srgb8>& picture, PictureRect rect, Srgb8 colour);

/// The rectangle's outline, `thickness` pixels wide, inside it; no pixel is blended twice.
void frame_rect(Image<Srgb8>& picture, PictureRect rect, Srgb8 colour, int thickness = 1);

/// Bresenham's line with both ends; clipping changes no pixel of what stays. Coordinates within
/// +-2^29.
void draw_line(Image<Srgb8>& picture, int x0, int y0, int x1, int y1, Srgb8 colour);

/// Lays `source` over the picture with its corner at (x, y). Opaque pixels are copied.
void blit(Image<Srgb8>& picture, int x, int y, const Image<Srgb8>& source);

}  // namespace kinescope
