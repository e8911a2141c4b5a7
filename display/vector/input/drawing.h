// What a reader of random-scan input decoded, in the order in which it was drawn.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "display/vector/segment.h"
#include "raster/colour/colour.h"

namespace kinescope {

/// How a stroke is broken; lengths of dashes are the device's.
enum class LineStyle { kSolid, kDotted, kDotDash, kShortDash, kLongDash };

/// What the strokes of a run have in common besides the beam's current.
struct VectorPen {
  Srgb8 colour{255, 255, 255, 255};  ///< on the tubes and plotters that have any
  float width = 0;                   ///< device units; 0: as thin as the device draws
  LineStyle style = LineStyle::kSolid;
  bool write_through = false;  ///< drawn on a storage tube without being stored
  bool defocused = false;
  bool operator==(const VectorPen&) const = default;
};

/// Characters that the device draws by itself.
struct DrawnText {
  std::string text;          ///< one byte a character, ASCII or Latin-1
  glm::vec2 place{0};        ///< left end of the base line
  glm::vec2 advance{0};      ///< from one character to the next
  glm::vec2 up{0};           ///< height of a capital, and which way up it is
  float intensity = 1;       ///< of its strokes
  std::size_t segments = 0;  ///< drawn before it
  VectorPen pen = {};        ///< that draws it, whatever its style in whole lines
};

/// What happens to the picture as a whole.
struct DrawingEvent {
  enum class Kind { kErase, kHardCopy, kBell };
  Kind kind = Kind::kErase;
  std::size_t segments = 0, texts = 0;  ///< drawn before it
};

/// A picture of strokes and characters. Device units: those of `size`, the origin at the lower
/// left.
struct VectorDrawing {
  struct PenChange {
    std::size_t segments = 0;  ///< drawn before it
    VectorPen pen;
  };

  glm::vec2 origin{0}, size{4096, 3120};  ///< of the area that the device shows
  std::vector<VectorSegment> segments;
  std::vector<PenChange> pens;  ///< in order of segments; before the first, a VectorPen{}
  std::vector<DrawnText> texts;
  std::vector<DrawingEvent> events;

  void line(glm::vec2 from, glm::vec2 to, float intensity = 1) {
    segments.push_back({from.x, from.y, to.x, to.y, intensity});
  }
  void use(const VectorPen& pen);
  void event(DrawingEvent::Kind kind) { events.push_back({kind, segments.size(), texts.size()}); }
  /// Forgets what was drawn; the pen stays.
  void clear();
};

/// Calls sink(pen, first, last) for each run of segments [first, last) drawn with one pen.
template <typename Sink>
void for_each_run(const VectorDrawing& drawing, Sink&& sink) {
  std::size_t first = 0;
  VectorPen pen;
  for (const VectorDrawing::PenChange& change : drawing.pens) {
    if (change.segments > first) sink(pen, first, change.segments);
    first = change.segments;
    pen = change.pen;
  }
  if (drawing.segments.size() > first) sink(pen, first, drawing.segments.size());
}

/// Segments [s0, s1) and texts [t0, t1), with the pens that drew them; without events.
VectorDrawing part_of(const VectorDrawing& whole, std::size_t s0, std::size_t s1, std::size_t t0,
                      std::size_t t1);

/// The pages of a drawing: what lies between erasures and holds anything.
std::vector<VectorDrawing> pages(VectorDrawing drawing);

}  // namespace kinescope
