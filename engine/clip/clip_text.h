// Text clipped in the textbook's three ways.
#pragma once

#include <span>
#include <vector>

#include "engine/clip/clip_window.h"
#include "engine/clip/liang_barsky.h"
#include "engine/clip/region.h"
#include "engine/clip/sutherland_hodgman.h"

namespace kinescope {

/// A character where it stands in the window's plane: its cell, and what it is drawn of.
struct PlacedGlyph {
  ClipWindow cell;
  std::vector<Contour> outlines;  ///< filled, holes among them
  std::vector<Segment2> strokes;  ///< of stroke fonts
};

enum class TextClipping {
  kWholeString,      ///< all or none of the string
  kWholeCharacters,  ///< all or none of each character
  kComponents,       ///< each outline and stroke by itself
};

inline bool holds(const ClipWindow& window, const ClipWindow& cell) {
  return window.contains(cell.min) && window.contains(cell.max);
}

/// Calls sink(PlacedGlyph) for what is left of each character; those of which nothing is are passed
/// over.
template <typename Sink>
void clip_text(const ClipWindow& window, std::span<const PlacedGlyph> string, TextClipping way,
               Sink&& sink) {
  if (way == TextClipping::kWholeString) {
    for (const PlacedGlyph& glyph : string) {
      if (!holds(window, glyph.cell)) return;
    }
  }
  for (const PlacedGlyph& glyph : string) {
    if (way != TextClipping::kComponents && holds(window, glyph.cell)) {
      sink(glyph);
      continue;
    }
    if (way != TextClipping::kComponents) continue;
    PlacedGlyph left{glyph.cell, {}, {}};
    for (const Contour& outline : glyph.outlines) {
      Contour part = clip_polygon(window, outline);
      if (!part.empty()) left.outlines.push_back(std::move(part));
    }
    for (const Segment2& stroke : glyph.strokes) {
      if (const auto part = clip_liang_barsky(window, stroke)) left.strokes.push_back(*part);
    }
    if (!left.outlines.empty() || !left.strokes.empty()) sink(left);
  }
}

}  // namespace kinescope
