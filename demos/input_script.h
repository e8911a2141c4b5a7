// Input scripts: what a user does, written down, so that a demo can run with nobody there.
//
// One line each, frames counted from 0; `#` begins a comment, empty lines are skipped:
//   FRAME key NAME                        press and release: a, F11, Left, Space, comma ...
//   FRAME move X Y                        mouse to a place, pixels of the picture from its top left
//   FRAME click X Y [left|middle|right]
//   FRAME drag X0 Y0 X1 Y1 FRAMES [left|middle|right]    press, move over FRAMES frames, release
//   FRAME wheel X Y NOTCHES               positive: away from the user
//   FRAME text WORDS TO TYPE
//   FRAME resize WIDTH HEIGHT             the picture's size from then on
// Lines may stand in any order of frames; those of one frame happen in the order written.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "display/input.h"

namespace kinescope {

class InputScript {
 public:
  InputScript() = default;
  /// @param name what an Error calls the text. @throws Error (bad input) naming file and line
  static InputScript parse(std::string_view text, const std::string& name);
  /// `path` "-" is standard input. @throws Error (bad input)
  static InputScript read(const std::string& path);

  /// What happens just before the frame is drawn.
  std::vector<InputEvent> events_at(std::int64_t frame) const;
  /// The last frame with an event; -1 if there is none.
  std::int64_t last_frame() const;

 private:
  std::map<std::int64_t, std::vector<InputEvent>> events_;
};

}  // namespace kinescope
