#include "raster/characters/glyph_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "raster/fill/scanline_fill.h"

namespace kinescope {
namespace {

constexpr float kTolerancePx = 1.0f / 512;
constexpr PixelsFromPath kUnchanged{1, 0, 0, 1, 0, 0};

}  // namespace

GlyphScan::GlyphScan(const Path& outline, const PixelsFromPath& place, int width, int height)
    : path_(outline), place_(place), pixels_(width, height, GlyphPixel::kOff) {}

void GlyphScan::scale() {
  for (glm::vec2& p : path_.points) p = place_ * glm::vec3(p, 1);
}

// Top and bottom move to whole rows, and what lies between them in proportion, so that level
// strokes keep their height: the least that hinting does.
void GlyphScan::fit() {
  float top = std::numeric_limits<float>::max(), bottom = -top;
  for (const glm::vec2 p : path_.points) {
    if (!std::isfinite(p.y)) continue;
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  if (!(top < bottom)) return;
  const float new_top = std::floor(top + 0.5f);
  const float new_bottom = std::max(std::floor(bottom + 0.5f), new_top + 1);
  const float factor = (new_bottom - new_top) / (bottom - top);
  for (glm::vec2& p : path_.points) p.y = new_top + (p.y - top) * factor;
}

void GlyphScan::skip_fitting() {
  if (step_ == Step::kNone) scale();
  step_ = Step::kFit;
}

/// Calls sink(line, first centre inside, first centre behind, whether that lies on the outline) for
/// each stretch inside, row by row or column by column.
template <typename Sink>
void GlyphScan::stretches(bool columns, Sink&& sink) const {
  const int width = pixels_.width(), height = pixels_.height();
  ScanlineFill scan(columns ? PixelRect{0, 0, height, width} : PixelRect{0, 0, width, height},
                    FillRule::kNonZero);
  path_edges(path_, kUnchanged, kTolerancePx, [&](glm::dvec2 a, glm::dvec2 b) {
    columns ? scan.add_edge({a.y, a.x}, {b.y, b.x}) : scan.add_edge(a, b);
  });
  while (scan.next()) {
    int winding = 0, entered = 0;
    for (std::size_t i = 0; i < scan.active_count(); ++i) {
      const ActiveEdge& edge = scan.active(i);
      if (winding == 0) entered = edge.column;
      winding += edge.direction;
      if (winding == 0) sink(scan.y(), entered, edge.column, edge.remainder == 0);
    }
  }
}

// Rule 1: centres inside or on the outline. Edges own the centres on one side of a shape only;
// those on the other side are found as the ends of rows and of columns.
void GlyphScan::fill() {
  for (const bool columns : {false, true}) {
    const int length = columns ? pixels_.height() : pixels_.width();
    stretches(columns, [&](int line, int begin, int end, bool on_outline) {
      const int last = std::min(end + on_outline, length);
      for (int i = std::max(begin, 0); i < last; ++i) {
        (columns ? pixels_.at(line, i) : pixels_.at(i, line)) = GlyphPixel::kInside;
      }
    });
  }
}

// Rules 2 and 3: where the outline is entered and left between the same two centres, and neither
// pixel is on, the left one (of a column the lower one) is lit.
void GlyphScan::mend(bool columns) {
  stretches(columns, [&](int line, int begin, int end, bool) {
    if (begin != end) return;
    const glm::ivec2 first = columns ? glm::ivec2(line, end - 1) : glm::ivec2(end - 1, line);
    const glm::ivec2 second = columns ? glm::ivec2(line, end) : glm::ivec2(end, line);
    const auto is_there = [&](glm::ivec2 p) { return pixels_.contains(p.x, p.y); };
    const auto is_on = [&](glm::ivec2 p) {
      return is_there(p) && pixels_.at(p.x, p.y) != GlyphPixel::kOff;
    };
    if (is_on(first) || is_on(second)) return;
    glm::ivec2 lit = columns ? second : first;
    if (!is_there(lit)) lit = columns ? first : second;
    if (!is_there(lit)) return;
    pixels_.at(lit.x, lit.y) = columns ? GlyphPixel::kDropoutColumn : GlyphPixel::kDropoutRow;
  });
}

bool GlyphScan::next() {
  switch (step_) {
    case Step::kNone:
      scale();
      step_ = Step::kScale;
      return true;
    case Step::kScale:
      fit();
      step_ = Step::kFit;
      return true;
    case Step::kFit:
      fill();
      step_ = Step::kFill;
      return true;
    case Step::kFill:
      mend(false);
      mend(true);
      step_ = Step::kDropout;
      return true;
    case Step::kDropout:
      break;
  }
  return false;
}

}  // namespace kinescope
