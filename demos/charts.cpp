// Bar, line and pie charts of five values.
#include <fmt/format.h>

#include <array>
#include <numbers>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/figures/chart.h"
#include "raster/characters/bitmap_font.h"
#include "raster/fill/scanline_fill.h"
#include "raster/scan/thick_pen.h"

namespace kinescope {
namespace {

enum { kKind };
enum { kBars, kLine, kPie };
constexpr int kValues = 5;
constexpr std::array kInks = {theme::kCool, theme::kAccent, theme::kGreen, theme::kRed,
                              theme::kBlue};

class Charts : public ClonableDemo<Charts, Lesson> {
 public:
  explicit Charts(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "The same five values: bars compare them, a line shows their "
                         "course, a pie their shares. Move the sliders; a pie refuses what "
                         "is negative.",
             .figures = {{"a", 30, -20, 100, 1, false},
                         {"b", 55, -20, 100, 1, false},
                         {"c", 80, -20, 100, 1, false},
                         {"d", 45, -20, 100, 1, false},
                         {"e", 20, -20, 100, 1, false}},
             .resolution = 7,
             .speed = 1},
            {choice_knob("chart", {"1", "2", "3"}, {"bars", "line", "pie"}, kBars,
                         "which chart")}) {}

 private:
  std::vector<double> values() const {
    std::vector<double> values;
    for (int i = 0; i < kValues; ++i) values.push_back(figure(i));
    return values;
  }
  ChartFrame frame() const {
    const glm::dvec2 size(world().columns(), world().rows());
    return {size * 0.1, size * 0.88};
  }
  static Srgb8 ink(std::size_t i) { return kInks[i % kInks.size()]; }

  void fill(Track& track, const Contour& contour, Srgb8 colour) const {
    scanline_fill({contour}, FillRule::kNonZero, world().window(),
                  [&](const RowSpan& span) { track.span(span, colour); });
  }
  void write(Track& track, glm::dvec2 at, const std::string& words) const {
    const glm::ivec2 pen(static_cast<int>(at.x) - 3 * static_cast<int>(words.size()),
                         static_cast<int>(at.y));
    BitmapFont::fixed().draw(words, pen, [&](int x, int y) { track.plot(x, y, theme::kText); });
  }

  Course record() const override {
    Course course;
    const int kind = knob(kKind).index();
    course.tracks.push_back(kind == kBars ? bars() : kind == kLine ? line() : pie());
    return course;
  }

  void axis(Track& track, const std::vector<double>& values) const {
    const double zero = chart_scale(values).place(0, frame());
    ink_line(track, world(), {frame().low.x, zero}, {frame().high.x, zero}, theme::kDim);
    ink_line(track, world(), frame().low, {frame().low.x, frame().high.y}, theme::kDim);
  }

  Track bars() const {
    const std::vector<double> values = this->values();
    Track track("bars", {"value", "left", "top"});
    const auto rects = chart_bars(values, frame());
    for (std::size_t i = 0; i < rects.size(); ++i) {
      const auto& [low, high] = rects[i];
      fill(track, {low, {high.x, low.y}, high, {low.x, high.y}}, ink(i));
      write(track, {(low.x + high.x) / 2, values[i] < 0 ? high.y + 12 : low.y - 3},
            fmt::format("{:g}", values[i]));
      if (i == 0) axis(track, values);
      track.step({values[i], low.x, low.y});
    }
    return track;
  }

  Track line() const {
    const std::vector<double> values = this->values();
    Track track("line", {"value", "x", "y"});
    const std::vector<glm::dvec2> points = chart_line(values, frame());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::ivec2 to(points[i]), from = i == 0 ? to : glm::ivec2(points[i - 1]);
      check_coordinates(to);
      if (i == 0) axis(track, values);
      const auto draw = [&](Srgb8 colour) {
        return [&track, colour](const RowSpan& span) { track.span(span, colour); };
      };
      pen_line(from, to, Pen::round(2), draw(theme::kCool));
      pen_line(to, to, Pen::round(7), draw(ink(i)));
      write(track, points[i] - glm::dvec2(0, 7), fmt::format("{:g}", values[i]));
      track.step({values[i], points[i].x, points[i].y});
    }
    return track;
  }

  Track pie() const {
    const std::vector<double> values = this->values();
    const glm::dvec2 size(world().columns(), world().rows());
    const double radius = 0.4 * size.y;
    Track track("pie", {"value", "share %", "degrees"});
    const std::vector<PieSector> sectors = pie_sectors(values, size / 2.0, radius);
    for (std::size_t i = 0; i < sectors.size(); ++i) {
      const PieSector& s = sectors[i];
      const double sweep = (s.end_rad - s.begin_rad) / (2 * std::numbers::pi);
      fill(track, s.contour, ink(i));
      const double middle = (s.begin_rad + s.end_rad) / 2;
      if (sweep > 0.02) {
        write(track,
              size / 2.0 + 1.15 * radius * glm::dvec2(std::sin(middle), -std::cos(middle)) +
                  glm::dvec2(0, 4),
              fmt::format("{:.0f}%", 100 * sweep));
      }
      track.step({values[i], 100 * sweep, 360 * sweep});
    }
    return track;
  }
};

}  // namespace

DemoInfo charts_demo() {
  return {"charts",
          "1 Displays and coordinates",
          "Five values as bars, as a line and as a pie",
          [](const DemoSetup& setup) { return std::make_unique<Charts>(setup); },
          1,
          {},
          {"applications: bar, line and pie charts"}};
}

}  // namespace kinescope
