// What a user does in a window, free of any window library.
#pragma once

#include <cstdint>
#include <string>

namespace kinescope {

enum class InputKind {
  kKeyDown,
  kKeyUp,
  kText,
  kMouseMove,
  kMouseDown,
  kMouseUp,
  kWheel,
  kResize,
  kQuit
};
enum class MouseButton { kNone, kLeft, kMiddle, kRight };

struct InputEvent {
  InputKind kind = InputKind::kQuit;
  std::string key;  ///< "a", "F11", "Escape", "Left", "[", "?" ... or the text typed
  MouseButton button = MouseButton::kNone;
  int x = 0, y = 0;  ///< mouse, window pixels; or the new size
  float wheel = 0;   ///< notches, positive away from the user
  bool shift = false, control = false;
  bool repeated = false;  ///< a key that is held presses itself again
  bool operator==(const InputEvent&) const = default;
};

}  // namespace kinescope
