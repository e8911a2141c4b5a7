#include "demos/model_demo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include "demos/easel.h"
#include "demos/model_view.h"
#include "demos/orbit.h"
#include "demos/tube_view.h"

namespace kinescope {
namespace {

enum { kShading, kWireframe, kSamples, kTube };

constexpr std::array kModels = {ShadingModel::kFlat, ShadingModel::kGouraud, ShadingModel::kPhong,
                                ShadingModel::kBlinn, ShadingModel::kUnlit};
constexpr std::array kSampleCounts = {1, 4, 8};

template <typename T, std::size_t kSize>
int index_of(const std::array<T, kSize>& all, T wanted) {
  return static_cast<int>(std::find(all.begin(), all.end(), wanted) - all.begin());
}

/// What every copy of the demo shares and none changes.
struct Exhibit {
  Scene scene;  ///< upright, lit
  RenderOptions options;
  TubeSettings tube;
  Camera camera;
  Bounds bounds;
};

class ModelDemo : public ClonableDemo<ModelDemo> {
 public:
  ModelDemo(const DemoSetup& setup, std::shared_ptr<const Exhibit> exhibit, bool bare)
      : ClonableDemo(
            setup,
            {choice_knob("shading", {"f", "g", "p", "b", "u"},
                         {"flat", "Gouraud", "Phong", "Blinn", "unlit"},
                         index_of(kModels, exhibit->options.shading), "how surfaces are lit"),
             toggle_knob("wireframe", "w", exhibit->options.wireframe, "edges only"),
             choice_knob("samples", {"1", "4", "8"}, {"1", "4", "8"},
                         index_of(kSampleCounts, exhibit->options.samples),
                         "coverage samples a pixel"),
             toggle_knob("tube", "d", !bare, "the display: its tube, or the bare picture")}),
        exhibit_(std::move(exhibit)),
        view_(exhibit_->tube, whole_picture(*this)),
        easel_(std::make_shared<Easel>(setup.studio->workers)) {
    const glm::vec3 sight = exhibit_->camera.eye - exhibit_->camera.look_at;
    orbit_.distance = glm::length(sight);
    orbit_.azimuth_rad = std::atan2(sight.x, sight.z);
    orbit_.elevation_rad = std::asin(std::clamp(sight.y / orbit_.distance, -1.0f, 1.0f));
    orbit_.nearest = orbit_.distance * 0.05f;
    orbit_.farthest = orbit_.distance * 20;
  }

  std::size_t state_bytes() const override { return view_.state_bytes(); }
  Rate refresh() const override { return view_.refresh(); }

 private:
  void resized() override { view_.resize(whole_picture(*this)); }

  void update(const Step& step) override {
    for (const InputEvent& event : step.events) orbit_.answer(event);
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    const auto drawn = [this](int width, int height) -> const Image<Srgb8>& {
      return render(width, height);
    };
    knob(kTube).on() ? view_.expose(step, studio().workers, drawn, picture)
                     : view_.draw_bare(drawn, picture);
  }

  const Image<Srgb8>& render(int width, int height) {
    RenderTarget& target = easel_->prepare(
        width, height, kSampleCounts[static_cast<std::size_t>(knob(kSamples).index())]);
    Camera camera = exhibit_->camera;
    orbit_.aim(camera, camera.look_at);
    fit_depth(camera, exhibit_->bounds);
    camera.set_aspect(static_cast<float>(width) / static_cast<float>(height));
    RenderSettings settings;
    settings.shading = kModels[static_cast<std::size_t>(knob(kShading).index())];
    settings.wireframe = knob(kWireframe).on();
    easel_->renderer.render(exhibit_->scene, camera, settings, target);
    return target.srgb8();
  }

  std::shared_ptr<const Exhibit> exhibit_;
  TubeView view_;
  Orbit orbit_;
  std::shared_ptr<Easel> easel_;
};

}  // namespace

DemoInfo model_demo(Scene scene, const RenderOptions& options, const ModelFilmPlan& plan) {
  auto exhibit = std::make_shared<Exhibit>();
  exhibit->scene = upright_scene(std::move(scene), options);
  exhibit->bounds = world_bounds(exhibit->scene);
  exhibit->options = options;
  exhibit->tube = plan.tube;
  const double aspect = static_cast<double>(plan.drawn.width) / plan.drawn.height;
  exhibit->camera = model_camera(exhibit->scene, options, aspect, true);
  if (exhibit->scene.lights.empty()) add_default_lights(exhibit->scene, exhibit->camera);
  DemoInfo info{"model", "", "A model of the user's own", {}};
  info.create = [exhibit, bare = plan.bare](const DemoSetup& setup) {
    return std::make_unique<ModelDemo>(setup, exhibit, bare);
  };
  return info;
}

}  // namespace kinescope
