// The viewing transformation, step by step: world, view volume, clipping, division, viewport.
#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "demos/viewing_course.h"
#include "raster/base/error.h"
#include "raster/scan/limits.h"

namespace kinescope {
namespace {

enum { kProjection, kEye };
enum { kUpAngle, kDistance, kWidth, kAside };
enum { kLow, kHigh };

class ViewingSteps : public ClonableDemo<ViewingSteps, SpaceLesson> {
 public:
  explicit ViewingSteps(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for =
                 "The volume (blue) goes along until it is the canonical one; then plane "
                 "after plane cuts (red), and after the division it is a box. Up (green) is a "
                 "vector, and turns by an angle. Drag to look around.",
             .handles = {{"viewport", {0.1, 0.75}, 1}, {"opposite", {0.9, 0.3}, 1}},
             .figures = {{"up angle", 0, -180, 180, 5},
                         {"distance", 2, 0.5, 6, 0.25},
                         {"width", 2, 0.5, 6, 0.25},
                         {"aside", 0.5, -3, 3, 0.25}},
             .words = Words{"up vector", "0 1 0"},
             .resolution = 7,
             .speed = 2},
            {choice_knob("projection", {"1", "2"}, {"perspective", "parallel"}, 0,
                         "the view volume's shape"),
             number_knob("eye", "3", "4", -180, 180, 15, 30, "deg",
                         "how far round the eye stands")},
            0, 60, 25) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }

  /// As typed, then turned about the line of sight.
  glm::dvec3 up(const glm::dvec3& sight) const {
    const std::vector<double> typed = typed_numbers(words(), 3);
    const glm::dvec3 given(typed[0], typed[1], typed[2]);
    if (!(glm::length(glm::cross(given, sight)) > 1e-6 * glm::length(given))) {
      throw_bad_input("up vector: it must have a length, and not lie along the line of sight");
    }
    return apply(rotation_about_deg({{}, sight}, figure(kUpAngle)), given);
  }

  Camera camera() const {
    const glm::dvec3 look_at(0.4, 0.8, -0.6);
    const glm::dvec3 eye =
        apply(rotation_y_deg(knob(kEye).value), glm::dvec3(0, 2.6, 7.5)) + look_at;
    Camera camera;
    camera.eye = eye;
    camera.look_at = look_at;
    camera.up = up(look_at - eye);
    camera.projection =
        knob(kProjection).index() == 0 ? Projection::kPerspective : Projection::kOrthographic;
    camera.view_distance = static_cast<float>(figure(kDistance));
    // A parallel view's window is as large as what is seen.
    const double wide = camera.projection == Projection::kPerspective ? 1.0 : 3.0;
    const glm::dvec2 half = 0.5 * wide * figure(kWidth) * glm::dvec2(1, 0.75);
    camera.window_min = glm::dvec2(figure(kAside), 0) - half;
    camera.window_max = glm::dvec2(figure(kAside), 0) + half;
    camera.near_plane = 5;
    camera.far_plane = 11;
    return camera;
  }

  Course record() const override {
    check_coordinates(pixel(kLow));
    check_coordinates(pixel(kHigh));
    const glm::dvec2 a = corner(kLow), b = corner(kHigh);
    const Window viewport{{std::min(a.x, b.x), std::max(a.y, b.y)},
                          {std::max(a.x, b.x), std::min(a.y, b.y)}};
    const auto viewing =
        std::make_shared<const ViewingCourse>(camera(), view({}, 1).from, viewport);
    Track track("space", {"stage", "x", "y", "z", "w"}, 0);
    Track screen("screen", {}, 1);
    for (std::size_t shown = 1; shown <= viewing->steps(); ++shown) {
      const ViewingCourse::Place at = viewing->place(shown);
      const glm::dvec4 p = viewing->traced(shown);
      track.step({double(at.stage) + at.share, p.x, p.y, p.z, p.w}, viewing->note(shown));
    }
    Course course;
    course.tracks = {std::move(track), std::move(screen)};
    const glm::dvec3 up = camera().up;
    course.remarks = {fmt::format("up ({:.3f}, {:.3f}, {:.3f}) in the world", up.x, up.y, up.z),
                      "x, y, z, w: the first house's front ridge"};
    const World world = this->world();
    course.painter = [viewing, world](std::size_t shown, int pane, Image<Srgb8>& paper) {
      viewing->paint(shown, world, pane, paper);
    };
    course.overlay = [viewing, world](std::size_t shown) { return viewing->overlay(shown, world); };
    return course;
  }
};

}  // namespace

DemoInfo viewing_steps_demo() {
  return {"viewing-steps",
          "7 Viewing and clipping",
          "From local coordinates to the screen: view volume, four viewing steps, six planes",
          [](const DemoSetup& setup) { return std::make_unique<ViewingSteps>(setup); },
          1,
          "drag to look around",
          {"objects in local coordinates placed in a world",
           "view volume from eye, look, up (a vector or an angle), view distance and window size",
           "a window not square to the view axis", "the four steps of the viewing transformation",
           "clipping in homogeneous space against all six planes"}};
}

}  // namespace kinescope
