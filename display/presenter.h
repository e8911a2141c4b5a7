// A window that shows pictures. The only file behind which SDL stands.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "display/input.h"
#include "raster/base/units.h"
#include "raster/base/workers.h"
#include "raster/image/image.h"

namespace kinescope {

class Presenter {
 public:
  /// Whether a window can be opened here at all.
  static bool available();
  /// As large as is asked for, or as the screen where that is smaller.
  /// @throws Error if no window can be opened
  Presenter(const std::string& title, int width, int height);
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  int width() const;  ///< of the drawable, pixels
  int height() const;
  Rate refresh() const;  ///< the monitor's, or 60 if it does not say
  void set_full_screen(bool on);
  bool full_screen() const;
  void set_title(const std::string& title);
  /// Shows the picture, centred if its size differs from the window's.
  void present(const Image<Srgb8>& picture, Workers& workers);
  /// Events since the last call; waits up to `wait` for the first one. The longer it may wait, the
  /// later it may come: by 2 ms, or a tenth of the wait.
  std::vector<InputEvent> poll(Seconds wait = Seconds(0));

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kinescope
