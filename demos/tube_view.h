// What a demo renders, as it is looked at: on a tube, or bare.
#pragma once

#include <functional>
#include <memory>

#include "demos/gamma_correction.h"
#include "demos/monitor.h"

namespace kinescope {

/// Both show the same tones: pictures are gamma-corrected on their way to the tube.
class TubeView {
 public:
  /// Draws at that size. @return the picture, valid until the next call
  using Render = std::function<const Image<Srgb8>&(int width, int height)>;

  /// @param room as of Monitor
  TubeView(const TubeSettings& settings, const Rect& room)
      : monitor_(settings, PixelFormat::kXrgb8888, room),
        correct_(std::make_shared<GammaCorrection>(settings.gun.gamma)) {}

  std::size_t state_bytes() const { return monitor_.state_bytes(); }
  Rate refresh() const { return monitor_.refresh(); }
  void resize(const Rect& room) { monitor_.resize(room); }

  /// Renders once a refresh, at the mode's size, and lays the light of the tube into the picture.
  void expose(const Step& step, Workers& workers, const Render& render, Image<Srgb8>& picture) {
    const VideoMode& mode = monitor_.scan().mode();
    if (monitor_.frame_begins(step)) {
      monitor_.show((*correct_)(render(mode.horizontal.active, mode.vertical.active), workers));
    }
    monitor_.expose(step, workers, picture);
  }
  /// Renders at the picture's size; the tube is off.
  void draw_bare(const Render& render, Image<Srgb8>& picture) {
    monitor_.switch_off();
    picture = render(picture.width(), picture.height());
  }

 private:
  Monitor monitor_;
  std::shared_ptr<GammaCorrection> correct_;  // nothing in it outlives a step
};

}  // namespace kinescope
