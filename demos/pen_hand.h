// The hand that holds a light pen against a tube's picture.
#pragma once

#include <cmath>
#include <numbers>

#include "demos/ui/canvas.h"
#include "display/input.h"
#include "display/tube/deflection.h"
#include "raster/base/units.h"

namespace kinescope {

/// Where the pen is held, and whether it is pressed: by the mouse, or, until that is used, along a
/// figure of its own.
struct PenHand {
  Place place{};
  bool mouse = false, draws = false, rubs = false;

  void answer(const InputEvent& event, const Rect& face) {
    if (event.kind != InputKind::kMouseMove && event.kind != InputKind::kMouseDown &&
        event.kind != InputKind::kMouseUp) {
      return;
    }
    const bool down = event.kind == InputKind::kMouseDown;
    mouse = true;
    place = {2 * (static_cast<double>(event.x) + 0.5 - static_cast<double>(face.x)) /
                     static_cast<double>(face.width) -
                 1,
             2 * (static_cast<double>(event.y) + 0.5 - static_cast<double>(face.y)) /
                     static_cast<double>(face.height) -
                 1};
    if (event.kind == InputKind::kMouseMove) return;
    draws = down && event.button == MouseButton::kLeft;
    rubs = down && event.button == MouseButton::kRight;
  }
  void move_by_itself(Seconds now) {
    const double turn = 2 * std::numbers::pi * now.count();
    place = {0.7 * std::sin(0.3 * turn + 0.4), 0.62 * std::sin(0.4 * turn)};
    draws = true;
  }
};

}  // namespace kinescope
