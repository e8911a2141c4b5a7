// A wireframe CAD part: a bracket by its measures, in three views and an isometric one.
#include <fmt/format.h>

#include <numbers>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/projection/axonometric.h"
#include "engine/projection/orthographic.h"
#include "engine/transform/transform3d.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kLength, kHeight, kDepth, kThickness, kHole };

class CadPart : public ClonableDemo<CadPart, Lesson> {
 public:
  explicit CadPart(const DemoSetup& setup)
      : ClonableDemo(setup,
                     {.look_for = "One list of edges gives every view: front, top and side show "
                                  "true lengths, the isometric view the whole. Change a measure: "
                                  "all follow.",
                      .figures = {{"length", 60, 10, 90, 5},
                                  {"height", 45, 10, 90, 5},
                                  {"depth", 40, 10, 90, 5},
                                  {"thickness", 10, 5, 40, 5},
                                  {"hole", 9, 0, 20, 0.5}},
                      .resolution = 7,
                      .speed = 4},
                     {}) {}

 private:
  using Edges = std::vector<std::pair<glm::dvec3, glm::dvec3>>;
  glm::ivec2 panes() const override { return {2, 2}; }

  void check() const {
    for (int i = kLength; i <= kThickness; ++i) {
      if (!(figure(i) > 0 && figure(i) <= 1000)) {
        throw_bad_input("a measure of the part: above 0, at most 1000");
      }
    }
    if (!(figure(kThickness) < std::min(figure(kLength), figure(kHeight)))) {
      throw_bad_input("thickness: less than the length and the height");
    }
    const double room = std::min(figure(kLength) - figure(kThickness), figure(kDepth));
    if (!(figure(kHole) >= 0 && 2 * figure(kHole) < room)) {
      throw_bad_input(fmt::format("hole: a radius from 0 to less than {:g}", room / 2));
    }
  }

  /// An L extruded along z, its middle at the origin, with a hole down through its foot.
  Edges part() const {
    const double l = figure(kLength), h = figure(kHeight), d = figure(kDepth),
                 t = figure(kThickness);
    const std::vector<glm::dvec2> profile = {{0, 0}, {l, 0}, {l, t}, {t, t}, {t, h}, {0, h}};
    const glm::dvec3 middle(l / 2, h / 2, d / 2);
    Edges edges;
    const auto add = [&](glm::dvec3 a, glm::dvec3 b) { edges.push_back({a - middle, b - middle}); };
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const glm::dvec2 a = profile[i], b = profile[(i + 1) % profile.size()];
      add({a, 0}, {b, 0});
      add({a, d}, {b, d});
      add({a, 0}, {a, d});
    }
    constexpr int kChords = 32;
    const double r = figure(kHole), x = (l + t) / 2, z = d / 2;
    for (int i = 0; r > 0 && i < kChords; ++i) {
      const auto rim = [&](int k, double y) {
        const double turn = 2 * std::numbers::pi * k / kChords;
        return glm::dvec3(x + r * std::cos(turn), y, z + r * std::sin(turn));
      };
      add(rim(i, 0), rim(i + 1, 0));
      add(rim(i, t), rim(i + 1, t));
      if (i % (kChords / 4) == 0) add(rim(i, 0), rim(i, t));
    }
    return edges;
  }

  Course record() const override {
    check();
    const Edges edges = part();
    const World pane = world();
    const std::array<std::pair<const char*, glm::dmat4>, 4> views = {
        {{"front", picture_from_world(OrthographicView::kFront)},
         {"isometric", picture_from_world(isometric())},
         {"top", picture_from_world(OrthographicView::kTop)},
         {"side", picture_from_world(OrthographicView::kSide)}}};
    // One scale for all views.
    double reach = 1e-9;
    for (const auto& [a, b] : edges) reach = std::max({reach, glm::length(a), glm::length(b)});
    const double scale = 0.46 * std::min(pane.columns(), pane.rows()) / reach;
    Course course;
    for (std::size_t i = 0; i < views.size(); ++i) {
      Track track(views[i].first, {}, static_cast<int>(i));
      for (const auto& [a, b] : edges) {
        const auto place = [&](const glm::dvec3& p) {
          const glm::dvec3 at(apply(views[i].second, p));
          return glm::dvec2(pane.columns() / 2.0 + scale * at.x, pane.rows() / 2.0 - scale * at.y);
        };
        ink_line(track, pane, place(a), place(b), i == 1 ? theme::kAccent : theme::kText);
        track.step({});
      }
      course.tracks.push_back(std::move(track));
    }
    const double l = figure(kLength), t = figure(kThickness), r = figure(kHole);
    const double area = l * t + (figure(kHeight) - t) * t;
    course.remarks = {fmt::format("{} edges", edges.size()),
                      fmt::format("volume {:.0f}: the profile's area by the depth, less the hole",
                                  area * figure(kDepth) - std::numbers::pi * r * r * t)};
    return course;
  }
};

}  // namespace

DemoInfo cad_part_demo() {
  return {"cad-part",
          "1 Displays and coordinates",
          "A bracket drawn by its measures: front, top, side and isometric views",
          [](const DemoSetup& setup) { return std::make_unique<CadPart>(setup); },
          1,
          {},
          {"applications: a wireframe CAD part"}};
}

}  // namespace kinescope
