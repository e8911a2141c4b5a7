// Polygon filling: click the corners, choose how it is filled.
#include "demos/lesson/lesson.h"
#include "raster/base/error.h"
#include "raster/fill/flood_fill.h"
#include "raster/fill/scanline_fill.h"
#include "raster/scan/bresenham_steps.h"

namespace kinescope {
namespace {

enum { kScanLine, kEvenOdd, kFloodFill };

class PolygonFilling : public ClonableDemo<PolygonFilling, Lesson> {
 public:
  explicit PolygonFilling(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Click to add corners, drag them, c clears, Backspace takes the last "
                         "back. The flood begins where the right button is pressed.",
             .handles = {{"a", {0.2, 0.2}}, {"b", {0.8, 0.3}}, {"c", {0.5, 0.85}}},
             .resolution = 2},
            {choice_knob("fill", {"1", "2", "3"}, {"scan line", "even-odd", "flood"}, kScanLine,
                         "how it is filled")}) {}

 private:
  bool answer(const InputEvent& event, LessonScreen::Spot at) override {
    const glm::dvec2 p = glm::floor(at.at);
    if (event.kind == InputKind::kMouseDown && event.button == MouseButton::kLeft) {
      const auto letter = static_cast<char>('a' + handles().size() % 26);
      handles().push_back({std::string(1, letter), p});
      return true;
    }
    if (event.kind == InputKind::kMouseDown && event.button == MouseButton::kRight) {
      seed_ = p;
      return true;
    }
    if (event.kind != InputKind::kKeyDown) return false;
    if (event.key == "c") handles().clear();
    if (event.key == "Backspace" && !handles().empty()) handles().pop_back();
    return event.key == "c" || event.key == "Backspace";
  }

  Course record() const override {
    Contour contour;
    for (std::size_t i = 0; i < corners(); ++i) contour.push_back(corner(static_cast<int>(i)));
    if (contour.empty()) throw_bad_input("there are no corners: click in the picture");
    if (contour.size() < 3) throw_bad_input("fewer than three corners have no inside: click more");
    Course course;
    contour_edges(contour, [&](glm::dvec2 a, glm::dvec2 b) { course.guides.push_back({a, b}); });
    Track track("filled", {"row", "from", "to"}, 0, theme::kCool);
    const auto row = [&](const RowSpan& span) {
      track(span);
      track.step({double(span.y), double(span.x_begin), double(span.x_end)});
    };
    const int method = knob(0).index();
    if (method != kFloodFill) {
      scanline_fill({contour}, method == kEvenOdd ? FillRule::kEvenOdd : FillRule::kNonZero,
                    world().window(), row);
    } else {
      Image<Srgb8> paper(world().columns(), world().rows(), {20, 20, 26, 255});
      contour_edges(contour, [&](glm::dvec2 a, glm::dvec2 b) {
        for (BresenhamSteps line(glm::ivec2(glm::floor(a)), glm::ivec2(glm::floor(b)));
             line.next();) {
          if (paper.contains(line.at().x, line.at().y)) {
            paper.at(line.at().x, line.at().y) = theme::kText;
          }
        }
      });
      const glm::ivec2 seed = seed_.value_or((contour[0] + contour[1] + contour[2]) / 3.0);
      flood_fill(paper, seed.x, seed.y, Connectivity::kFour, row);
      course.papers.push_back(std::move(paper));
    }
    course.tracks.push_back(std::move(track));
    return course;
  }

  std::optional<glm::dvec2> seed_;
};

}  // namespace

DemoInfo practical_8_demo() {
  return {"practical-8",
          "Practicals",
          "Polygon filling: corners by mouse, filled by scan lines or from a seed",
          [](const DemoSetup& setup) { return std::make_unique<PolygonFilling>(setup); },
          1,
          "left: a corner, right: the seed",
          {"practical 8"}};
}

}  // namespace kinescope
