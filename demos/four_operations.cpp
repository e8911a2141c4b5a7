// The four operations of computer graphics on one subject, side by side.
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "demos/demo.h"
#include "demos/lesson/photograph.h"
#include "demos/orbit.h"
#include "demos/space_view.h"
#include "demos/spaces.h"
#include "demos/ui/theme.h"
#include "engine/teapot.h"
#include "raster/image/convolution.h"
#include "raster/image/tone_curve.h"

namespace kinescope {
namespace {

enum { kImaging, kFineness, kTurning };
enum { kEdges, kNegative, kEqualize, kSharpen, kBlur };
constexpr glm::vec3 kCopper{0.58f, 0.17f, 0.06f};
constexpr double kTurnRadPerSecond = 0.9;
constexpr float kSwingRad = 0.5f;

class FourOperations : public ClonableDemo<FourOperations> {
 public:
  explicit FourOperations(const DemoSetup& setup)
      : ClonableDemo(setup, {choice_knob("imaging", {"1", "2", "3", "4", "5"},
                                         {"edges", "negative", "equalize", "sharpen", "blur"},
                                         kEdges, "what is done to the rendered picture"),
                             number_knob("fineness", "-", "=", 2, 10, 1, 4, "",
                                         "quads along each side of a patch of the model"),
                             toggle_knob("moving", "t", true, "the animation goes on")}),
        easel_(std::make_shared<Easel>(setup.studio->workers)) {
    orbit_.distance = 15;
    orbit_.nearest = 6;
    orbit_.farthest = 40;
    orbit_.azimuth_rad = 0.5f;
  }
  std::size_t state_bytes() const override { return sizeof(*this); }

 private:
  void update(const Step& step) override {
    for (const InputEvent& event : step.events) orbit_.answer(event);
    if (knob(kTurning).on()) phase_rad_ += kTurnRadPerSecond * step.exposure.length().count();
  }

  void draw(const Step&, Image<Srgb8>& picture) override {
    // Four panes; a pixel in the middle may be in two.
    const int across = (width() + 1) / 2, down = (height() + 1) / 2;
    const auto w = static_cast<float>(across), h = static_cast<float>(down);
    const auto right = static_cast<float>(width() - across);
    const auto lower = static_cast<float>(height() - down);
    Camera camera = observer({0, 1.5f, 0}, 15, 0.5f, 0.35f);
    orbit_.aim(camera, {0, 1.5f, 0});
    const auto view = [&](float x, float y) {
      return SpaceView(*easel_, studio(), picture, {x, y, w, h}, camera);
    };
    Mesh mesh = teapot_mesh(static_cast<int>(knob(kFineness).value));
    mesh.colours.assign(mesh.positions.size(), kCopper);
    SpaceView model = view(0, 0);
    model.solid(mesh, true);
    model.axes(glm::vec3(0), 3, {"x", "y", "z"});
    model.caption("1  modelling", "what there is: corners, edges and faces in space");
    SpaceView rendering = view(right, 0);
    rendering.solid(mesh, false);
    image(picture, {width() - across, height() - down}, {across, down});
    rendering.caption("2  rendering", "how it looks: hidden parts gone, light and shade");
    SpaceView moving = view(0, lower);
    const auto swing = [&](double phase) {
      return glm::rotate(glm::mat4(1), kSwingRad * static_cast<float>(std::sin(phase)),
                         glm::vec3(0, 0, 1));
    };
    moving.solid(mapped(mesh, swing(phase_rad_)), false);
    // Where the spout's tip was and will be, a twelfth of a swing apart.
    for (int i = -6; i <= 6; ++i) {
      const double phase = phase_rad_ + i * std::acos(-1.0) / 6;
      const glm::vec3 tip(swing(phase) * glm::vec4(3.2f, 2.3f, 0, 1));
      moving.line(tip - glm::vec3(0, 0.12f, 0), tip + glm::vec3(0, 0.12f, 0), 3,
                  i == 0 ? theme::kAccent : theme::with_alpha(theme::kCool, 150));
    }
    moving.caption("3  animation", "how it changes: a law of motion, frame by frame");
    view(right, lower).caption("4  imaging", "what becomes of the picture: " + name());
  }

  std::string name() const { return knob(kImaging).text(); }

  /// The pane above, worked on as a picture.
  void image(Image<Srgb8>& picture, glm::ivec2 corner, glm::ivec2 size) const {
    const int left = corner.x, top = corner.y;
    Image<Srgb8> rendered(size.x, size.y);
    for (int y = 0; y < rendered.height(); ++y) {
      std::copy_n(picture.row(y) + left, rendered.width(), rendered.row(y));
    }
    const GreyImage grey = grey_of(rendered, false);
    const auto show = [&](int x, int y, std::uint8_t tone) {
      if (picture.contains(left + x, top + y))
        picture.at(left + x, top + y) = {tone, tone, tone, 255};
    };
    const auto curve = [&](const ToneCurve& by) {
      for (int y = 0; y < grey.height(); ++y) {
        for (int x = 0; x < grey.width(); ++x) show(x, y, by[grey.at(x, y)]);
      }
    };
    switch (knob(kImaging).index()) {
      case kEdges:
        return sobel_edges(grey, show);
      case kNegative:
        return curve(negative_curve());
      case kEqualize:
        return curve(equalizing_curve(histogram(grey)));
      case kSharpen:
        return convolve(grey, sharpening(2), show);
      default:
        return convolve(grey, gaussian_blur(2), show);
    }
  }

  Orbit orbit_;
  double phase_rad_ = 0.4;
  std::shared_ptr<Easel> easel_;
};

std::unique_ptr<Demo> create(const DemoSetup& setup) {
  return std::make_unique<FourOperations>(setup);
}

}  // namespace

DemoInfo four_operations_demo() {
  return {"four-operations",
          "1 Displays and coordinates",
          "Modelling, rendering, animation and imaging of one subject, side by side",
          create,
          1,
          "drag or arrow keys to move the camera, wheel to go near",
          {"four operations: imaging, modelling, rendering, animation"}};
}

}  // namespace kinescope
