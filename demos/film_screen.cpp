#include "demos/film_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "demos/demo_screen.h"
#include "demos/monitor.h"
#include "raster/base/error.h"
#include "raster/image/codecs.h"

namespace kinescope {
namespace {

constexpr std::size_t kHistoryBytes = std::size_t{128} << 20;
constexpr std::size_t kMostAhead = 6;  // pictures
constexpr Seconds kMessage(3), kPatience(0.5);
constexpr const char* kWaiting = "waiting for the film";

std::size_t pictures_a_step(const DisplayPlan& plan, const WindowPace& pace) {
  // A refresh's picture is asked for as it begins, and a refresh may begin and another end.
  const Seconds span = pace.exposure + plan.refresh.period();
  return 1 + static_cast<std::size_t>(span.count() * plan.input_rate.hertz());
}

}  // namespace

FilmScreen::FilmScreen(std::string name, const DisplayPlan& plan, std::unique_ptr<PictureFeed> feed,
                       const WindowPace& pace, std::shared_ptr<Studio> studio)
    : name_(std::move(name)),
      plan_(plan),
      pace_(pace),
      studio_(std::move(studio)),
      feed_(std::move(feed), kMostAhead),
      pictures_a_step_(pictures_a_step(plan, pace)),
      first_refresh_(first_refresh(plan, feed_.facts().still)),
      history_(kHistoryBytes),
      size_(plan.shot.size),
      frame_(plan.shot.size.width, plan.shot.size.height) {}

void FilmScreen::handle(const InputEvent& event) {
  if (event.kind == InputKind::kResize) {
    const InputEvent usable = usable_size(event);
    size_ = {usable.x, usable.y};
  }
  if (event.kind != InputKind::kKeyDown) return;
  dirty_ = true;
  if (transport_.answer(event.key, event.repeated) || event.repeated) return;
  if (event.key == "?") {
    show_help_ = !show_help_;
  } else if (event.key == "Tab") {
    show_state_ = !show_state_;
  } else if (event.key == "s" || event.key == "S") {
    save();
  }
}

void FilmScreen::say(const std::string& message) {
  message_ = message;
  message_ticks_ = std::max(1, static_cast<int>(kMessage / pace_.tick));
  dirty_ = true;
}

void FilmScreen::save() {
  if (history_.empty()) return;
  try {
    const std::string file = free_picture_name("display");
    write_png(file, history_.picture());
    say("saved " + file);
  } catch (const Error& error) {
    say(error.what());
  }
}

/// What the film shows first is there: the tube has shown it for long.
void FilmScreen::switch_on() {
  refreshes_.emplace(feed_, plan_.input_rate, plan_.refresh,
                     fit_of(plan_, feed_.facts(), studio_->workers));
  const Size glass = fit_within(size_, plan_.shot.aspect);
  TubeSettings tube = plan_.shot.tube;
  tube.glass.aspect = plan_.shot.aspect;
  camera_.emplace(
      tube, glass.width, glass.height,
      [this](std::int64_t refresh) -> const Image<Srgb8>& {
        return refreshes_->at(first_refresh_ + refresh);
      },
      studio_->workers, plan_.shot.signal);
  const double begin_s = plan_.start.count() + plan_.frames.first * plan_.rate.period().count();
  camera_->pass_to(Seconds(begin_s - static_cast<double>(first_refresh_) / plan_.refresh.hertz()));
}

void FilmScreen::take_size() {
  if (picture_.width() == size_.width && picture_.height() == size_.height) return;
  picture_ = Image<Srgb8>(size_.width, size_.height, {0, 0, 0, 255});
  const Size glass = fit_within(size_, plan_.shot.aspect);
  camera_->resize(glass.width, glass.height);
  history_.clear();
  kept_ = false;
}

float FilmScreen::gain(Seconds exposure) const {
  if (plan_.shot.gain) return static_cast<float>(*plan_.shot.gain);
  // Slowed down to where a line is drawn in seconds, most of its light is yet to come.
  const double refreshes = exposure / plan_.refresh.period();
  const double gain = std::min(1 / refreshes, Monitor::kIris);
  return std::abs(gain - 1) < 1e-6 ? 1.0f : static_cast<float>(gain);
}

/// Whether the last of the frames that were asked for has been shown; then it stays.
bool FilmScreen::is_over() {
  if (!plan_.cut || !camera_) return false;
  const Seconds end = plan_.start + (plan_.frames.last + 1.0) * plan_.rate.period();
  const double before_s = static_cast<double>(first_refresh_) / plan_.refresh.hertz();
  const Seconds half_a_picture = 0.5 * pace_.exposure * transport_.time_scale();
  if (camera_->now() + Seconds(before_s) + half_a_picture < end) return false;
  if (!transport_.paused()) transport_.answer("Space");
  say(fmt::format("frame {}, the last of --frames", plan_.frames.last));
  return true;
}

bool FilmScreen::expose() {
  if (is_over()) return false;
  if (!feed_.at_hand(pictures_a_step_)) {
    ++ticks_waited_;
    owes_step_ = transport_.paused();
    if (message_.empty() && ticks_waited_ * pace_.tick > kPatience) say(kWaiting);
    return false;
  }
  ticks_waited_ = 0;
  if (message_ == kWaiting) message_.clear(), dirty_ = true;
  if (!camera_) switch_on();
  take_size();
  const Seconds length = pace_.exposure * transport_.time_scale();
  const Seconds begin = camera_->now();
  const Size glass = fit_within(size_, plan_.shot.aspect);
  const RasterTube::Print print{picture_, gain(length), (size_.width - glass.width) / 2,
                                (size_.height - glass.height) / 2, std::exchange(kept_, true)};
  if (!camera_->photograph({begin, begin + length}, print)) return false;
  history_.add(picture_, camera_->now());
  return true;
}

/// At full speed, slices with black between them.
bool FilmScreen::step() {
  const bool full_speed = transport_.time_scale() == 1 && !transport_.paused();
  const bool is_black = full_speed && !history_.empty() && ticks_ + 1 < pace_.ticks;
  const bool was_black = std::exchange(black_, is_black);
  ticks_ = is_black ? ticks_ + 1 : 0;
  return is_black ? !was_black : expose() || was_black;
}

bool FilmScreen::move() {
  switch (transport_.next()) {
    case Move::kNone:
      if (std::exchange(owes_step_, false)) return step();
      return std::exchange(black_, false);
    case Move::kForward:
      return history_.forward() || step();
    case Move::kBack:
      black_ = false;
      if (history_.back()) return true;
      say("no older picture is kept");
      return true;
  }
  return false;
}

Seconds FilmScreen::time() const {
  const double before_s = static_cast<double>(first_refresh_) / plan_.refresh.hertz();
  if (history_.empty()) return plan_.start;
  return (history_.at_end() ? camera_->now() : history_.time()) + Seconds(before_s);
}

bool FilmScreen::tick(int frames_per_second) {
  const bool moved = move();
  if (message_ticks_ > 0 && --message_ticks_ == 0) message_.clear(), dirty_ = true;
  if (!moved && !dirty_ && shown_rate_ == frames_per_second) return false;
  dirty_ = false;
  compose(frames_per_second);
  return true;
}

void FilmScreen::compose(int frames_per_second) {
  if (!history_.empty()) frame_ = history_.picture();
  if (black_) std::fill(frame_.pixels().begin(), frame_.pixels().end(), Srgb8{0, 0, 0, 255});
  shown_rate_ = frames_per_second;
  const DemoInfo info{name_, "", "", {}};
  if (show_help_) help_.lay(info, {}, *studio_, frame_);
  if (!show_state_ && message_.empty()) return;
  hud_.lay({fmt::format("{}  {:.1f} s", name_, time().count()), transport_.text(),
            frames_per_second, transport_.paused(), message_, false},
           *studio_, frame_);
}

}  // namespace kinescope
