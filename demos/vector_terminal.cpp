#include "demos/vector_terminal.h"

#include <algorithm>
#include <array>
#include <utility>

#include "display/vector/input/read_vectors.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// What was drawn from those counts on, with its events.
VectorDrawing since(const VectorDrawing& drawing, std::size_t segments, std::size_t texts) {
  VectorDrawing out =
      part_of(drawing, segments, drawing.segments.size(), texts, drawing.texts.size());
  out.events = drawing.events;
  for (DrawingEvent& event : out.events) {
    event.segments -= segments;
    event.texts -= texts;
  }
  return out;
}

/// A page that holds nothing is a page too.
VectorDrawing since_last_erasure(VectorDrawing drawing) {
  const auto erases = [](const DrawingEvent& e) { return e.kind == DrawingEvent::Kind::kErase; };
  const auto last = std::find_if(drawing.events.rbegin(), drawing.events.rend(), erases);
  if (last == drawing.events.rend()) {
    drawing.events.clear();
    return drawing;
  }
  VectorDrawing page =
      part_of(drawing, last->segments, drawing.segments.size(), last->texts, drawing.texts.size());
  if (!drawing.pens.empty()) page.use(drawing.pens.back().pen);
  return page;
}

}  // namespace

bool VectorTerminal::poll(int milliseconds, const Copier& copier) {
  std::vector<std::uint8_t> bytes;
  if (device_.read(bytes, milliseconds) == 0) {
    left_ = left_ || device_.finished();
    return false;
  }
  recognise(bytes);
  if (stores()) {
    draw(bytes, copier);
    device_.write(reader_.take_replies());
  } else {
    whole_.insert(whole_.end(), bytes.begin(), bytes.end());
    read_whole();
  }
  return true;
}

/// Another user may send another kind. A plotter goes on on the same sheet.
void VectorTerminal::recognise(std::span<const std::uint8_t> bytes) {
  const bool anew = std::exchange(left_, false);
  if (kind_ && !anew) return;
  const auto before = kind_;
  kind_ = asked_ ? asked_ : recognise_vectors(bytes);
  if (!kind_) kind_ = before.value_or(VectorKind::kTek);
  if (kind_ != before || (!stores() && kind_ != VectorKind::kHpgl)) {
    whole_.clear();
    drawing_ = news_ = {};
  }
}

void VectorTerminal::draw(std::span<const std::uint8_t> bytes, const Copier& copier) {
  const std::size_t segments = drawing_.segments.size(), texts = drawing_.texts.size();
  reader_.read(bytes, drawing_);
  reader_.flush(drawing_);
  news_ = since(drawing_, segments, texts);
  copy(copier);
  drawing_ = since_last_erasure(std::move(drawing_));
}

void VectorTerminal::copy(const Copier& copier) const {
  std::size_t segments = 0, texts = 0;  // drawn before the page
  for (const DrawingEvent& event : drawing_.events) {
    if (event.kind == DrawingEvent::Kind::kErase) {
      segments = event.segments, texts = event.texts;
    } else if (event.kind == DrawingEvent::Kind::kHardCopy) {
      copier(part_of(drawing_, segments, event.segments, texts, event.texts));
    }
  }
}

/// The plot so far is read again from its beginning: scales and the window's frame may have
/// changed.
void VectorTerminal::read_whole() {
  constexpr std::size_t kMostBytes = 1 << 24;
  if (whole_.size() > kMostBytes) whole_.clear();
  try {
    InputFile input(whole_, device_.name());
    auto all = pages(read_vectors(input, kind_));
    drawing_ = all.empty() ? VectorDrawing{} : std::move(all.back());
  } catch (const Error&) {
    // It has not come whole yet.
  }
}

void VectorTerminal::press(char key, int x, int y) {
  reader_.press(key, x, y);
  device_.write(reader_.take_replies());
}

void VectorTerminal::page() {
  whole_.clear();
  constexpr std::array<std::uint8_t, 2> kPage{0x1b, 0x0c};
  if (stores()) return draw(kPage, [](const VectorDrawing&) {});
  drawing_ = {};
}

}  // namespace kinescope
