// A running demo with its panel, help and line of state.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "demos/picture_name.h"
#include "demos/player.h"
#include "demos/screen.h"
#include "demos/transport.h"
#include "demos/ui/help.h"
#include "demos/ui/hud.h"
#include "demos/ui/panel.h"

namespace kinescope {

class DemoScreen : public Screen {
 public:
  DemoScreen(const DemoInfo& info, const DemoSetup& setup);

  void handle(const InputEvent& event) override;
  bool tick(int frames_per_second) override;
  const Image<Srgb8>& frame() const override { return frame_; }
  Seconds tick_length() const override { return player_.demo().refresh().period(); }
  bool idle() const override;
  /// Paused, nobody would take what is typed.
  bool typing() const override { return player_.demo().typing() && !transport_.paused(); }
  bool done() const override { return false; }

  const Player& player() const { return player_; }
  const Transport& transport() const { return transport_; }

 private:
  bool own_key(const std::string& key, bool repeated);
  bool panel_mouse(const InputEvent& event);
  void say(const std::string& message);
  void save();
  bool move();
  void compose(int frames_per_second);

  const DemoInfo& info_;
  std::shared_ptr<Studio> studio_;
  Player player_;
  Transport transport_;
  Panel panel_;
  Help help_;
  Hud hud_;
  bool show_panel_ = false, show_help_ = false;
  bool panel_holds_mouse_ = false;
  std::string message_;
  int message_ticks_ = 0;
  int shown_rate_ = -1;
  bool dirty_ = true;
  std::vector<InputEvent> waiting_;  // for the next step
  Image<Srgb8> frame_;
};

}  // namespace kinescope
