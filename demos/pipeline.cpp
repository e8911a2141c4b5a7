// One object on its way from its own coordinates to the pixels: every space side by side.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "demos/demo.h"
#include "demos/orbit.h"
#include "demos/space_view.h"
#include "demos/spaces.h"
#include "demos/ui/theme.h"
#include "engine/teapot.h"

namespace kinescope {
namespace {

enum { kWire, kTurning, kFrustum, kAxes, kMatrices, kFieldOfView, kNear, kFar };

constexpr float kDegree = std::numbers::pi_v<float> / 180;
constexpr glm::vec3 kCentre{0, 1.4f, 0};
constexpr double kTurnRadPerSecond = 0.4;

class Pipeline : public ClonableDemo<Pipeline> {
 public:
  explicit Pipeline(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {choice_knob("object", {"w"}, {"solid", "wireframe"}, 0, "how the object is drawn"),
             toggle_knob("turning", "t", true, "the object turns in the world"),
             toggle_knob("view volume", "f", true, "the camera's pyramid, near and far plane"),
             toggle_knob("axes", "a", true, "x red, y green, z blue"),
             toggle_knob("matrices", "m", true, "what leads from each space to the next"),
             number_knob("field of view", "-", "=", 20, 80, 5, 40, "degrees",
                         "the camera's opening"),
             number_knob("near plane", "z", "x", 1, 7, 0.5, 4, "", "distance from the eye"),
             number_knob("far plane", "c", "v", 7.5, 14, 0.5, 11, "", "distance from the eye")}),
        easel_(std::make_shared<Easel>(setup.studio->workers)),
        local_(std::make_shared<Mesh>(teapot_mesh(8))) {
    orbit_.distance = 7.5f;
    orbit_.nearest = 4;
    orbit_.farthest = 10;
    orbit_.azimuth_rad = 0.5f;
    orbit_.elevation_rad = 0.3f;
  }
  std::size_t state_bytes() const override { return sizeof(*this); }

 private:
  void update(const Step& step) override {
    for (const InputEvent& event : step.events) orbit_.answer(event);
    if (knob(kTurning).on()) angle_rad_ += kTurnRadPerSecond * step.exposure.length().count();
  }

  void draw(const Step&, Image<Srgb8>& picture) override {
    // Six panes; pixels between them may be in two.
    const int across = (width() + 2) / 3, down = (height() + 1) / 2;
    const auto w = static_cast<float>(across), h = static_cast<float>(down);
    const auto lower = static_cast<float>(height() - down);
    const auto column = [&](int i) {
      return static_cast<float>(std::min(i * across, width() - across));
    };
    orbit_.aim(camera_, kCentre);
    camera_.set_field_of_view(static_cast<float>(knob(kFieldOfView).value) * kDegree, w / h);
    camera_.near_plane = static_cast<float>(knob(kNear).value);
    camera_.far_plane = static_cast<float>(knob(kFar).value);
    const glm::mat4 world_from_local =
        glm::rotate(glm::mat4(1), static_cast<float>(angle_rad_), glm::vec3(0, 1, 0));
    Mesh mesh = *local_;
    colour_by_volume(mesh, camera_.clip_from_world() * world_from_local);
    const auto view = [&](float x, float y, const Camera& by) {
      return SpaceView(*easel_, studio(), picture, {x, y, w, h}, by);
    };
    SpaceView local = view(0, 0, observer({0, 1.2f, 0}, 14, 0.5f, 0.35f));
    local.solid(mesh, knob(kWire).index() == 1);
    if (knob(kAxes).on()) local.axes(glm::vec3(0), 2.6f, {"x", "y", "z"});
    local.caption("1  local space", "the object as it was modelled");

    SpaceView world = view(column(1), 0, observer({0.6f, 0.9f, 1.4f}, 24, 1.2f, 0.4f));
    draw_space(world, mesh, world_from_local, glm::mat4(1), 2.2f);
    world.caption("2  world space", "in its place, the camera looking at it");
    if (knob(kMatrices).on()) world.matrix("world from local", world_from_local);

    SpaceView seen = view(column(2), 0, observer({0, -0.4f, -5.6f}, 26, 0.95f, 0.4f));
    draw_space(seen, mesh, camera_.view_from_world() * world_from_local, camera_.view_from_world(),
               2.2f);
    seen.caption("3  view space", "the eye at the origin, looking down -z");
    if (knob(kMatrices).on()) seen.matrix("view from world", camera_.view_from_world());

    // Shown with z towards the observer, so that it is no mirror image.
    const glm::mat4 flip = glm::scale(glm::mat4(1), glm::vec3(1, 1, -1));
    SpaceView clip = view(0, lower, observer({0.5f, -0.3f, -0.5f}, 7.4f, 0.55f, 0.35f));
    draw_space(clip, mesh, flip * camera_.clip_from_world() * world_from_local,
               flip * camera_.clip_from_world(), 0.5f);
    clip.caption("4  clip space, divided by w", "the view volume is a box; near things have grown");
    if (knob(kMatrices).on()) clip.matrix("clip from view", camera_.clip_from_view());

    draw_logical(view(column(1), lower, observer({0.5f, 0.5f, 0}, 4.2f, 0, 0)), mesh,
                 camera_.clip_from_world() * world_from_local);
    draw_device(view(column(2), lower, camera_), mapped(mesh, world_from_local));
  }

