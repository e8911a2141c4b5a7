// The teapot, shaded and orbited, on a 640x480 tube.
#include <array>

#include "demos/demo.h"
#include "demos/easel.h"
#include "demos/orbit.h"
#include "demos/tube_view.h"
#include "display/video_mode.h"
#include "engine/teapot.h"

namespace kinescope {
namespace {

enum { kShading, kSamples, kTube, kTurning, kFineness };

constexpr float kFieldOfView = 0.62f;
constexpr glm::vec3 kCentre{0.0f, 1.5f, 0.0f};
constexpr double kTurnRadPerSecond = 0.35;
constexpr std::array kSampleCounts = {1, 4, 8};

Light lamp(glm::vec3 position, glm::vec3 colour) {
  Light light;
  light.position = position;
  light.colour = colour;
  return light;
}

std::shared_ptr<const Scene> teapot_scene(int fineness) {
  auto scene = std::make_shared<Scene>();
  Material glaze;
  glaze.name = "copper glaze";
  glaze.base_colour = {0.58f, 0.17f, 0.06f};
  glaze.specular = glm::vec3(0.8f, 0.72f, 0.62f);
  glaze.shininess = 56;
  glaze.double_sided = true;  // one looks into the spout, and past the lid
  scene->materials.push_back(glaze);
  scene->meshes.push_back(teapot_mesh(fineness));
  scene->meshes[0].material = 0;
  Node node;
  node.meshes = {0};
  scene->nodes.push_back(node);
  scene->lights = {{-1, lamp({5, 9, 6}, glm::vec3(0.9f, 0.86f, 0.78f))},
                   {-1, lamp({-8, 2, 3}, glm::vec3(0.1f, 0.16f, 0.3f))},
                   {-1, lamp({-3, 5, -8}, glm::vec3(0.45f, 0.5f, 0.6f))}};
  scene->ambient = glm::vec3(0.045f, 0.05f, 0.06f);
  return scene;
}

class Teapot : public ClonableDemo<Teapot> {
 public:
  explicit Teapot(const DemoSetup& setup)
      : ClonableDemo(
            setup, {choice_knob("shading", {"w", "f", "g", "p", "b"},
                                {"wireframe", "flat", "Gouraud", "Phong", "Blinn"}, 3,
                                "wireframe, flat, Gouraud, Phong, Phong with Blinn's half vector"),
                    choice_knob("samples", {"1", "4", "8"}, {"1", "4", "8"}, 1,
                                "coverage samples a pixel"),
                    toggle_knob("tube", "d", true, "the display: its tube, or the bare picture"),
                    toggle_knob("turning", "t", true, "turn while nobody drags"),
                    number_knob("fineness", "-", "=", 2, 18, 2, 10, "",
                                "quads along each side of a Bezier patch")}),
        view_({parse_mode("640x480@60")}, whole_picture(*this)),
        scene_(teapot_scene(10)),
        easel_(std::make_shared<Easel>(setup.studio->workers)) {
    orbit_.distance = 9.6f;
    orbit_.nearest = 3.5f;
    orbit_.farthest = 30;
  }

  std::size_t state_bytes() const override { return view_.state_bytes(); }
  Rate refresh() const override { return view_.refresh(); }

 private:
  void resized() override { view_.resize(whole_picture(*this)); }

  void update(const Step& step) override {
    for (const InputEvent& event : step.events) orbit_.answer(event);
    if (knob(kTurning).on() && !orbit_.held()) {
      orbit_.turn(static_cast<float>(kTurnRadPerSecond * step.exposure.length().count()));
    }
    const int fineness = static_cast<int>(knob(kFineness).value);
    if (fineness != fineness_) {
      fineness_ = fineness;
      scene_ = teapot_scene(fineness);
      easel_ = std::make_shared<Easel>(studio().workers);
    }
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    const auto drawn = [this](int width, int height) -> const Image<Srgb8>& {
      return render(width, height);
    };
    knob(kTube).on() ? view_.expose(step, studio().workers, drawn, picture)
                     : view_.draw_bare(drawn, picture);
  }

  const Image<Srgb8>& render(int width, int height) {
    const int samples = kSampleCounts[static_cast<std::size_t>(knob(kSamples).index())];
    RenderTarget& target = easel_->prepare(width, height, samples);
    target.clear = {0.013f, 0.016f, 0.024f, 1};
    Camera camera;
    orbit_.aim(camera, kCentre);
    camera.set_field_of_view(kFieldOfView, static_cast<float>(width) / static_cast<float>(height));
    RenderSettings settings;
    constexpr std::array kModels = {ShadingModel::kUnlit, ShadingModel::kFlat,
                                    ShadingModel::kGouraud, ShadingModel::kPhong,
                                    ShadingModel::kBlinn};
    settings.wireframe = settings.hidden_wire = knob(kShading).index() == 0;
    settings.shading = kModels[static_cast<std::size_t>(knob(kShading).index())];
    easel_->renderer.render(*scene_, camera, settings, target);
    return target.srgb8();
  }

  TubeView view_;
  Orbit orbit_;
  int fineness_ = 10;
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<Easel> easel_;
};

std::unique_ptr<Demo> create(const DemoSetup& setup) { return std::make_unique<Teapot>(setup); }

}  // namespace

DemoInfo teapot_demo() {
  return {"teapot",
          "11 Rendering",
          "The Utah teapot lit by three lamps, shaded five ways, on a VGA tube",
          create,
          1,
          "drag or arrow keys to orbit, wheel to go near"};
}

}  // namespace kinescope
