// A film or a picture on a tube, in a window, at the film's own pace.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "demos/display_film.h"
#include "demos/picture_history.h"
#include "demos/read_ahead.h"
#include "demos/screen.h"
#include "demos/studio.h"
#include "demos/transport.h"
#include "demos/tube_camera.h"
#include "demos/ui/help.h"
#include "demos/ui/hud.h"
#include "demos/window_pace.h"

namespace kinescope {

/// Where the film does not come fast enough, simulated time waits for it; keys are still answered.
/// A step back shows what was shown, as far as it is kept.
class FilmScreen : public Screen {
 public:
  /// @param name of the film, as the line of state shows it
  FilmScreen(std::string name, const DisplayPlan& plan, std::unique_ptr<PictureFeed> feed,
             const WindowPace& pace, std::shared_ptr<Studio> studio);

  void handle(const InputEvent& event) override;
  bool tick(int frames_per_second) override;
  const Image<Srgb8>& frame() const override { return frame_; }
  Seconds tick_length() const override { return pace_.tick; }
  bool idle() const override {
    return transport_.paused() && !transport_.steps_once() && !owes_step_ && !black_ && !dirty_ &&
           message_ticks_ == 0 && size_.width == frame_.width() && size_.height == frame_.height();
  }
  bool done() const override { return false; }

  /// Of the film, at the end of the picture that is shown.
  Seconds time() const;
  const Transport& transport() const { return transport_; }

 private:
  bool move();
  bool step();
  bool expose();
  bool is_over();
  void switch_on();
  void take_size();
  void save();
  void compose(int frames_per_second);
  float gain(Seconds exposure) const;
  void say(const std::string& message);

  std::string name_;
  DisplayPlan plan_;
  WindowPace pace_;
  std::shared_ptr<Studio> studio_;
  ReadAhead feed_;
  std::size_t pictures_a_step_;
  std::int64_t first_refresh_;
  std::optional<RefreshFeed> refreshes_;
  std::optional<TubeCamera> camera_;
  Transport transport_;
  PictureHistory history_;
  Image<Srgb8> picture_;    // the latest
  Size size_;               // that pictures should have
  int ticks_ = 0;           // since the last picture
  int ticks_waited_ = 0;    // for the film
  bool owes_step_ = false;  // one that was asked for while the film did not come
  bool black_ = false;      // between slices
  bool kept_ = false;       // the last picture is still in picture_
  Help help_;
  Hud hud_;
  bool show_help_ = false, show_state_ = true;
  std::string message_;
  int message_ticks_ = 0;
  int shown_rate_ = -1;
  bool dirty_ = true;
  Image<Srgb8> frame_;
};

}  // namespace kinescope
