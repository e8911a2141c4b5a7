#include "demos/pen_chart.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/beam_chart.h"
#include "demos/ui/theme.h"

namespace kinescope {
namespace {

constexpr Seconds kBefore = microseconds(0.5), kAfter = microseconds(1.5);

glm::vec2 on_face(Place place, const Rect& face) {
  return {face.x + 0.5f * static_cast<float>(place.x + 1) * face.width,
          face.y + 0.5f * static_cast<float>(place.y + 1) * face.height};
}

}  // namespace

Exposure PenChart::shown(Seconds tripped) { return {tripped - kBefore, tripped + kAfter}; }

void PenChart::draw_view(Canvas& canvas, const Rect& face, bool pressed) const {
  const TubeSettings& tube = pen.tube();
  const PixelsAMm scale =
      pixels_a_mm(tube.glass, static_cast<int>(face.width), static_cast<int>(face.height));
  const glm::vec2 axis = on_face(pen.settings().place, face);
  const float radius =
      std::max(2.0f, 0.5f * static_cast<float>(pen.settings().view_mm * scale.across));
  const float width = std::max(1.0f, face.height / 500);
  const Srgb8 colour = pressed ? theme::kAccent : theme::kCool;
  const float far = radius + 2 * width;
  canvas.frame({axis.x - far, axis.y - far, 2 * far, 2 * far}, width, colour, far);
  canvas.line({axis.x + far, axis.y + far}, {axis.x + 5 * far, axis.y + 9 * far}, 3 * width,
              theme::with_alpha(colour, 160));
  if (!sight) return;
  const SyncTiming &h = tube.mode.horizontal, &v = tube.mode.vertical;
  const glm::vec2 told = on_face({2 * (sight->address.pixel + 0.5) / h.active - 1,
                                  2 * (sight->address.line + 0.5) / v.active - 1},
                                 face);
  canvas.line({told.x - far, told.y}, {told.x + far, told.y}, width, theme::kRed);
  canvas.line({told.x, told.y - far}, {told.x, told.y + far}, width, theme::kRed);
}

void PenChart::draw_curve(Canvas& canvas, const Rect& plot) const {
  const Exposure span = shown(sight->tripped);
  const double threshold = pen.settings().threshold;
  double most = 1.3 * threshold;
  for (const LightPen::Sample& s : sight->signal) most = std::max(most, s.signal);
  const double least = -0.3 * most;
  const auto place = [&](Seconds time, double signal) -> glm::vec2 {
    return {plot.x + static_cast<float>((time - span.begin) / span.length()) * plot.width,
            plot.bottom() -
                static_cast<float>((std::max(signal, least) - least) / (1.05 * most - least)) *
                    plot.height};
  };
  std::vector<glm::vec2> curve;
  if (!sight->signal.empty()) curve.push_back(place(span.begin, sight->signal.front().signal));
  for (const LightPen::Sample& s : sight->signal) curve.push_back(place(s.time, s.signal));
  const float width = std::max(1.0f, plot.height / 60);
  canvas.line(place(span.begin, 0), place(span.end, 0), 1, theme::kRule);
  canvas.dashed(place(span.begin, threshold), place(span.end, threshold), width, 4 * width,
                3 * width, theme::kDim);
  if (curve.size() > 1) canvas.polyline(curve, 1.5f * width, theme::kCool);
  canvas.disc(place(sight->tripped, threshold), 3 * width, theme::kRed);
}

void PenChart::draw_signal(Canvas& canvas, const Rect& room) const {
  canvas.fill(room, theme::with_alpha(theme::kPanel, 222), room.height * 0.06f);
  const Rect inside = room.shrunk(room.height * 0.1f);
  const float size = inside.height * 0.15f;
  const Rect plot{inside.x, inside.y, inside.width * 0.5f, inside.height};
  const float x = plot.right() + size;
  if (!sight) {
    canvas.text(studio.sans, {x, inside.y + size}, "no light seen", size, theme::kDim);
    return;
  }
  draw_curve(canvas, plot);
  const RasterScan& scan = pen.scan();
  const Seconds frame = scan.line_start(sight->address.frame, 0);
  const std::array rows = {fmt::format("tripped at {}", time_text(sight->tripped - frame)),
                           fmt::format("delay {}", time_text(pen.delay())),
                           fmt::format("line {}", sight->address.line),
                           fmt::format("pixel {}", sight->address.pixel)};
  float y = inside.y + size;
  for (const std::string& row : rows) {
    canvas.text(studio.sans, {x, y}, row, size, theme::kText);
    y += 1.55f * size;
  }
}

}  // namespace kinescope
