#include "raster/path/glyph_painter.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "raster/image/draw.h"

namespace kinescope {
namespace {

void lay(Srgb8& below, LinearRgba light, std::uint8_t coverage) {
  blend(below, light, static_cast<float>(coverage) / 255);
}

}  // namespace

GlyphCoverage::GlyphCoverage(int left, int top, int width, std::vector<std::uint8_t> pixels)
    : left_(left),
      top_(top),
      width_(width),
      height_(width > 0 ? static_cast<int>(pixels.size()) / width : 0),
      pixels_(std::move(pixels)) {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_;) {
      const int begin = x;
      const auto kind = [&] { return *at(x, y) == 0 ? 0 : *at(x, y) == 255 ? 2 : 1; };
      const int first = kind();
      while (x < width_ && kind() == first) ++x;
      if (first != 0) runs_.push_back({begin, y, x - begin, first == 2});
    }
  }
}

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
  const int left = pen + glyph.left(), top = baseline + glyph.top();
  const Rect box{left, top, glyph.width(), glyph.height()};
  const Rect area = clipped(box, picture.width(), picture.height());
  const bool cut = !(area == box);
  const LinearRgba light = decode(ink);
  const Mixture* on = nullptr;
  bool any = false;
  for (GlyphCoverage::Run run : glyph.runs()) {
    int x = left + run.x;
    const int y = top + run.y;
    if (cut) {
      const int end = std::min(x + run.length, area.x + area.width);
      x = std::max(x, area.x);
      if (y < area.y || y >= area.y + area.height || x >= end) continue;
      run.length = end - x;
    }
    Srgb8* const row = picture.row(y) + x;
    if (run.whole && ink.a == 255) {
      std::fill_n(row, run.length, ink);
      continue;
    }
    if (!any) on = mixture(*row, ink);
    any = true;
    const std::uint8_t* const coverage = glyph.at(x - left, run.y);
    for (int i = 0; i < run.length; ++i) {
      if (on && row[i] == on->ground) {
        row[i] = on->mixed[coverage[i]];
      } else {
        lay(row[i], light, coverage[i]);
      }
    }
  }
}

}  // namespace kinescope
