#include "demos/picture_demo.h"

#include <memory>
#include <utility>

#include "demos/monitor.h"

namespace kinescope {
namespace {

class PictureDemo : public ClonableDemo<PictureDemo> {
 public:
  PictureDemo(const DemoSetup& setup, const TubeSettings& tube, const Image<Srgb8>& drive)
      : ClonableDemo(setup, {}), monitor_(tube, PixelFormat::kXrgb8888, whole_picture(*this)) {
    monitor_.show(drive);
  }

  std::size_t state_bytes() const override { return monitor_.state_bytes(); }
  Rate refresh() const override { return monitor_.refresh(); }

 private:
  void resized() override { monitor_.resize(whole_picture(*this)); }
  void update(const Step&) override {}
  void draw(const Step& step, Image<Srgb8>& picture) override {
    monitor_.expose(step, studio().workers, picture);
  }

  Monitor monitor_;
};

}  // namespace

DemoInfo picture_demo(const TubeSettings& tube, Image<Srgb8> drive) {
  DemoInfo info{"picture", "", "A picture of the user's own", {}};
  info.create = [tube, shown = std::make_shared<const Image<Srgb8>>(std::move(drive))](
                    const DemoSetup& setup) {
    return std::make_unique<PictureDemo>(setup, tube, *shown);
  };
  return info;
}

}  // namespace kinescope
