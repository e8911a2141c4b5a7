// Polygons clipped two ways, side by side: by four clippers in a row, and by following contours.
#include <fmt/format.h>

#include <cstdlib>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "demos/polygon_courses.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kClip };
constexpr int kFarthest = 100'000;
constexpr int kLow = 0, kHigh = 1;
constexpr std::size_t kFirstCorner = 2;

class PolygonClipping : public ClonableDemo<PolygonClipping, Lesson> {
 public:
  explicit PolygonClipping(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for =
                 "Left: each side is a clipper of its own; where the comb falls apart, "
                 "edges run along the side and back (red). Right: in at +, out at -, along "
                 "the window to the next +. The right button adds a corner, Backspace takes one.",
             .handles = {{"corner", {0.2, 0.7}},
                         {"opposite", {0.8, 0.4}},
                         {"a", {0.1, 0.9}},
                         {"b", {0.1, 0.2}},
                         {"c", {0.3, 0.2}},
                         {"d", {0.35, 0.8}},
                         {"e", {0.45, 0.8}},
                         {"f", {0.5, 0.2}},
                         {"g", {0.65, 0.2}},
                         {"h", {0.7, 0.8}},
                         {"i", {0.9, 0.25}},
                         {"j", {0.9, 0.9}}},
             .resolution = 6,
             .speed = 1,
             .centred = true},
            {choice_knob("clip", {"1", "2", "3"}, {"window", "convex", "concave"}, 0,
                         "what it is clipped to: the shape in the dragged rectangle")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }
  ClipShape shape() const { return ClipShape{knob(kClip).index()}; }

  /// A corner in the world's names, where it can be filled.
  glm::dvec2 checked(int handle) const {
    const glm::ivec2 p = pixel(handle);
    if (std::max(std::abs(p.x), std::abs(p.y)) > kFarthest) {
      throw_bad_input("corners: within 100000 pixels");
    }
    return named_point(handle);
  }
  bool answer(const InputEvent& event, LessonScreen::Spot at) override {
    if (event.kind == InputKind::kMouseDown && event.button == MouseButton::kRight) {
      handles().push_back({"corner", glm::floor(at.at)});
      return true;
    }
    if (event.kind != InputKind::kKeyDown || event.key != "Backspace") return false;
    if (handles().size() > kFirstCorner) handles().pop_back();
    return true;
  }

  Contour subject() const {
    if (corners() < kFirstCorner + 3) {
      throw_bad_input("fewer than three corners have no inside: the right button adds one");
    }
    Contour contour;
    for (int i = kFirstCorner; i < static_cast<int>(corners()); ++i) {
      contour.push_back(checked(i));
    }
    return contour;
  }
  ClipWindow window() const { return ClipWindow::between(checked(kLow), checked(kHigh)); }
  Contour clip() const {
    const ClipWindow room = window();
    Contour contour;
    for (const glm::dvec2& p : clip_shape(shape())) {
      contour.push_back(glm::mix(room.min, room.max, p));
    }
    return contour;
  }

  Course record() const override {
    const Contour subject = this->subject(), clip = this->clip();
    const auto four = std::make_shared<HodgmanCourse>();
    const auto followed = std::make_shared<AthertonCourse>();
    Course course;
    try {
      *four = hodgman_course(shape() == ClipShape::kWindow ? SutherlandHodgman(window(), subject)
                                                           : SutherlandHodgman(clip, subject),
                             subject);
    } catch (const Error& error) {
      course.remarks.push_back(std::string("Sutherland-Hodgman: ") + error.what());
    }
    try {
      *followed = atherton_course(subject, clip);
    } catch (const Error& error) {
      course.remarks.push_back(std::string("Weiler-Atherton: ") + error.what());
    }
    course.tracks.push_back(hodgman_track(*four, world(), 0));
    course.tracks.push_back(atherton_track(*followed, world(), 1));
    course.compare = !four->steps.empty() && !followed->steps.empty();
    const std::size_t pieces = followed->pieces.size();
    const std::string one = four->polygon.empty()
                                ? "no polygon"
                                : fmt::format("1 polygon of {} corners", four->polygon.size());
    course.remarks.push_back(
        fmt::format("{} piece{} beside {}", pieces, pieces == 1 ? "" : "s", one));
    const World pane = world();
    course.painter = [four, followed, pane](std::size_t shown, int which, Image<Srgb8>& paper) {
      which == 0 ? paint(*four, shown, pane, paper) : paint(*followed, shown, pane, paper);
    };
    course.overlay = [four, followed, pane, subject, clip](std::size_t shown) {
      Overlay over;
      add_outline(over, pane, subject, theme::kDim);
      add_outline(over, pane, clip, theme::kCool);
      add_overlay(over, *four, shown, pane, 0);
      add_overlay(over, *followed, shown, pane, 1);
      return over;
    };
    return course;
  }
};

}  // namespace

DemoInfo polygon_clipping_demo() {
  return {"polygon-clipping",
          "7 Viewing and clipping",
          "Polygons clipped by Sutherland-Hodgman and by Weiler-Atherton, their difference lit",
          [](const DemoSetup& setup) { return std::make_unique<PolygonClipping>(setup); },
          1,
          "drag corners, right: add one",
          {"polygons by Sutherland-Hodgman (four clippers)", "Weiler-Atherton for concave ones"}};
}

}  // namespace kinescope
