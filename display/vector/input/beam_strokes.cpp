#include "display/vector/input/beam_strokes.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "display/vector/input/stroke_font.h"

namespace kinescope {
namespace {

/// Lengths of dash, gap, dash, gap as shares of the picture's width. The manuals give the dashes as
/// pictures only; these are taken so that the kinds are told apart.
constexpr float kDash = 1.0f / 128, kGap = 1.0f / 256, kDot = 1.0f / 1024;
using Pattern = std::array<float, 4>;
Pattern pattern_of(LineStyle style) {
  switch (style) {
    case LineStyle::kDotted:
      return {kDot, kGap, kDot, kGap};
    case LineStyle::kDotDash:
      return {kDash, kGap, kDot, kGap};
    case LineStyle::kShortDash:
      return {kDash / 2, kGap, kDash / 2, kGap};
    case LineStyle::kLongDash:
      return {kDash * 2, kGap, kDash * 2, kGap};
    case LineStyle::kSolid:
      break;
  }
  return {1, 0, 1, 0};
}

/// Breaks lines; a line that goes on where the last ended goes on in its pattern.
class Dasher {
 public:
  explicit Dasher(float unit) : unit_(unit) {}
  void start(LineStyle style) {
    pattern_ = pattern_of(style);
    at_ = 0;
    left_ = pattern_[0] * unit_;
  }
  void draw(const VectorSegment& s, VectorDrawing& to) {
    const glm::vec2 from{s.x1, s.y1}, end{s.x2, s.y2};
    if (from != last_) {
      at_ = 0;
      left_ = pattern_[0] * unit_;
    }
    last_ = end;
    const float length = glm::length(end - from);
    // No screen shows a million dashes on one line.
    if (!(length > 0) || length > 1e4f * unit_) return to.line(from, end, s.intensity);
    for (float done = 0; done < length;) {
      const float next = std::min(length, done + left_);
      if (at_ % 2 == 0) {
        to.line(from + (done / length) * (end - from), from + (next / length) * (end - from),
                s.intensity);
      }
      left_ -= next - done;
      if (next >= length) return;
      at_ = (at_ + 1) % pattern_.size();
      left_ = pattern_[at_] * unit_;
      done = next;
    }
  }

 private:
  float unit_;
  Pattern pattern_{};
  std::size_t at_ = 0;
  float left_ = 0;
  glm::vec2 last_{NAN, NAN};
};

bool finite(const VectorSegment& s) { return std::isfinite(s.x1 + s.y1 + s.x2 + s.y2); }

class Strokes {
 public:
  explicit Strokes(const VectorDrawing& drawing) : in_(drawing), dasher_(drawing.size.x) {
    out_.origin = drawing.origin;
    out_.size = drawing.size;
    out_.segments.reserve(drawing.segments.size());
  }
  void run(const VectorPen& pen, std::size_t first, std::size_t last) {
    dasher_.start(pen.style);
    for (std::size_t i = first; i < last; ++i) {
      if (texts_before(i) || i == first) use(pen);
      const VectorSegment& s = in_.segments[i];
      if (!finite(s)) continue;
      if (pen.style == LineStyle::kSolid) {
        out_.segments.push_back(s);
      } else {
        dasher_.draw(s, out_);
      }
    }
  }
  VectorDrawing finish() {
    texts_before(in_.segments.size());
    return std::move(out_);
  }

 private:
  /// Texts drawn before segment i. @return whether there were any
  bool texts_before(std::size_t i) {
    const std::size_t drawn = text_;
    for (; text_ < in_.texts.size() && in_.texts[text_].segments <= i; ++text_) {
      const DrawnText& text = in_.texts[text_];
      use(text.pen);
      for_each_text_stroke(text, [&](glm::vec2 from, glm::vec2 to) {
        const VectorSegment s{from.x, from.y, to.x, to.y, text.intensity};
        if (finite(s)) out_.segments.push_back(s);
      });
    }
    return text_ > drawn;
  }
  /// Strokes of their own are not broken any more.
  void use(VectorPen pen) {
    pen.style = LineStyle::kSolid;
    out_.use(pen);
  }

  const VectorDrawing& in_;
  VectorDrawing out_;
  Dasher dasher_;
  std::size_t text_ = 0;
};

}  // namespace

VectorDrawing beam_strokes(const VectorDrawing& drawing) {
  Strokes strokes(drawing);
  for_each_run(drawing, [&](const VectorPen& pen, std::size_t first, std::size_t last) {
    strokes.run(pen, first, last);
  });
  return strokes.finish();
}

}  // namespace kinescope
