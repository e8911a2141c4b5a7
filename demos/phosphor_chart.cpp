#include "demos/phosphor_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "demos/beam_chart.h"
#include "demos/ui/theme.h"
#include "demos/ui/widgets.h"

namespace kinescope {
namespace {

constexpr int kFirstDecade = -7, kLastDecade = 2;  // of time, seconds
constexpr int kLeastDecade = -5;                   // of brightness
constexpr int kSamplesADecade = 12;
constexpr std::array kLevels = {"10 %", "1 %", "0.1 %"};

float text_size(const Rect& room) { return std::min(room.height / 30, room.width / 40); }

float across(const Rect& plot, double seconds) {
  const double share = (std::log10(seconds) - kFirstDecade) / (kLastDecade - kFirstDecade);
  return plot.x + plot.width * static_cast<float>(share);
}

float down(const Rect& plot, double brightness) {
  return plot.y + plot.height * static_cast<float>(std::log10(brightness) / kLeastDecade);
}

std::string decade_text(int decade) {
  constexpr std::array kUnits = {"µs", "ms", "s"};
  const int unit = decade < -3 ? 0 : decade < 0 ? 1 : 2;
  return fmt::format("{:g} {}", std::pow(10.0, decade + 6 - 3 * unit),
                     kUnits[static_cast<std::size_t>(unit)]);
}

/// "305 µs", "5.7 ms"
std::string short_time(Seconds t) {
  const int decade = static_cast<int>(std::floor(std::log10(t.count()) + 1e-9));
  const int unit = decade < -3 ? 0 : decade < 0 ? 1 : 2;
  constexpr std::array kUnits = {"µs", "ms", "s"};
  return fmt::format("{:.3g} {}", t.count() * std::pow(10.0, 6 - 3 * unit),
                     kUnits[static_cast<std::size_t>(unit)]);
}

Seconds time_to(double level, const FlashedSpot& spot) {
  double low = kFirstDecade - 3, high = kLastDecade + 2;  // powers of ten
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (spot.brightness(Seconds(std::pow(10, middle))) > level ? low : high) = middle;
  }
  return Seconds(std::pow(10, low));
}

/// The colour with its largest channel at 1.
LinearRgb bright(LinearRgb colour) {
  const float most = std::max({colour.r, colour.g, colour.b});
  const auto channel = [&](float v) { return std::clamp(v / most, 0.0f, 1.0f); };
  return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

/// Whole pixels, without the price of smooth corners.
void fill_plain(Image<Srgb8>& picture, const Rect& rect, Srgb8 colour) {
  const auto pixel = [](float v, int most) { return std::clamp(static_cast<int>(v), 0, most); };
  const int left = pixel(rect.x, picture.width()), right = pixel(rect.right(), picture.width());
  for (int y = pixel(rect.y, picture.height()); y < pixel(rect.bottom(), picture.height()); ++y) {
    std::fill_n(picture.row(y) + left, right - left, colour);
  }
}

/// Lines of text from a pen that moves down; what does not fit is left out.
class Lines {
 public:
  Lines(Canvas& canvas, const Studio& studio, const Rect& room, float size)
      : canvas_(canvas), studio_(studio), room_(room), size_(size), y_(room.y + size) {}

  void line(std::string_view left, Srgb8 colour, std::string_view right = {}, float scale = 1) {
    if (y_ > room_.bottom()) return;
    canvas_.text(studio_.sans, {room_.x, y_}, left, size_ * scale, colour);
    canvas_.text(studio_.sans, {room_.right(), y_}, right, size_ * scale, theme::kText,
                 Align::kRight);
    y_ += 1.45f * size_ * scale;
  }
  void paragraph(std::string_view text, float scale) {
    for (const std::string& part : wrap(studio_.sans, text, size_ * scale, room_.width)) {
      line(part, theme::kDim, {}, scale);
    }
  }
  void gap() { y_ += 0.45f * size_; }
  void swatch(Srgb8 colour) {
    const float side = 0.8f * size_;
    canvas_.fill({room_.x, y_ - side, side, side}, colour, side * 0.2f);
  }

 private:
  Canvas& canvas_;
  const Studio& studio_;
  Rect room_;
  float size_, y_;
};

}  // namespace

Srgb8 visible_colour(LinearRgb hue) {
  const float grey = 0.08f;
  return encode_srgb8(LinearRgb{hue.r + (1 - hue.r) * grey, hue.g + (1 - hue.g) * grey,
                                hue.b + (1 - hue.b) * grey});
}

void draw_patch(Image<Srgb8>& picture, const Studio& studio, const Rect& cell,
                std::string_view name, Srgb8 light, bool chosen) {
  const float most = theme::kBody * 1.3f * theme::scale_for(picture.height());
  const float size = std::min({cell.height * 0.16f, cell.width * 0.14f, most});
  const Rect outer =
      Rect{cell.x, cell.y, cell.width, cell.height - 1.3f * size}.shrunk(size * 0.25f);
  fill_plain(picture, outer, chosen ? theme::kAccent : theme::kKeyCap);
  fill_plain(picture, outer.shrunk(std::max(1.0f, size * 0.12f)), light);
  Canvas(picture).text(studio.sans, {cell.x + cell.width * 0.5f, cell.bottom() - 0.35f * size},
                       name, size, chosen ? theme::kAccent : theme::kText, Align::kCentre);
}

void PhosphorChart::draw_grid(Canvas& canvas, const Rect& plot, float size) const {
  for (int decade = kFirstDecade; decade <= kLastDecade; ++decade) {
    const float x = across(plot, std::pow(10.0, decade));
    canvas.line({x, plot.y}, {x, plot.bottom()}, 1, theme::kRule);
    canvas.text(studio.sans, {x, plot.bottom() + 1.4f * size}, decade_text(decade), size,
                theme::kDim, Align::kCentre);
  }
  for (int decade = 0; decade >= kLeastDecade; --decade) {
    const double level = std::pow(10.0, decade);
    const float y = down(plot, level);
    canvas.line({plot.x, y}, {plot.right(), y}, 1, theme::kRule);
    canvas.text(studio.sans, {plot.x - 0.6f * size, y + 0.35f * size},
                fmt::format("{:g} %", 100 * level), size, theme::kDim, Align::kRight);
  }
}

void PhosphorChart::draw_curve(Canvas& canvas, const Rect& plot, const FlashedType& flashed) const {
  const bool front = flashed.type == chosen;
  const float width = (front ? 2.6f : 1.3f) * std::max(0.5f, plot.height / 400);
  const double least = std::pow(10.0, kLeastDecade);
  glm::vec2 last{};
  for (int i = 0; i <= (kLastDecade - kFirstDecade) * kSamplesADecade; ++i) {
    const Seconds t(std::pow(10.0, kFirstDecade + static_cast<double>(i) / kSamplesADecade));
    const double brightness = flashed.spot.brightness(t);
    const glm::vec2 place{across(plot, t.count()), down(plot, std::max(brightness, 1e-3 * least))};
    if (i > 0) {
      const Srgb8 colour = visible_colour(flashed.spot.hue(t));
      canvas.line(last, place, width, theme::with_alpha(colour, front ? 255 : 120));
    }
    if (brightness < least) return;
    last = place;
  }
}

void PhosphorChart::draw_points(Canvas& canvas, const Rect& plot,
                                const FlashedType& flashed) const {
  const float radius = (flashed.type == chosen ? 4.5f : 2.4f) * std::max(0.5f, plot.height / 400);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!flashed.type->times[k]) continue;
    const double level = std::pow(10.0, -(static_cast<double>(k) + 1));
    const glm::vec2 place{across(plot, flashed.type->times[k]->count()), down(plot, level)};
    canvas.disc(place, radius, theme::kBackground);
    const LinearRgb hue = flashed.type->layers.back().colour;
    canvas.disc(place, radius * 0.72f,
                flashed.type == chosen ? theme::kText : visible_colour(bright(hue)));
  }
}

