// A monitor: a frame buffer, the tube that scans it, and the tube's place in a demo's picture.
#pragma once

#include <cstddef>
#include <cstdint>

#include "demos/demo.h"
#include "display/frame_buffer.h"
#include "display/raster_tube.h"

namespace kinescope {

class Monitor {
 public:
  /// The tube fills the largest part of a picture of width x height that has its own shape.
  Monitor(const TubeSettings& settings, PixelFormat format, int pages, int width, int height);

  FrameBuffer& buffer() { return buffer_; }
  const RasterScan& scan() const { return tube_.scan(); }
  Rate refresh() const { return scan().mode().frame_rate(); }
  std::size_t state_bytes() const;
  void resize(int width, int height);

  /// Where the active raster lies, pixels of the demo's picture.
  int left() const { return left_; }
  int top() const { return top_; }
  int width() const { return width_; }
  int height() const { return height_; }

  /// True once a refresh: a frame begins in this step, so the next picture may be drawn now.
  bool frame_begins(const Step& step);
  /// Stores a whole picture for the next vertical retrace; the very first is shown at once.
  void show(const Image<Srgb8>& picture);
  /// Lays the step's light into the picture. Shorter exposures than a refresh are as bright as long
  /// ones: light is divided by the exposure's length, and by 2^stops.
  void expose(const Step& step, Workers& workers, Image<Srgb8>& picture, double stops = 0);
  /// Dark until it is exposed again; its scan then starts anew.
  void switch_off() { on_ = false; }
  /// The tube's own time, which began when it was switched on.
  Seconds tube_time(Seconds demo_time) const { return demo_time - origin_; }

 private:
  void place(int width, int height);
  void switch_on(Seconds now);

  FrameBuffer buffer_;
  int left_ = 0, top_ = 0, width_ = 1, height_ = 1;
  RasterTube tube_;
  std::int64_t frame_ = -1;
  bool shown_ = false;
  bool on_ = true;
  Seconds origin_{0};
};

}  // namespace kinescope