  /// What the view volume holds, on a screen from (0, 0) to (1, 1) whatever the device.
  void draw_logical(SpaceView pane, const Mesh& mesh, const glm::mat4& clip_from_local) {
    pane.solid(mapped(mesh, logical_from_clip() * clip_from_local), knob(kWire).index() == 1);
    pane.caption("5  logical screen", "the window's width and height are 1");
    std::array<glm::vec3, 8> corners{};
    for (unsigned i = 0; i < corners.size(); ++i) corners[i] = {i & 1u, i >> 1 & 1u, 0};
    pane.box(corners, 1.4f, theme::with_alpha(theme::kCool, 200));
    pane.label({-0.08f, -0.09f, 0}, "(0, 0)", theme::kCool);
    pane.label({1.0f, 1.06f, 0}, "(1, 1)", theme::kCool);
  }

  /// The object, and what the camera makes of the world, in one space.
  void draw_space(SpaceView& pane, const Mesh& local, const glm::mat4& space_from_local,
                  const glm::mat4& space_from_world, float axis) {
    pane.solid(mapped(local, space_from_local), knob(kWire).index() == 1);
    if (space_from_world == glm::mat4(1)) pane.grid(6, 1);
    if (knob(kAxes).on()) pane.axes(glm::vec3(0), axis, {"x", "y", "z"});
    // After the division the eye lies at infinity.
    if (knob(kFrustum).on()) draw_view_volume(pane, camera_, space_from_world, axis >= 1);
  }

  void draw_device(SpaceView pane, const Mesh& world) {
    pane.solid(world, knob(kWire).index() == 1);
    pane.caption("6  device space", "pixels, y downwards: the picture");
    if (knob(kAxes).on()) pane.pixel_axes();
  }

  Orbit orbit_;
  Camera camera_;
  double angle_rad_ = 0.6;
  std::shared_ptr<Easel> easel_;
  std::shared_ptr<const Mesh> local_;
};

}  // namespace

DemoInfo pipeline_demo() {
  return {"pipeline",
          "1 Displays and coordinates",
          "One object in local, world, view, clip, logical and device space, side by side",
          [](const DemoSetup& setup) { return std::make_unique<Pipeline>(setup); },
          1,
          "drag or arrow keys to move the camera, wheel to go near",
          {"graphics pipeline: local, world, view, clip, logical screen, device"}};
}

}  // namespace kinescope
