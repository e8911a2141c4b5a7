// The window's loop: events in, ticks at the display's pace, frames out.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "demos/console.h"
#include "demos/demo_screen.h"
#include "demos/film_screen.h"
#include "demos/film_window.h"
#include "demos/gallery.h"
#include "demos/registry.h"
#include "demos/session.h"
#include "display/presenter.h"

namespace kinescope {
namespace {

using Clock = std::chrono::steady_clock;
using Moment = std::chrono::time_point<Clock, Seconds>;

Moment now() { return Clock::now(); }

enum class Outcome { kDone, kLeft, kClosed };

/// While a screen is idle its ticks are made up for this often.
constexpr Seconds kRest(0.25);

/// Counts presented frames, over half a second each.
class RateMeter {
 public:
  void count() {
    ++frames_;
    const Seconds passed = now() - since_;
    if (passed < Seconds(0.5)) return;
    rate_ = static_cast<int>(std::lround(frames_ / passed.count()));
    frames_ = 0;
    since_ = now();
  }
  /// Forgets a half second that has begun.
  void restart() {
    frames_ = 0;
    since_ = now();
  }
  int rate() const { return rate_; }

 private:
  Moment since_ = now();
  int frames_ = 0, rate_ = 0;
};

/// Keys and events that are the window's own. @return whether the screen is left by it
bool leaves(Presenter& presenter, const InputEvent& event) {
  if (event.kind != InputKind::kKeyDown || event.repeated) return false;
  if (event.key == "F11") presenter.set_full_screen(!presenter.full_screen());
  if (event.key != "Escape") return false;
  if (!presenter.full_screen()) return true;
  presenter.set_full_screen(false);
  return false;
}

/// Makes up for the ticks of an idle screen that are due. @return whether its frame has changed
bool sleep_through(Screen& screen, Moment& next, int rate) {
  bool changed = false;
  while (screen.idle() && next + screen.tick_length() <= now()) {
    changed |= screen.tick(rate);
    next += screen.tick_length();
  }
  return changed;
}

/// Shows a screen until it is done, left with Escape, or the window is closed. Where the machine is
/// slow, ticks come later: simulated time lags, nothing freezes.
Outcome run(Presenter& presenter, Screen& screen, Workers& workers) {
  InputEvent size;
  size.kind = InputKind::kResize;
  size.x = presenter.width();
  size.y = presenter.height();
  if (size.x != screen.frame().width() || size.y != screen.frame().height()) screen.handle(size);
  RateMeter meter;
  Moment next = now();
  while (true) {
    const bool rests = screen.idle();
    const Seconds wait = next - now() + (rests ? kRest : Seconds(0));
    const auto events = presenter.poll(std::max(Seconds(0), wait));
    if (rests) {
      meter.restart();
      if (sleep_through(screen, next, meter.rate())) presenter.present(screen.frame(), workers);
    }
    for (const InputEvent& event : events) {
      if (event.kind == InputKind::kQuit) return Outcome::kClosed;
      if (!screen.typing() && leaves(presenter, event)) return Outcome::kLeft;
      screen.handle(event);
    }
    if (screen.done()) return Outcome::kDone;
    if (now() < next) continue;
    next = std::max(next + screen.tick_length(), now() - screen.tick_length());
    if (screen.tick(meter.rate())) presenter.present(screen.frame(), workers);
    meter.count();
  }
}

Outcome run_demo(Presenter& presenter, const std::shared_ptr<Studio>& studio, const DemoInfo& info,
                 std::uint64_t seed) {
  presenter.set_title("kinescope: " + std::string(info.name));
  DemoScreen screen(
      info, {studio, std::max(64, presenter.width()), std::max(48, presenter.height()), seed});
  return run(presenter, screen, studio->workers);
}

}  // namespace

int run_demo_window(const DemoInfo& info, const DemoOptions& options) {
  Presenter presenter("kinescope", options.width, options.height);
  run_demo(presenter, std::make_shared<Studio>(options.threads), info, options.seed);
  return 0;
}

int run_gallery_window(const DemoOptions& options) {
  Presenter presenter("kinescope", options.width, options.height);
  const auto studio = std::make_shared<Studio>(options.threads);
  Gallery gallery(studio, presenter.width(), presenter.height(), options.seed);
  while (true) {
    presenter.set_title("kinescope");
    if (run(presenter, gallery, studio->workers) != Outcome::kDone) return 0;
    const auto choice = gallery.take_choice();
    if (run_demo(presenter, studio, all_demos()[*choice], options.seed) == Outcome::kClosed)
      return 0;
  }
}

int run_film_window(const Options& options, const DisplayPlan& plan,
                    std::unique_ptr<PictureFeed> feed) {
  const std::string& input = options.display.input;
  const std::string name = input == "-" ? "standard input" : input;
  Presenter presenter("kinescope: " + name, plan.shot.size.width, plan.shot.size.height);
  const WindowPace pace = window_pace(options.picture.shutter, presenter.refresh(), plan.refresh);
  if (!pace.remark.empty()) print_remark(pace.remark, options.common.quiet);
  const auto studio = std::make_shared<Studio>(options.common.threads);
  FilmScreen screen(name, plan, std::move(feed), pace, studio);
  run(presenter, screen, studio->workers);
  return 0;
}

}  // namespace kinescope
