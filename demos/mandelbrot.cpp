// The Mandelbrot set and its Julia sets, coarse cells first, then finer; a click goes deeper, far
// below doubles.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "demos/lesson/lesson.h"
#include "engine/fractals/deep_zoom.h"
#include "engine/fractals/escape_time.h"

namespace kinescope {
namespace {

enum { kSet, kIterations, kReal, kImaginary };
enum { kMandelbrot, kJulia };

constexpr double kWholeWidth = 3.4;
constexpr int kCoarsest = 16;  // pixels of a cell
// Finer steps are told apart by perturbation only.
constexpr double kFinestDouble = 1e-13, kFinest = 1e-250;

Srgb8 colour_of(int time, int most) {
  if (time >= most) return {0, 0, 0, 255};
  const double turn = 0.35 * std::sqrt(40.0 * time) / 4;
  const auto channel = [&](double phase) {
    return static_cast<std::uint8_t>(127.5 + 127 * std::sin(turn + phase));
  };
  return {channel(0), channel(1), channel(2.2), 255};
}

/// As many digits as the pixels tell apart, or as the panel has room for, and the exponent.
std::string shortened(const std::string& number, double step) {
  const int digits = static_cast<int>(2 - std::log10(step));
  if (digits < 16) return fmt::format("{:.{}g}", std::stod(number), digits);
  return number.substr(0, 18) + number.substr(std::min(number.find('e'), number.size()));
}

class Mandelbrot : public ClonableDemo<Mandelbrot, Lesson> {
 public:
  explicit Mandelbrot(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Black points never leave. Coarse cells first. Click to go twice as deep, "
                         "right-click to come back; below 1e-13 one exact orbit guides all.",
             .resolution = 6,
             .speed = 5},
            {choice_knob("set", {"1", "2"}, {"Mandelbrot", "Julia"}, kMandelbrot,
                         "c is the pixel, or z begins there"),
             number_knob("iterations", "3", "4", 50, 2000, 50, 200, "",
                         "after which a point counts as inside"),
             number_knob("c real", "5", "6", -2, 2, 0.01, -0.8, "", "of the Julia set"),
             number_knob("c imaginary", "7", "8", -2, 2, 0.01, 0.16, "", "of the Julia set")}) {}

 private:
  DeepView shown() const {
    DeepView view = view_;
    if (julia() && view_.step == 0) view.centre_x = "0";  // a Julia set lies about the origin
    view.width = world().columns();
    view.height = world().rows();
    view.step = (view_.step > 0 ? view_.step : kWholeWidth) / view.width;
    view.most = knob(kIterations).index();
    return view;
  }

  bool answer(const InputEvent& event, LessonScreen::Spot spot) override {
    const bool press = event.kind == InputKind::kMouseDown;
    if (!press && event.kind != InputKind::kWheel) return false;
    const bool deeper = press ? event.button == MouseButton::kLeft : event.wheel > 0;
    const DeepView now = shown();
    const double width = (view_.step > 0 ? view_.step : kWholeWidth) * (deeper ? 0.5 : 2.0);
    if (width < kFinest || width > 16) return false;
    view_ = moved(now, now.offset(static_cast<int>(spot.at.x), static_cast<int>(spot.at.y)));
    view_.step = width;
    return true;
  }

  std::vector<std::int32_t> times(const DeepView& view, bool deep) const {
    if (deep) return deep_escape_times(view, studio().workers);
    EscapeView plain;
    plain.centre = {std::stod(view.centre_x), std::stod(view.centre_y)};
    plain.step = view.step;
    plain.width = view.width;
    plain.height = view.height;
    plain.most = view.most;
    if (julia()) plain.julia = glm::dvec2(knob(kReal).value, knob(kImaginary).value);
    return escape_times(plain, studio().workers);
  }
  bool julia() const { return knob(kSet).index() == kJulia; }

  /// Every pixel that is a whole number of cells from the middle one, drawn as large as a cell.
  void draw_pass(Track& track, int cell) const {
    const DeepView fine = shown();
    const glm::ivec2 size(fine.width, fine.height), first = size / 2 % cell;
    DeepView coarse = fine;
    coarse.step *= cell;
    coarse.width = (size.x - first.x + cell - 1) / cell;
    coarse.height = (size.y - first.y + cell - 1) / cell;
    const auto time = times(coarse, !julia() && fine.step < kFinestDouble);
    // What the first cell leaves at an edge is its own.
    const auto begin = [&](int i, int from) { return i == 0 ? 0 : from + i * cell; };
    for (int j = 0, k = 0; j < coarse.height; ++j) {
      int inside = 0;
      for (int i = 0; i < coarse.width; ++i, ++k) {
        const std::int32_t t = time[static_cast<std::size_t>(k)];
        inside += t >= fine.most;
        const Srgb8 ink = colour_of(t, fine.most);
        for (int y = begin(j, first.y); y < std::min(begin(j + 1, first.y), size.y); ++y) {
          track.span({y, begin(i, first.x), std::min(begin(i + 1, first.x), size.x)}, ink);
        }
      }
      track.step({double(cell), double(first.y + j * cell), double(inside)});
    }
  }

  /// The coarsest pass; each part after it halves the cells.
  Course record() const override {
    Track track("escape times", {"cell", "row", "inside"});
    draw_pass(track, kCoarsest);
    Course course;
    course.tracks.push_back(std::move(track));
    const DeepView view = shown();
    course.remarks = {"centre " + shortened(view.centre_x, view.step),
                      "   and " + shortened(view.centre_y, view.step),
                      fmt::format("a pixel is {:.3g} wide", view.step)};
    return course;
  }
  bool refine(Course& course, int parts) const override {
    const int cell = kCoarsest >> parts;
    if (cell == 0) return false;
    draw_pass(course.tracks[0], cell);
    return true;
  }

  DeepView view_{.step = 0};  // the width of the picture; 0: the whole set, at any resolution
};

}  // namespace

DemoInfo mandelbrot_demo() {
  return {"mandelbrot",
          "9 Curves and fractals",
          "Mandelbrot and Julia sets by escape time, zoomed by clicks far below doubles",
          [](const DemoSetup& setup) { return std::make_unique<Mandelbrot>(setup); },
          1,
          "left: deeper, right: back",
          {"Mandelbrot and Julia with deep zoom"}};
}

}  // namespace kinescope
