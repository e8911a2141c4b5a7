#include "demos/beam_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "demos/ui/theme.h"

namespace kinescope {
namespace {

constexpr Srgb8 kActive = theme::kAccent, kBlanked = theme::kCool;

float size_of(const Rect& room) { return room.height * 0.062f; }

Srgb8 phase_colour(ScanPhase phase) {
  switch (phase) {
    case ScanPhase::kActive:
      return theme::kAccent;
    case ScanPhase::kFrontPorch:
      return theme::kGreen;
    case ScanPhase::kSync:
      return theme::kRed;
    case ScanPhase::kBackPorch:
      return theme::kCool;
  }
  return theme::kText;
}

glm::vec2 on_face(const BeamPosition& beam, const Rect& face) {
  return {face.x + static_cast<float>(beam.x) * face.width,
          face.y + static_cast<float>(beam.y) * face.height};
}

}  // namespace

std::string phase_name(ScanPhase phase) {
  switch (phase) {
    case ScanPhase::kActive:
      return "active";
    case ScanPhase::kFrontPorch:
      return "front porch";
    case ScanPhase::kSync:
      return "sync";
    case ScanPhase::kBackPorch:
      return "back porch";
  }
  return {};
}

std::string time_text(Seconds t) {
  const double us = t.count() * 1e6;
  if (std::abs(us) >= 1e6) return fmt::format("{:.3f} s", us * 1e-6);
  if (std::abs(us) >= 1e3) return fmt::format("{:.3f} ms", us * 1e-3);
  return fmt::format("{:.3f} \u00b5s", us);
}

/// The beam's way from one time to another: a solid line where it draws, dashes where it is
/// blanked.
void BeamChart::draw_span(Canvas& canvas, const Rect& face, Seconds from, Seconds to) const {
  const float scale = face.height / 720;
  const Seconds pixel = scan.mode().pixel_period();
  const Seconds step = scan.mode().line_period() / 160.0;
  // Dashes are tied to the path, not to this span, so that they do not crawl.
  int dash = static_cast<int>(std::floor(from / step));
  for (Seconds t = static_cast<double>(dash) * step; t < to; t += step, ++dash) {
    const Seconds t0 = std::max(t, from), t1 = std::min(t + step, to);
    if (t1 - t0 < 0.01 * pixel) continue;
    const BeamPosition a = scan.at(t0), b = scan.at(t1 - 0.001 * pixel);
    if (a.blanked && dash % 4 >= 2) continue;
    // The many lines of a vertical retrace are fainter than the one of a horizontal.
    const std::uint8_t alpha = !a.blanked ? 70 : a.vertical == ScanPhase::kActive ? 160 : 80;
    canvas.line(on_face(a, face), on_face(b, face), 1.2f * scale,
                theme::with_alpha(a.blanked ? kBlanked : kActive, alpha));
  }
}

void BeamChart::draw_path(Canvas& canvas, const Rect& face) const {
  const float scale = face.height / 720;
  const VideoMode& mode = scan.mode();
  const BeamPosition beam = scan.at(end);
  const Seconds line = mode.line_period();
  const Seconds line_begin = end - (beam.pixel / mode.horizontal.total()) * line;
  if (beam.vertical == ScanPhase::kActive) {
    draw_span(canvas, face, line_begin, line_begin + line);
  } else {
    draw_span(canvas, face, scan.retrace_start(beam.frame, beam.field),
              scan.line_start(beam.frame + (beam.field + 1) / (mode.interlaced ? 2 : 1), 0));
  }
  const glm::vec2 place = on_face(beam, face);
  if (beam.blanked) {
    const float radius = 6 * scale;
    canvas.frame({place.x - radius, place.y - radius, 2 * radius, 2 * radius}, 1.8f * scale,
                 kBlanked, radius);
  } else {
    canvas.disc(place, 4 * scale, kActive);
  }
}

/// One deflection against time: grey the whole period, coloured by phase, a cursor at the beam.
void BeamChart::draw_wave(Canvas& canvas, const Rect& room, bool across) const {
  const VideoMode& mode = scan.mode();
  const float size = size_of(room) * 1.35f;
  const Seconds period = across ? mode.line_period() : mode.frame_period();
  const BeamPosition now = scan.at(end);
  const double passed = across ? now.pixel / mode.horizontal.total()
                               : now.field_line / mode.vertical.total() * (mode.interlaced ? 2 : 1);
  const Seconds first = end - passed * period;
  canvas.text(studio.sans, {room.x, room.y + size},
              across ? "horizontal deflection, one line" : "vertical deflection, one frame", size,
              theme::kText);
  canvas.text(studio.sans, {room.right(), room.y + size}, time_text(period), size, theme::kDim,
              Align::kRight);
  const Rect plot{room.x, room.y + size * 1.7f, room.width, room.height - size * 1.7f};
  canvas.frame(plot, 1, theme::kRule, 3);
  const Rect inner = plot.shrunk(size * 0.5f);
  const int samples = std::max(1, static_cast<int>(inner.width / 2));
  glm::vec2 last{};
  for (int i = 0; i <= samples; ++i) {
    const double share = (static_cast<double>(i) + (i == samples ? -0.01 : 0.0)) / samples;
    const BeamPosition beam = scan.at(first + share * period);
    const double value = across ? beam.x : beam.y;
    const glm::vec2 place{inner.x + static_cast<float>(share) * inner.width,
                          inner.bottom() - static_cast<float>(value / 1.03) * inner.height};
    const Srgb8 colour = phase_colour(across ? beam.horizontal : beam.vertical);
    if (i > 0) canvas.line(last, place, 1.6f * size / 16, colour);
    last = place;
  }
  const float x = inner.x + static_cast<float>(passed) * inner.width;
  const double value = across ? now.x : now.y;
  canvas.line({x, plot.y}, {x, plot.bottom()}, 1, theme::with_alpha(theme::kText, 120));
  canvas.disc({x, inner.bottom() - static_cast<float>(value / 1.03) * inner.height}, size * 0.28f,
              theme::kText);
}

void BeamChart::draw_words(Canvas& canvas, const Rect& room) const {
  const BeamPosition beam = scan.at(end);
  const VideoMode& mode = scan.mode();
  const std::array<std::pair<std::string, std::string>, 7> rows = {{
      {"time", time_text(end)},
      {"exposure", time_text(end - begin)},
      {"frame", fmt::format("{}", beam.frame)},
      {"line",
       beam.vertical == ScanPhase::kActive
           ? fmt::format("{} of {}", beam.line, mode.vertical.active)
           : fmt::format("{:.0f} of {}", std::floor(beam.field_line), mode.vertical.total())},
      {"pixel", fmt::format("{:.0f} of {}", std::floor(beam.pixel), mode.horizontal.total())},
      {"across", phase_name(beam.horizontal)},
      {"down", phase_name(beam.vertical)},
  }};
  const float size = size_of(room) * 1.35f, row = room.height / static_cast<float>(rows.size());
  float y = room.y + size;
  for (const auto& [name, value] : rows) {
    Srgb8 colour = theme::kText;
    if (name == "across") colour = phase_colour(beam.horizontal);
    if (name == "down") colour = phase_colour(beam.vertical);
    canvas.text(studio.sans, {room.x, y}, name, size, theme::kDim);
    canvas.text(studio.sans, {room.x + size * 5.6f, y}, value, size, colour);
    y += row;
  }
}

void BeamChart::draw_charts(Canvas& canvas, const Rect& room) const {
  canvas.fill(room, theme::kBackground);
  const float margin = room.height * 0.09f;
  const Rect inside = room.shrunk(margin);
  // The line of state lies in the lower left corner: its height stays free.
  const float free = margin * 1.2f, words = inside.width * 0.24f;
  const float wave = (inside.width - words - 2 * margin) * 0.5f;
  const float height = inside.height - free;
  draw_words(canvas, {inside.x, inside.y, words, height});
  draw_wave(canvas, {inside.x + words, inside.y, wave, height}, true);
  draw_wave(canvas, {inside.x + words + wave + 2 * margin, inside.y, wave, height}, false);
}

}  // namespace kinescope
