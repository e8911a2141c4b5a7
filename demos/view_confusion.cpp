// What a perspective or a wireframe gets wrong, and what cures it: clipping, and hidden lines.
#include <fmt/format.h>

#include <cmath>

#include "demos/eye_picture.h"
#include "demos/twin_cubes.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kSubject, kCured };
enum { kBehind, kThrough, kAmbiguous };
enum { kDepth };
constexpr double kBarEnd = 6;    // of the bar through the eye's plane
constexpr int kBarPieces = 120;  // of the bar, one a step

class ViewConfusion : public ClonableDemo<ViewConfusion, SpaceLesson> {
 public:
  explicit ViewConfusion(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Behind the eye: upside down and reversed. Through its plane: the picture "
                         "of one line is torn apart, off to infinity and back from the other side. "
                         "A wire cube: two solids, one picture. c cures each.",
             .figures = {{"depth", 4, -8, 8, 0.5}},
             .resolution = 7,
             .speed = 3},
            {choice_knob("subject", {"1", "2", "3"},
                         {"behind the eye", "through its plane", "wire cube"}, kBehind,
                         "what is looked at"),
             toggle_knob("cure", "c", false, "clipped before the eye; hidden lines removed")},
            0, -60, 20) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }

  Course behind() const {
    const double depth = figure(kDepth);
    if (!(std::abs(depth) <= 1000)) throw_bad_input("depth: within 1000 of the eye");
    const Wire house = wire_house();
    const glm::dmat4 placed = translation({0.4, -0.8, depth});
    const SpacePane space = view({0, 0, depth / 2 - 1}, 3 + std::abs(depth) / 2);
    Track track("space", {"x", "y", "z"}, 0), picture("picture", {"x", "y"}, 1);
    const EyePicture eye{space.world};
    std::vector<std::array<glm::dvec3, 2>> rays;
    for (const auto& [i, j] : house.edges) {
      glm::dvec3 a = apply(placed, house.points[i]), b = apply(placed, house.points[j]);
      ink_line(track, space.world, space.place(a), space.place(b));
      const glm::dvec3 end = b;
      const bool seen = !knob(kCured).on() || EyePicture::clip(a, b);
      if (seen) ink_line(picture, space.world, eye.place(a), eye.place(b), theme::kAccent);
      rays.push_back({end, end * (EyePicture::kPlane / -end.z)});
      track.step({end.x, end.y, end.z},
                 seen ? "through the eye onto the picture\n" : "behind the eye: clipped away\n");
      eye.step_at(picture, end);
    }
    Course course;
    course.tracks = {std::move(track), std::move(picture)};
    course.remarks.push_back(depth > 0    ? "It lies behind the eye: the division turns it round."
                             : depth < -2 ? "It lies before the eye: all is well."
                                          : "It meets the eye's plane.");
    course.overlay = [space, rays](std::size_t shown) {
      Overlay over;
      EyePicture::add_camera(over, space, 0);
      if (shown > 0 && shown <= rays.size()) {
        space.add_line(over, rays[shown - 1][0], rays[shown - 1][1], theme::kRed, 0);
      }
      return over;
    };
    return course;
  }

  Course through() const {
    const glm::dvec3 from(-1.2, -0.6, -kBarEnd), to(1.4, 1.5, kBarEnd);
    const SpacePane space = view({0, 0, 0}, 5.5);
    Track track("space", {"x", "y", "z"}, 0), picture("picture", {"x", "y"}, 1);
    const EyePicture eye{space.world};
    std::vector<glm::dvec3> points;
    for (int i = 0; i < kBarPieces; ++i) {
      glm::dvec3 a = from + double(i) / kBarPieces * (to - from);
      glm::dvec3 b = from + double(i + 1) / kBarPieces * (to - from);
      ink_line(track, space.world, space.place(a), space.place(b));
      points.push_back(b);
      track.step({b.x, b.y, b.z}, b.z < 0 ? "before the eye\n" : "behind the eye's plane\n");
      const bool torn = (a.z < 0) != (b.z < 0);
      const bool seen = knob(kCured).on() ? EyePicture::clip(a, b) : !torn;
      if (seen && b.z != 0) {
        ink_line(picture, space.world, eye.place(a), eye.place(b),
                 b.z < 0 ? theme::kText : theme::kAccent);
      }
      eye.step_at(picture, b);
    }
    Course course;
    course.tracks = {std::move(track), std::move(picture)};
    if (!knob(kCured).on()) {
      course.guides.push_back({eye.place(from), eye.place(to), theme::kRed, 1});
      course.remarks.push_back("red: the two ends' pictures joined, none of which is right");
    }
    course.overlay = [space, points](std::size_t shown) {
      Overlay over;
      EyePicture::add_camera(over, space, 0);
      if (shown > 0 && shown <= points.size() && points[shown - 1].z != 0) {
        const glm::dvec3 p = points[shown - 1];
        space.add_line(over, p, p * (EyePicture::kPlane / -p.z), theme::kRed, 0);
      }
      return over;
    };
    return course;
  }

  Course record() const override {
    switch (knob(kSubject).index()) {
      case kBehind:
        return behind();
      case kThrough:
        return through();
      default:
        return twin_cubes_course({view({0, 0, 0}, 4), knob(kCured).on()});
    }
  }
};

}  // namespace

DemoInfo view_confusion_demo() {
  return {"view-confusion",
          "6 Projections",
          "Objects behind the eye, lines through its plane, ambiguous wires, and their cures",
          [](const DemoSetup& setup) { return std::make_unique<ViewConfusion>(setup); },
          1,
          "drag to look around",
          {"view confusion", "topological distortion", "cured by clipping"}};
}

}  // namespace kinescope
