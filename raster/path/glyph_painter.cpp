#include "raster/path/glyph_painter.h"

#include <algorithm>
#include <bit>
#include <cstddef>

#include "raster/image/draw.h"

namespace kinescope {
namespace {

void lay(Srgb8& below, LinearRgba light, std::uint8_t coverage) {
  blend(below, light, static_cast<float>(coverage) / 255);
}

/// Where the first covered pixel of a row lies; `count` if there is none.
int first_covered(const std::uint8_t* coverage, int count) {
  int x = 0;
  while (x < count && coverage[x] == 0) ++x;
  return x;
}

}  // namespace

/// None for a ground that one character alone stands on so far: of a photograph's there is no end.
const GlyphPainter::Mixture* GlyphPainter::mixture(Srgb8 ground, Srgb8 ink) {
  const auto bits = [](Srgb8 c) { return std::bit_cast<std::uint32_t>(c); };
  const std::uint32_t hash = (bits(ground) * 0x9e3779b1u) ^ (bits(ink) * 0x85ebca6bu);
  Mixture& mixture = mixtures_[(hash >> 16) % kMixtures];
  if (mixture.met == 0 || mixture.ground != ground || mixture.ink != ink) {
    mixture.ground = ground, mixture.ink = ink;
    mixture.met = 1;
    return nullptr;
  }
  if (mixture.met == 1) {
    mixture.met = 2;
    mixture.mixed.fill(ground);
    const LinearRgba light = decode(ink);
    for (std::size_t c = 1; c < 256; ++c) lay(mixture.mixed[c], light, std::uint8_t(c));
  }
  return &mixture;
}

void GlyphPainter::draw(Image<Srgb8>& picture, const GlyphCoverage& glyph, int pen, int baseline,
                        Srgb8 ink) {
  const int left = pen + glyph.left, top = baseline + glyph.top;
  const Rect area =
      clipped({left, top, glyph.width, glyph.height}, picture.width(), picture.height());
  const LinearRgba light = decode(ink);
  const Mixture* on = nullptr;
  bool any = false;
  for (int y = area.y; y < area.y + area.height; ++y) {
    const std::uint8_t* const coverage =
        glyph.pixels.data() + (y - top) * glyph.width + (area.x - left);
    Srgb8* const row = picture.row(y) + area.x;
    int x = first_covered(coverage, area.width);
    if (x == area.width) continue;
    if (!any) on = mixture(row[x], ink);
    any = true;
    if (!on) {
      for (; x < area.width; ++x) lay(row[x], light, coverage[x]);
      continue;
    }
    for (; x < area.width; ++x) {
      if (row[x] == on->ground) {
        row[x] = on->mixed[coverage[x]];
      } else {
        lay(row[x], light, coverage[x]);
      }
    }
  }
}

}  // namespace kinescope
