#include "demos/vector_terminal.h"

#include <algorithm>
#include <utility>

#include "display/vector/input/hpgl_reader.h"
#include "raster/base/error.h"

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
  const bool plots = kind_ == VectorKind::kHpgl;
  if (!plots) bytes_.clear();
  if (device_.read(bytes_, milliseconds) == 0) return false;
  if (!kind_) kind_ = recognise_vectors(bytes_).value_or(VectorKind::kTek);
  if (kind_ == VectorKind::kHpgl) {
    plot();
    return true;
  }
  reader_.read(bytes_, drawing_);
  reader_.flush(drawing_);
  drawing_ = since_last_erasure(std::move(drawing_));
  device_.write(reader_.take_replies());
  return true;
}

/// The plot so far is read again from its beginning: scales and the window's frame may have
/// changed.
void VectorTerminal::plot() {
  constexpr std::size_t kMostBytes = 1 << 24;
  if (bytes_.size() > kMostBytes) bytes_.clear();
  try {
    auto all = pages(read_hpgl(bytes_, device_.name()));
    drawing_ = all.empty() ? VectorDrawing{} : std::move(all.back());
  } catch (const Error&) {
    // No instruction has come whole yet.
  }
}

void VectorTerminal::press(char key, int x, int y) {
  reader_.press(key, x, y);
  device_.write(reader_.take_replies());
}

}  // namespace kinescope
