// One cube in the textbook's projections, and the vanishing points of its edges.
#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/projection/axonometric.h"
#include "engine/projection/oblique.h"
#include "engine/projection/orthographic.h"
#include "engine/projection/vanishing_points.h"
#include "engine/transform/transform3d.h"

namespace kinescope {
namespace {

enum { kKind, kTurn, kTilt };
enum {
  kFront,
  kTop,
  kSide,
  kIsometric,
  kDimetric,
  kTrimetric,
  kCavalier,
  kCabinet,
  kOne,
  kTwo,
  kThree
};

/// Rounded, and none below zero for it.
double hundredths(double value) { return std::round(100 * value) / 100 + 0.0; }

class Projections : public ClonableDemo<Projections, Lesson> {
 public:
  explicit Projections(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Parallel edges stay parallel until the eye comes near: then each set "
                         "that is not parallel to the picture meets in a point. y: the next one.",
             .resolution = 6,
             .speed = 2},
            {choice_knob("projection", {"y"},
                         {"front", "top", "side", "isometric", "dimetric", "trimetric", "cavalier",
                          "cabinet", "one point", "two points", "three points"},
                         kTwo, "of the cube"),
             number_knob("turn", "1", "2", -80, 80, 5, 35, "deg", "about y, where it is free"),
             number_knob("tilt", "3", "4", -80, 80, 5, 25, "deg", "about x, where it is free")}) {}

 private:
  glm::dmat4 picture() const {
    const double turn = knob(kTurn).value, tilt = knob(kTilt).value;
    switch (knob(kKind).index()) {
      case kFront:
        return picture_from_world(OrthographicView::kFront);
      case kTop:
        return picture_from_world(OrthographicView::kTop);
      case kSide:
        return picture_from_world(OrthographicView::kSide);
      case kIsometric:
        return picture_from_world(isometric());
      case kDimetric:
        return picture_from_world(dimetric(0.5));
      case kTrimetric:
        return picture_from_world(Axonometric{turn, tilt});
      case kCavalier:
        return picture_from_world(Oblique{kCavalierDepth, 45});
      case kCabinet:
        return picture_from_world(Oblique{kCabinetDepth, 45});
      case kOne:
        return picture_from_world(PerspectiveView{5, 0, 0, {0.9, 0.8, 0}});
      case kTwo:
        return picture_from_world(PerspectiveView{5, turn, 0, {0, 0.8, 0}});
      default:
        return picture_from_world(PerspectiveView{5, turn, tilt, {}});
    }
  }

  Course record() const override {
    const glm::dmat4 matrix = picture();
    const World pane = world();
    const double scale = pane.rows() / 6.0;
    const auto place = [&](const glm::dvec2& p) {
      return glm::dvec2(pane.columns() / 2 + scale * p.x, pane.rows() / 2 - scale * p.y);
    };
    const auto corner = [](unsigned i) {
      return glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    };
    constexpr std::array kInks = {theme::kRed, theme::kGreen, theme::kBlue};
    const auto vanish = principal_vanishing_points(matrix);
    Course course;
    Track track("edges", {"x", "y"});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (unsigned i = 0; i < 8; ++i) {
        if (i & (1u << axis)) continue;
        const glm::dvec2 a(apply(matrix, corner(i))), b(apply(matrix, corner(i | (1u << axis))));
        ink_line(track, pane, place(a), place(b), kInks[axis]);
        track.step({b.x, b.y});
        if (vanish[axis]) course.guides.push_back({place(b), place(*vanish[axis]), theme::kDim});
      }
      course.remarks.push_back(
          vanish[axis] ? fmt::format("{} meets at ({:.2f}, {:.2f})", "xyz"[axis],
                                     hundredths(vanish[axis]->x), hundredths(vanish[axis]->y))
                       : fmt::format("{} stays parallel, {:.3f} long", "xyz"[axis],
                                     foreshortening(matrix)[static_cast<int>(axis)]));
    }
    course.tracks.push_back(std::move(track));
    return course;
  }
};

std::unique_ptr<Demo> create(const DemoSetup& setup) {
  return std::make_unique<Projections>(setup);
}

}  // namespace

DemoInfo projections_demo() {
  return {"projections",
          "6 Projections",
          "A cube in orthographic, axonometric, oblique and perspective projection",
          create,
          1,
          {},
          {"orthographic views (front, top, side)", "axonometric: isometric, dimetric, trimetric",
           "oblique (cavalier, cabinet)", "perspective with one, two and three vanishing points",
           "foreshortening"}};
}

}  // namespace kinescope
