// A monitor: a frame buffer, the tube that scans it, and the tube's place in a demo's picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "demos/demo.h"
#include "demos/ui/canvas.h"
#include "display/frame_buffer.h"
#include "display/raster_tube.h"

namespace kinescope {

class Monitor {
 public:
  /// How much brighter than its mean the light of a pulse may be before it is clipped.
  static constexpr double kIris = 64;

  /// The tube fills the largest part of `room` (pixels of the picture, within it) that has its own
  /// shape, at least a pixel.
  Monitor(const TubeSettings& settings, PixelFormat format, const Rect& room);
  // In monitor.cpp: every demo would compile them again.
  Monitor(const Monitor&);
  Monitor(Monitor&&) noexcept;
  Monitor& operator=(const Monitor&);
  Monitor& operator=(Monitor&&) noexcept;
  ~Monitor();

  FrameBuffer& buffer() { return buffer_; }
  const RasterScan& scan() const { return tube_.scan(); }
  /// Of a tube whose oscillators run free, else null; until knobs are turned.
  const FreeSweep* free_sweep() const { return tube_.free_sweep(); }
  Rate refresh() const { return scan().mode().frame_rate(); }
  std::size_t state_bytes() const;
  void resize(const Rect& room);
  /// Turns the tube's knobs. Another mode or phosphor makes it another monitor: switched on at demo
  /// time `now`, its frame buffer black. @return whether it is still the same one
  bool adjust(const TubeSettings& settings, Seconds now);
  /// Where the active raster lies in the picture, whole pixels.
  const Rect& face() const { return face_; }

  /// True once a refresh: a frame begins in this step, so the next picture may be drawn now.
  bool frame_begins(const Step& step);
  /// Stores a whole picture for the next vertical retrace; the very first is shown at once.
  void show(const Image<Srgb8>& picture);

  /// What a program does to the frame buffer at a moment, in demo time.
  struct Deed {
    Seconds when;
    std::function<void()> deed;
  };
  /// Lays the step's light into the picture's face(), divided by 2^stops and by the exposure's
  /// length in refreshes, but at least by 1/kIris: what a refresh lights is as bright in a shorter
  /// exposure as in a whole one, until the exposure is so short that most of it comes later.
  /// @param deeds in order of time; those outside the exposure are done at its ends
  void expose(const Step& step, Workers& workers, Image<Srgb8>& picture, double stops = 0,
              const std::vector<Deed>& deeds = {});
  /// Dark until it is exposed again; its scan then starts anew.
  void switch_off() { on_ = false; }
  /// Time 0 of its scan is demo time `now`; the faceplate is dark.
  void switch_on(Seconds now);
  /// The tube's own time, which began when it was switched on.
  Seconds tube_time(Seconds demo_time) const { return demo_time - origin_; }

 private:
  const Image<LinearRgb>& gather(const Step& step, Workers& workers,
                                 const std::vector<Deed>& deeds);

  FrameBuffer buffer_;
  Rect face_;
  RasterTube tube_;
  std::int64_t frame_ = -1;
  bool shown_ = false;
  bool on_ = true;
  Seconds origin_{0};
  std::shared_ptr<Image<LinearRgb>> sum_;  // nothing in it outlives a step
};

/// All of a demo's picture.
inline Rect whole_picture(const Demo& demo) {
  return {0, 0, static_cast<float>(demo.width()), static_cast<float>(demo.height())};
}

}  // namespace kinescope
