// A solid as a list of its edges: it turns as fast as the tube can be given new lists.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <memory>
#include <numbers>
#include <optional>

#include "demos/demo.h"
#include "demos/model_view.h"
#include "demos/orbit.h"
#include "demos/ui/caption.h"
#include "demos/vector_monitor.h"
#include "demos/wire_model.h"
#include "display/vector/stroke_list.h"
#include "engine/figures/beams.h"
#include "engine/framing.h"
#include "engine/teapot.h"

namespace kinescope {
namespace {

enum { kFigure, kHidden, kCrease, kFineness, kTurning };

constexpr double kTurnRadPerSecond = 2 * std::numbers::pi / 12;
constexpr std::array kCreasesDeg = {0.0f, 1.0f, 30.0f};
constexpr std::size_t kMemoryWords = 65536;

/// What every copy of the demo shares and none changes.
struct Figure {
  WireScene wire;
  Bounds bounds;
};

std::shared_ptr<const Figure> figure_of(int choice, int fineness) {
  Scene scene;
  scene.meshes.push_back(choice == 0 ? teapot_mesh(fineness) : three_beams());
  scene.nodes.push_back({"", -1, glm::mat4(1.0f), {0}});
  auto figure = std::make_shared<Figure>();
  figure->wire = wire_scene(scene);
  figure->bounds = world_bounds(scene);
  return figure;
}

class Wireframe : public ClonableDemo<Wireframe> {
 public:
  explicit Wireframe(const DemoSetup& setup)
      : ClonableDemo(setup,
                     {choice_knob("figure", {"f"}, {"teapot", "three beams"}, 0, "what is turned"),
                      toggle_knob("hidden", "h", true, "remove lines that a face lies before"),
                      choice_knob("crease", {"c"}, {"every edge", "no flat ones", "30 degrees"}, 1,
                                  "edges where the surface bends less are left out, outlines kept"),
                      number_knob("fineness", "-", "=", 1, 8, 1, 4, "",
                                  "quads along each side of a patch of the teapot"),
                      toggle_knob("turning", "t", true, "turn while nobody drags")}),
        monitor_(machine(), setup.width, setup.height) {
    orbit_.nearest = 0.3f;
    orbit_.farthest = 100;
    monitor_.load("sync\nagain\n");
  }
  std::size_t state_bytes() const override { return monitor_.state_bytes(); }

 private:
  static VectorMachine machine() {
    VectorMachine machine = demo_machine("P31");
    machine.memory_words = kMemoryWords;
    return machine;
  }
  void resized() override { monitor_.resize(width(), height()); }

  void update(const Step& step) override {
    for (const InputEvent& event : step.events) orbit_.answer(event);
    if (knob(kTurning).on() && !orbit_.held()) {
      orbit_.turn(static_cast<float>(kTurnRadPerSecond * step.exposure.length().count()));
    }
    const int choice = knob(kFigure).index(), fineness = static_cast<int>(knob(kFineness).value);
    if (!figure_ || choice != choice_ || fineness != fineness_) {
      if (!figure_ || choice != choice_) orbit_.distance = 0;
      figure_ = figure_of(choice, fineness);
      choice_ = choice, fineness_ = fineness;
    }
    // A list that the tube has not yet begun is not overtaken by another.
    if (monitor_.refreshes() > 0 || lists_ == 0) put_list();
  }

  /// For the next refresh, beside the list that is being drawn.
  void put_list() {
    Camera camera;
    camera.set_field_of_view(0.62f, 1);
    if (orbit_.distance == 0) orbit_.distance = figure_->bounds.radius() * 2.8f;
    orbit_.aim(camera, figure_->bounds.centre());
    fit_depth(camera, figure_->bounds);
    const WireStyle style{knob(kHidden).on(),
                          kCreasesDeg[static_cast<std::size_t>(knob(kCrease).index())] *
                              std::numbers::pi_v<float> / 180};
    const auto strokes = machine_strokes(
        wire_strokes(figure_->wire, camera, style, studio().workers), monitor_.machine());
    const std::vector<Word> list = stroke_list(strokes, monitor_.machine());
    strokes_ = strokes.size();
    monitor_.put(static_cast<Address>(lists_++ % 2 * kMemoryWords / 2), list);
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    monitor_.expose(step, studio().workers, picture);
    passed_ += step.exposure.length();
    begun_ += monitor_.refreshes();
    if (passed_ >= Seconds(0.5)) {
      rate_hz_ = static_cast<double>(begun_) / passed_.count();
      passed_ = Seconds(0), begun_ = 0;
    }
    lay_caption(picture, studio().sans,
                fmt::format("{} strokes of {} edges, a list {:.0f} times a second", strokes_,
                            figure_->wire.edges.size(), rate_hz_));
  }

  VectorMonitor monitor_;
  Orbit orbit_;
  std::shared_ptr<const Figure> figure_;
  int choice_ = 0, fineness_ = 0;
  std::int64_t lists_ = 0, begun_ = 0;
  std::size_t strokes_ = 0;
  Seconds passed_{0};
  double rate_hz_ = 60;
};

}  // namespace

DemoInfo wireframe_demo() {
  return {"wireframe",
          "1 Displays and coordinates",
          "A solid as a list of edges, hidden lines removed, turning as fast as the tube allows",
          [](const DemoSetup& setup) { return std::make_unique<Wireframe>(setup); },
          1,
          "drag or arrow keys to orbit, wheel to go near",
          {"random scan: a solid as a list of edges"}};
}

}  // namespace kinescope
