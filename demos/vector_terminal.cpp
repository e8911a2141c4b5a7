#include "demos/vector_terminal.h"

#include <algorithm>

namespace kinescope {
namespace {

/// A page that holds nothing is a page too.
VectorDrawing since_last_erasure(VectorDrawing drawing) {
  const auto erases = [](const DrawingEvent& e) { return e.kind == DrawingEvent::Kind::kErase; };
  const auto last = std::find_if(drawing.events.rbegin(), drawing.events.rend(), erases);
  if (last == drawing.events.rend()) {
    drawing.events.clear();
    return drawing;
  }
  const bool empty =
      last->segments == drawing.segments.size() && last->texts == drawing.texts.size();
  VectorDrawing page = empty ? VectorDrawing{} : pages(drawing).back();
  if (!drawing.pens.empty()) page.use(drawing.pens.back().pen);
  return page;
}

}  // namespace

bool VectorTerminal::poll(int milliseconds) {
  bytes_.clear();
  if (device_.read(bytes_, milliseconds) == 0) return false;
  reader_.read(bytes_, drawing_);
  reader_.flush(drawing_);
  drawing_ = since_last_erasure(std::move(drawing_));
  device_.write(reader_.take_replies());
  return true;
}

void VectorTerminal::press(char key, int x, int y) {
  reader_.press(key, x, y);
  device_.write(reader_.take_replies());
}

}  // namespace kinescope
