#include "display/vector/input/drawing.h"

#include <algorithm>
#include <utility>

namespace kinescope {

VectorDrawing part_of(const VectorDrawing& whole, std::size_t s0, std::size_t s1, std::size_t t0,
                      std::size_t t1) {
  const auto at = [](auto& list, std::size_t i) {
    return list.begin() + static_cast<std::ptrdiff_t>(i);
  };
  VectorDrawing out;
  out.origin = whole.origin;
  out.size = whole.size;
  out.segments.assign(at(whole.segments, s0), at(whole.segments, s1));
  out.texts.assign(at(whole.texts, t0), at(whole.texts, t1));
  for (DrawnText& text : out.texts) text.segments -= s0;
  for (const VectorDrawing::PenChange& change : whole.pens) {
    if (change.segments >= s1 && change.segments > s0) break;
    const std::size_t before = change.segments > s0 ? change.segments - s0 : 0;
    if (!out.pens.empty() && out.pens.back().segments == before) out.pens.pop_back();
    out.pens.push_back({before, change.pen});
  }
  return out;
}

void VectorDrawing::use(const VectorPen& pen) {
  if (pens.empty() ? pen == VectorPen{} : pens.back().pen == pen) return;
  if (!pens.empty() && pens.back().segments == segments.size()) {
    pens.back().pen = pen;
  } else {
    pens.push_back({segments.size(), pen});
  }
}

void VectorDrawing::clear() {
  const VectorPen pen = pens.empty() ? VectorPen{} : pens.back().pen;
  segments.clear();
  pens.clear();
  texts.clear();
  events.clear();
  use(pen);
}

std::vector<VectorDrawing> pages(VectorDrawing drawing) {
  std::vector<VectorDrawing> out;
  const bool one_page =
      std::all_of(drawing.events.begin(), drawing.events.end(), [](const DrawingEvent& event) {
        return event.kind != DrawingEvent::Kind::kErase || event.segments + event.texts == 0;
      });
  if (one_page) {  // the usual: not copied
    if (!drawing.segments.empty() || !drawing.texts.empty()) out.push_back(std::move(drawing));
    return out;
  }
  std::size_t segments = 0, texts = 0;
  const auto add = [&](std::size_t s1, std::size_t t1) {
    if (s1 > segments || t1 > texts) out.push_back(part_of(drawing, segments, s1, texts, t1));
    segments = s1;
    texts = t1;
  };
  for (const DrawingEvent& event : drawing.events) {
    if (event.kind == DrawingEvent::Kind::kErase) add(event.segments, event.texts);
  }
  add(drawing.segments.size(), drawing.texts.size());
  return out;
}

}  // namespace kinescope
