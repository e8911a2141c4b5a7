// Thick lines three ways, dashes, and arcs.
#include <numbers>

#include "demos/lesson/lesson.h"
#include "raster/base/error.h"
#include "raster/scan/arc.h"
#include "raster/scan/dashed.h"
#include "raster/scan/thick_area.h"
#include "raster/scan/thick_pen.h"
#include "raster/scan/thick_replicated.h"

namespace kinescope {
namespace {

enum { kKind };
enum { kReplicated, kPen, kArea, kDashed, kArc };
enum { kFrom, kTo };
enum { kWidth, kSweep };

class Strokes : public ClonableDemo<Strokes, Lesson> {
 public:
  explicit Strokes(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Replicated pixels thin out on slopes, a pen keeps its width, an "
                         "area is exact. Drag the ends; an arc goes from the one about the "
                         "other.",
             .handles = {{"from", {0.2, 0.3}}, {"to", {0.8, 0.7}}},
             .figures = {{"width", 5, 1, 15, 1}, {"sweep", 240, -360, 360, 15}},
             .resolution = 2},
            {choice_knob("kind", {"1", "2", "3", "4", "5"},
                         {"replicated", "pen", "area", "dashed", "arc"}, kPen,
                         "how the line is drawn")}) {}

 private:
  Course record() const override {
    const glm::ivec2 from = pixel(kFrom), to = pixel(kTo);
    check_coordinates(from);
    check_coordinates(to);
    const int width = whole_figure(kWidth);
    if (width < 1 || width > 100) throw_bad_input("width: from 1 to 100 pixels");
    Course course;
    course.tracks.push_back(track(from, to, width));
    course.guides.push_back({corner(kFrom), corner(kTo)});
    return course;
  }

  Track track(glm::ivec2 from, glm::ivec2 to, int width) const {
    Track track(knob(kKind).text(), {"x", "y", "pixels"});
    const auto point = [&](int x, int y) {
      track(x, y);
      track.step({double(x), double(y), 1});
    };
    const auto row = [&](const RowSpan& span) {
      track(span);
      track.step({double(span.x_begin), double(span.y), double(span.length())});
    };
    switch (knob(kKind).index()) {
      case kReplicated:
        replicated_line(from, to, width, point);
        break;
      case kPen:
        pen_line(from, to, Pen::round(width), row);
        break;
      case kArea:
        thick_line_area(corner(kFrom), corner(kTo), width, world().window(), row);
        break;
      case kDashed: {
        DashPattern pattern({2 * width, width});
        DashedSink dashes(pattern, point);
        for (BresenhamSteps line(from, to); line.next();) dashes(line.at().x, line.at().y);
        break;
      }
      default: {
        const glm::dvec2 d = to - from;
        const double start = std::atan2(d.y, d.x);
        arc(from, static_cast<int>(std::lround(std::hypot(d.x, d.y))), start,
            figure(kSweep) * std::numbers::pi / 180, point);
      }
    }
    return track;
  }
};

}  // namespace

DemoInfo strokes_demo() {
  return {"strokes",
          "2 Scan conversion",
          "Thick lines by replicated pixels, by a pen and as areas; dashes; arcs",
          [](const DemoSetup& setup) { return std::make_unique<Strokes>(setup); },
          1,
          "drag an end",
          {"arcs", "thick lines", "dashed lines"}};
}

}  // namespace kinescope
