#include "raster/path/glyph_painter.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "raster/image/draw.h"

namespace kinescope {
namespace {

/// To be compared at once, not channel by channel.
std::uint32_t word(Srgb8 colour) { return std::bit_cast<std::uint32_t>(colour); }

constexpr std::ptrdiff_t kLong = 8;  // pixels: fewer are sooner looked up with those beside them

const std::uint8_t* end_of_same(const std::uint8_t* from, const std::uint8_t* end) {
  return std::find_if(from, end, [&](std::uint8_t c) { return c != *from; });
}

/// Where pixels of one kind end: not covered, a long run wholly covered, or others.
const std::uint8_t* end_of_run(const std::uint8_t* from, const std::uint8_t* end) {
  const std::uint8_t* to = end_of_same(from, end);
  if (*from == 0 || (*from == 255 && to - from >= kLong)) return to;
  while (to < end && *to != 0) {
    const std::uint8_t* const next = end_of_same(to, end);
    if (*to == 255 && next - to >= kLong) break;
    to = next;
  }
  return to;
}

void lay(Srgb8& below, const LinearRgba& light, std::uint8_t coverage) {
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
    const std::uint8_t *const begin = at(0, y), *const end = begin + width_;
    for (const std::uint8_t* from = begin; from < end;) {
      const std::uint8_t* const to = end_of_run(from, end);
      if (*from != 0) {
        const bool whole = to - from >= kLong && end_of_same(from, end) == to && *from == 255;
        runs_.push_back({static_cast<std::int16_t>(from - begin), static_cast<std::int16_t>(y),
                         static_cast<std::int16_t>(to - from), whole});
      }
      from = to;
    }
  }
}

/// None for a ground that one character alone stands on so far: of a photograph's there is no end.
const GlyphPainter::Mixture* GlyphPainter::mixture(Srgb8 ground, Srgb8 ink) {
  const std::uint32_t hash = (word(ground) * 0x9e3779b1u) ^ (word(ink) * 0x85ebca6bu);
  Mixture& mixture = mixtures_[(hash >> 16) % kMixtures];
  if (mixture.met == 0 || mixture.ground != word(ground) || mixture.ink != word(ink)) {
    mixture.ground = word(ground), mixture.ink = word(ink);
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

namespace {

PictureRect box_of(const GlyphCoverage& glyph, int pen, int baseline) {
  return {pen + glyph.left(), baseline + glyph.top(), glyph.width(), glyph.height()};
}

}  // namespace

void GlyphPainter::ask_ahead(const Image<Srgb8>& picture, const GlyphCoverage& glyph, int pen,
                             int baseline) {
  const PictureRect area = clipped(box_of(glyph, pen, baseline), picture.width(), picture.height());
  for (int y = area.y; y < area.y + area.height; ++y) {
    hwy::Prefetch(picture.row(y) + area.x);
    if (area.width > 8) hwy::Prefetch(picture.row(y) + area.x + area.width - 1);
  }
}

void GlyphPainter::draw(Image<Srgb8>& picture, const GlyphCoverage& glyph, int pen, int baseline,
                        Srgb8 ink) {
  const PictureRect box = box_of(glyph, pen, baseline);
  const PictureRect area = clipped(box, picture.width(), picture.height());
  const bool cut = !(area == box);
  const LinearRgba light = decode(ink);
  const Mixture* on = nullptr;
  bool any = false;
  for (const GlyphCoverage::Run& run : glyph.runs()) {
    int x = box.x + run.x, length = run.length;
    const int y = box.y + run.y;
    if (cut) {
      const int end = std::min(x + length, area.x + area.width);
      x = std::max(x, area.x);
      if (y < area.y || y >= area.y + area.height || x >= end) continue;
      length = end - x;
    }
    Srgb8* const row = picture.row(y) + x;
    if (run.whole && ink.a == 255) {
      std::fill_n(row, length, ink);
      continue;
    }
    if (!std::exchange(any, true)) on = mixture(*row, ink);
    const std::uint8_t* const coverage = glyph.at(x - box.x, run.y);
    for (int i = 0; i < length; ++i) {
      if (on && word(row[i]) == on->ground) {
        row[i] = on->mixed[coverage[i]];
      } else {
        lay(row[i], light, coverage[i]);
      }
    }
  }
}

}  // namespace kinescope
