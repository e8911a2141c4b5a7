// A screen: what fills the window, knowing nothing of the window itself.
#pragma once

#include "display/input.h"
#include "raster/base/units.h"
#include "raster/image/image.h"

namespace kinescope {

class Screen {
 public:
  virtual ~Screen() = default;
  virtual void handle(const InputEvent& event) = 0;
  /// Moves on by one tick. @return whether frame() has changed
  virtual bool tick(int frames_per_second) = 0;
  virtual const Image<Srgb8>& frame() const = 0;
  /// Wall-clock time of a tick.
  virtual Seconds tick_length() const = 0;
  /// Whether nothing changes until an event comes, or not for long: ticks are then made up for,
  /// many at once.
  virtual bool idle() const { return false; }
  /// Whether every key, Escape too, goes into a text field.
  virtual bool typing() const { return false; }
  /// Whether the user is done with it.
  virtual bool done() const = 0;
};

/// A window's size as pictures of that size can be made: never too small to draw on.
inline InputEvent usable_size(InputEvent resize) {
  resize.x = resize.x < 64 ? 64 : resize.x;
  resize.y = resize.y < 48 ? 48 : resize.y;
  return resize;
}

}  // namespace kinescope
