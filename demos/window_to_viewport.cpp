// A window of the world onto a viewport of the screen, in three steps; points are clipped first.
#include <fmt/format.h>

#include <random>

#include "demos/lesson/chart.h"
#include "engine/clip/clip_window.h"
#include "engine/clip/liang_barsky.h"
#include "engine/projection/window_to_viewport.h"
#include "raster/scan/limits.h"

namespace kinescope {
namespace {

enum { kOnto, kShape };
enum { kLow, kHigh, kViewLow, kViewHigh };
constexpr int kPoints = 60;

class WindowToViewport : public ClonableDemo<WindowToViewport, Lesson> {
 public:
  explicit WindowToViewport(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Each point inside the window (left) is kept and carried: to the origin, "
                         "scaled, to the viewport's corner (right). Shapes change where the two "
                         "rectangles differ. Drag their corners.",
             .handles = {{"window", {0.2, 0.8}, 0},
                         {"opposite", {0.7, 0.3}, 0},
                         {"viewport", {0.15, 0.7}, 1},
                         {"opposite", {0.85, 0.45}, 1}},
             .resolution = 6,
             .speed = 3},
            {choice_knob("onto", {"1", "2"}, {"viewport", "normalized"}, 0,
                         "the dragged viewport, or the unit square of normalized coordinates"),
             toggle_knob("keep shape", "k", false, "the larger of the two scales is lowered")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }

  /// The viewport's corners, only where it is what the window goes onto.
  bool handle_in(int handle, int pane) const override {
    return Lesson::handle_in(handle, pane) && (handle < kViewLow || knob(kOnto).index() == 0);
  }
  Window between(int i, int j) const {
    check_coordinates(pixel(i));
    check_coordinates(pixel(j));
    const glm::dvec2 a = named_point(i), b = named_point(j);
    return {{std::min(a.x, b.x), std::max(a.y, b.y)}, {std::max(a.x, b.x), std::min(a.y, b.y)}};
  }
  /// The normalized square, as large as the pane holds it.
  Window unit_square() const {
    const double side = 0.8 * std::min(world().columns(), world().rows());
    const glm::dvec2 low(0.5 * (world().columns() - side), 0.5 * (world().rows() + side));
    return {low, low + glm::dvec2(side, -side)};
  }
  Window viewport(const Window& window) const {
    const Window view = knob(kOnto).index() == 0 ? between(kViewLow, kViewHigh) : unit_square();
    return knob(kShape).on() ? of_same_shape(window, view) : view;
  }

  /// A ship of lines, in shares of the pane.
  std::vector<Segment2> drawing() const {
    constexpr std::array<glm::dvec2, 9> kShip = {{{0.25, 0.65},
                                                  {0.75, 0.65},
                                                  {0.85, 0.55},
                                                  {0.15, 0.55},
                                                  {0.25, 0.65},
                                                  {0.5, 0.55},
                                                  {0.5, 0.2},
                                                  {0.75, 0.5},
                                                  {0.5, 0.5}}};
    const glm::dvec2 size(world().columns(), world().rows());
    std::vector<Segment2> lines;
    for (std::size_t i = 0; i + 1 < kShip.size(); ++i) {
      if (i != 4) lines.push_back({kShip[i] * size, kShip[i + 1] * size});
    }
    return lines;
  }

  std::string told(const glm::dmat3& map, const Window& window, const glm::dvec2& p) const {
    const glm::dvec2 q = apply(map, p);
    const glm::dvec2 share = (p - window.low) / (window.high - window.low);
    return fmt::format("({:.1f}, {:.1f}) goes to ({:.1f}, {:.1f})\nnormalized: ({:.3f}, {:.3f})\n",
                       p.x, p.y, q.x, q.y, share.x, share.y);
  }

  Course record() const override {
    const Window window = between(kLow, kHigh);
    const Window viewport = this->viewport(window);
    const auto steps = window_to_viewport_steps(window, viewport);
    const glm::dmat3 map = compose(steps);
    const ClipWindow clip{{window.low.x, window.high.y}, {window.high.x, window.low.y}};
    Track world_track("world", {"x", "y"}, 0), screen("viewport", {"x", "y"}, 1);
    const World pane = world();
    std::mt19937 random(1);
    for (int i = 0; i < kPoints; ++i) {
      const auto place = [&](int size) {
        return static_cast<double>(random() % 1000) / 1000 * size;
      };
      const double x = place(pane.columns()), y = place(pane.rows());
      const glm::dvec2 p(x, y);
      const bool inside = clip.contains(p);
      ink_point(world_track, pane, pane.middle_of(p), inside ? theme::kText : theme::kRed);
      world_track.step({x, y}, inside ? told(map, window, p) : "outside: thrown away\n");
      const glm::dvec2 q = apply(map, p);
      if (inside) ink_point(screen, pane, pane.middle_of(q));
      screen.step({q.x, q.y});
    }
    for (const Segment2& line : drawing()) {
      const auto part = clip_liang_barsky(clip, line);
      const auto draw = [&](Track& track, const glm::dvec2& a, const glm::dvec2& b, Srgb8 colour) {
        ink_line(track, pane, pane.middle_of(a), pane.middle_of(b), colour);
      };
      draw(world_track, line.from, line.to, theme::kRed);
      if (part) {
        draw(world_track, part->from, part->to, theme::kAccent);
        draw(screen, apply(map, part->from), apply(map, part->to), theme::kAccent);
      }
      const glm::dvec2 q = apply(map, line.to);
      world_track.step({line.to.x, line.to.y}, told(map, window, line.to));
      screen.step({q.x, q.y});
    }
    Course course;
    course.tracks = {std::move(world_track), std::move(screen)};
    for (const auto& [w, shown_in] : {std::pair(window, 0), {viewport, 1}}) {
      guide_rectangle(course, pane.middle_of(w.low), pane.middle_of(w.high), theme::kCool,
                      shown_in);
    }
    for (const TransformStep2& step : steps) {
      const glm::dmat3& m = step.matrix;
      course.remarks.push_back(fmt::format("{}: x' = {:.3g} x {:+.4g}, y' = {:.3g} y {:+.4g}",
                                           step.name, m[0][0], m[2][0], m[1][1], m[2][1]));
    }
    return course;
  }
};

}  // namespace

DemoInfo window_to_viewport_demo() {
  return {"window-to-viewport",
          "7 Viewing and clipping",
          "A window of the world carried onto a viewport; points and lines clipped to it",
          [](const DemoSetup& setup) { return std::make_unique<WindowToViewport>(setup); },
          1,
          "drag both rectangles' corners",
          {"window to viewport", "normalized device coordinates", "point clipping"}};
}

}  // namespace kinescope
