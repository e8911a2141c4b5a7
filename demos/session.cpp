#include "demos/session.h"

#include <fmt/format.h>

#include "demos/player.h"
#include "demos/transport.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

DemoSetup setup_of(const DemoOptions& options) {
  return {std::make_shared<Studio>(options.threads), options.width, options.height, options.seed};
}

/// A camera of its own rate and shutter: light is gathered as each frame begins; the rest of the
/// frame passes unseen.
class Camera {
 public:
  Camera(Rate fps, Seconds shutter) : fps_(fps), shutter_(shutter) {
    if (!(shutter > Seconds(0)))
      throw Error(ErrorKind::kUsage, "the shutter must stay open longer than 0 s");
    if (shutter > fps.period() * (1 + 1e-9)) {
      throw Error(ErrorKind::kUsage,
                  fmt::format("a shutter of {:.6g} s is longer than a frame lasts at {:.6g} frames "
                              "a second; choose a shorter --shutter or a lower --fps",
                              shutter.count(), fps.hertz()));
    }
  }
  void expose(Player& player, std::int64_t frame, std::vector<InputEvent> events) const {
    const Seconds unseen = static_cast<double>(frame) * fps_.period() - player.now();
    // Rounding alone makes no step.
    if (unseen > shutter_ * 1e-6) player.forward(unseen);
    player.forward(shutter_, std::move(events));
  }

 private:
  Rate fps_;
  Seconds shutter_;
};

/// What the window's ticks do, with nobody there.
class Ticks {
 public:
  Ticks(Player& player, double time_scale) : player_(player), transport_(time_scale) {}
  void tick(std::vector<InputEvent> events) {
    for (InputEvent& event : events) {
      const bool down = event.kind == InputKind::kKeyDown && !player_.demo().typing();
      if (!down || !transport_.answer(event.key)) waiting_.push_back(std::move(event));
    }
    switch (transport_.next()) {
      case Move::kNone:
        break;
      case Move::kForward:
        player_.forward(transport_.step_length(player_.demo().refresh()), std::move(waiting_));
        waiting_.clear();
        break;
      case Move::kBack:
        player_.back();
        break;
    }
  }

 private:
  Player& player_;
  Transport transport_;
  std::vector<InputEvent> waiting_;
};

}  // namespace

Rate film_rate(const DemoInfo& demo, const DemoOptions& options, const DemoFilm& film) {
  return film.fps ? *film.fps : demo.create(setup_of(options))->refresh();
}

void render_demo(const DemoInfo& demo, const DemoOptions& options, const DemoFilm& film,
                 const std::function<bool(std::int64_t frame, const Image<Srgb8>& picture)>& show) {
  Player player(demo, setup_of(options));
  const Rate refresh = player.demo().refresh();
  const bool has_camera = film.fps || film.shutter;
  const Camera camera =
      has_camera ? Camera(film.fps.value_or(refresh), film.shutter.value_or(refresh.period()))
                 : Camera(refresh, refresh.period());
  Ticks ticks(player, demo.time_scale);
  for (std::int64_t frame = 0; frame <= film.last_frame; ++frame) {
    std::vector<InputEvent> events = film.script.events_at(frame);
    if (has_camera) {
      camera.expose(player, frame, std::move(events));
    } else {
      ticks.tick(std::move(events));
    }
    if (frame >= film.first_frame && !show(frame, player.picture())) return;
  }
}

}  // namespace kinescope
