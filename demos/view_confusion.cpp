// What a perspective or a wireframe gets wrong, and what cures it: clipping, and hidden lines.
#include <fmt/format.h>

#include <cmath>

#include "demos/twin_cubes.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kSubject, kCured };
enum { kBehind, kThrough, kAmbiguous };
enum { kDepth };
constexpr double kPlane = 2;     // the picture plane before the eye, which is at the origin
constexpr double kNear = 0.5;    // where the cure clips
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

  /// A point of space in the picture's pane, by the division alone.
  glm::dvec2 pictured(const glm::dvec3& p) const {
    const double scale = 0.3 * world().columns(), share = kPlane / -p.z;
    return {0.5 * world().columns() + scale * share * p.x,
            0.5 * world().rows() - scale * share * p.y};
  }

  /// Whole pixels of the picture as the state; of a point in the eye's plane, infinity.
  void step_at(Track& picture, const glm::dvec3& p) const {
    const glm::dvec2 at = p.z == 0 ? glm::dvec2(HUGE_VAL) : glm::round(pictured(p));
    picture.step({at.x, at.y});
  }

  /// Cut to what lies before the near plane; false if nothing does.
  static bool clip_near(glm::dvec3& a, glm::dvec3& b) {
    const double a_by = -a.z - kNear, b_by = -b.z - kNear;
    if (a_by < 0 && b_by < 0) return false;
    const glm::dvec3 crossing = a_by == b_by ? a : a + a_by / (a_by - b_by) * (b - a);
    if (a_by < 0) a = crossing;
    if (b_by < 0) b = crossing;
    return true;
  }

  static void add_camera(Overlay& over, const SpacePane& space) {
    const std::array<glm::dvec3, 4> c = {
        {{-1.6, -1.6, -kPlane}, {1.6, -1.6, -kPlane}, {1.6, 1.6, -kPlane}, {-1.6, 1.6, -kPlane}}};
    for (std::size_t i = 0; i < 4; ++i) space.add_line(over, c[i], c[(i + 1) % 4], theme::kCool, 0);
    space.add_label(over, {0, 0, 0}, "eye", theme::kCool, 0);
    space.add_label(over, {0, 1.9, -kPlane}, "picture", theme::kCool, 0);
  }

  Course behind() const {
    const double depth = figure(kDepth);
    if (!(std::abs(depth) <= 1000)) throw_bad_input("depth: within 1000 of the eye");
    const Wire house = wire_house();
    const glm::dmat4 placed = translation({0.4, -0.8, depth});
    const SpacePane space = view({0, 0, depth / 2 - 1}, 3 + std::abs(depth) / 2);
    Track track("space", {"x", "y", "z"}, 0), picture("picture", {"x", "y"}, 1);
    std::vector<std::array<glm::dvec3, 2>> rays;
    for (const auto& [i, j] : house.edges) {
      glm::dvec3 a = apply(placed, house.points[i]), b = apply(placed, house.points[j]);
      ink_line(track, space.world, space.place(a), space.place(b));
      const glm::dvec3 end = b;
      const bool seen = !knob(kCured).on() || clip_near(a, b);
      if (seen) ink_line(picture, space.world, pictured(a), pictured(b), theme::kAccent);
      rays.push_back({end, end * (kPlane / -end.z)});
      track.step({end.x, end.y, end.z},
                 seen ? "through the eye onto the picture\n" : "behind the eye: clipped away\n");
      step_at(picture, end);
    }
    Course course;
    course.tracks = {std::move(track), std::move(picture)};
    course.remarks.push_back(depth > 0    ? "It lies behind the eye: the division turns it round."
                             : depth < -2 ? "It lies before the eye: all is well."
                                          : "It meets the eye's plane.");
    course.overlay = [space, rays](std::size_t shown) {
      Overlay over;
      add_camera(over, space);
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
    std::vector<glm::dvec3> points;
    for (int i = 0; i < kBarPieces; ++i) {
      glm::dvec3 a = from + double(i) / kBarPieces * (to - from);
      glm::dvec3 b = from + double(i + 1) / kBarPieces * (to - from);
      ink_line(track, space.world, space.place(a), space.place(b));
      points.push_back(b);
      track.step({b.x, b.y, b.z}, b.z < 0 ? "before the eye\n" : "behind the eye's plane\n");
      const bool torn = (a.z < 0) != (b.z < 0);
      const bool seen = knob(kCured).on() ? clip_near(a, b) : !torn;
      if (seen && b.z != 0) {
        ink_line(picture, space.world, pictured(a), pictured(b),
                 b.z < 0 ? theme::kText : theme::kAccent);
      }
      step_at(picture, b);
    }
    Course course;
    course.tracks = {std::move(track), std::move(picture)};
    if (!knob(kCured).on()) {
      course.guides.push_back({pictured(from), pictured(to), theme::kRed, 1});
      course.remarks.push_back("red: the two ends' pictures joined, none of which is right");
    }
    course.overlay = [space, points](std::size_t shown) {
      Overlay over;
      add_camera(over, space);
      if (shown > 0 && shown <= points.size() && points[shown - 1].z != 0) {
        const glm::dvec3 p = points[shown - 1];
        space.add_line(over, p, p * (kPlane / -p.z), theme::kRed, 0);
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