void PhosphorChart::draw_curves(Canvas& canvas, const Rect& room, Seconds now,
                                Seconds again) const {
  const float size = text_size(room);
  canvas.text(studio.sans, {room.x, room.y + size},
              "brightness after the excitation has ended, as a share of what it was", size,
              theme::kText);
  canvas.text(studio.sans, {room.right() - 2 * size, room.y + size},
              now.count() > 0 ? time_text(now) : "excited", size, theme::kAccent, Align::kRight);
  const Rect plot{room.x + 5 * size, room.y + 2.2f * size, room.width - 7 * size,
                  room.height - 4.2f * size};
  if (plot.width <= 0 || plot.height <= 0) return;
  draw_grid(canvas, plot, size);
  const float next = across(plot, again.count());
  canvas.dashed({next, plot.y}, {next, plot.bottom()}, 1, 0.5f * size, 0.5f * size, theme::kAccent);
  const Rect clip = canvas.clip();
  canvas.set_clip({plot.x, plot.y - size, plot.width, plot.height + size});
  for (const bool front : {false, true}) {
    for (const FlashedType& flashed : types) {
      if ((flashed.type == chosen) == front) draw_curve(canvas, plot, flashed);
    }
  }
  for (const FlashedType& flashed : types) {
    if (points || flashed.type == chosen) draw_points(canvas, plot, flashed);
  }
  if (now.count() > std::pow(10.0, kFirstDecade)) {
    const float x = across(plot, now.count());
    canvas.line({x, plot.y}, {x, plot.bottom()}, 1.5f, theme::kAccent);
  }
  canvas.set_clip(clip);
}

void PhosphorChart::draw_words(Canvas& canvas, const Rect& room) const {
  if (chosen == nullptr) return;
  const float size = std::min(room.height / 21, room.width / 23);
  Lines lines(canvas, studio, room, size);
  lines.line(chosen->name, theme::kAccent, {}, 1.35f);
  lines.line(chosen->about, theme::kText);
  lines.gap();
  lines.line("after continuous excitation", theme::kDim);
  const FlashedSpot steady(*chosen, {Seconds(0), true});
  for (std::size_t k = 0; k < 3; ++k) {
    const Seconds found = time_to(std::pow(10.0, -(static_cast<double>(k) + 1)), steady);
    const auto& times = chosen->times[k];
    lines.line(fmt::format("to {}", kLevels[k]), theme::kDim,
               times ? fmt::format("{}, table {}", short_time(found), short_time(*times))
                     : short_time(found));
  }
  lines.line("luminance", theme::kDim,
             chosen->luminance ? fmt::format("{:g}, P31 = 100", *chosen->luminance) : "not known");
  lines.gap();
  for (const Phosphor& layer : chosen->layers) {
    lines.swatch(visible_colour(bright(layer.colour)));
    lines.line(fmt::format("     {}", chosen->layers.size() > 1 ? layer.name : "one layer"),
               theme::kText,
               fmt::format("{} term{}", layer.terms.size(), layer.terms.size() > 1 ? "s" : ""));
  }
  lines.gap();
  lines.paragraph(chosen->source, 0.85f);
}

}  // namespace kinescope
