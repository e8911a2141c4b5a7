// A clock, and the sun that rises: pictures of a time that goes on.
#include <cmath>
#include <numbers>

#include "demos/clock_and_sun.h"
#include "demos/lesson/lesson.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kScene, kTick };
enum { kClock, kSun };
enum { kHour, kMinute, kNoonHeight };
constexpr std::array kTickSeconds = {1, 60, 600};
constexpr double kDay = 86400;
constexpr int kMostSteps = 7200;  // two hours of seconds; of longer ticks, half a day

class Practical11 : public ClonableDemo<Practical11, Lesson> {
 public:
  explicit Practical11(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Each step is a moment later: every hand's angle, the sun's place and the "
                         "sky's colour follow from the time alone. Arrows or a drag set the clock.",
             .figures = {{"hour", 10, 0, 23, 1, false},
                         {"minute", 8, 0, 59, 1, false},
                         {"noon", 60, 5, 90, 5}},
             .resolution = 7,
             .speed = 4,
             .loops = true},
            {choice_knob("scene", {"1", "2"}, {"clock", "rising sun"}, kClock, "what is animated"),
             choice_knob("tick", {"k"}, {"1 s", "1 min", "10 min"}, 0, "how long a step is")}) {}

 private:
  bool dragging() const override { return held_; }
  bool answer(const InputEvent& event, LessonScreen::Spot at) override {
    if (event.kind == InputKind::kMouseDown) held_ = event.button == MouseButton::kLeft;
    if (event.kind == InputKind::kMouseUp && std::exchange(held_, false)) return true;
    if (held_ && event.kind != InputKind::kKeyDown) {
      const glm::dvec2 off = at.at - middle();
      const double share = std::atan2(off.x, -off.y) / (2 * std::numbers::pi);
      set_figure(kMinute, std::fmod(std::round(60 * share) + 60, 60));
      return true;
    }
    if (event.kind != InputKind::kKeyDown) return false;
    const int hours = int(event.key == "Up") - int(event.key == "Down");
    const int minutes = int(event.key == "Right") - int(event.key == "Left");
    if (hours == 0 && minutes == 0) return false;
    const double all =
        std::fmod(60 * (figure(kHour) + hours) + figure(kMinute) + minutes + 1440, 1440);
    set_figure(kHour, std::floor(all / 60));
    set_figure(kMinute, std::fmod(all, 60));
    return true;
  }

  glm::dvec2 middle() const { return 0.5 * glm::dvec2(world().columns(), world().rows()); }

  Course record() const override {
    const int hour = whole_figure(kHour), minute = whole_figure(kMinute);
    if (hour < 0 || hour > 23) throw_bad_input("hour: from 0 to 23");
    if (minute < 0 || minute > 59) throw_bad_input("minute: from 0 to 59");
    const double noon = figure(kNoonHeight);
    if (!(noon >= 0 && noon <= 90)) throw_bad_input("noon: the sun's height, from 0 to 90 degrees");
    const bool clock = knob(kScene).index() == kClock;
    const int tick = kTickSeconds[static_cast<std::size_t>(knob(kTick).index())];
    const double begin = 3600.0 * hour + 60.0 * minute;
    Track track(clock ? "clock" : "sun",
                clock ? std::vector<std::string>{"h", "min", "s", "h deg", "m deg"}
                      : std::vector<std::string>{"h", "min", "s", "height"});
    const auto time_at = [begin, tick](std::size_t shown) {
      return std::fmod(begin + double(shown) * tick, kDay);
    };
    const auto steps = static_cast<std::size_t>(std::min(43200 / tick, kMostSteps));
    for (std::size_t shown = 1; shown <= steps; ++shown) {
      const double t = time_at(shown);
      std::vector<double> values = {std::floor(t / 3600), std::fmod(std::floor(t / 60), 60),
                                    std::fmod(t, 60)};
      if (clock) {
        values.push_back(std::fmod(t / 120, 360));
        values.push_back(std::fmod(t / 10, 360));
      } else {
        values.push_back(sun_height(t) * noon);
      }
      track.step(std::move(values));
    }
    Course course;
    course.tracks.push_back(std::move(track));
    const World world = this->world();
    course.painter = [=](std::size_t shown, int, Image<Srgb8>& paper) {
      clock ? paint_clock(paper, world, time_at(shown))
            : paint_sun(paper, world, time_at(shown), noon);
    };
    return course;
  }

  bool held_ = false;
};

}  // namespace

DemoInfo practical_11_demo() {
  return {"practical-11",
          "Practicals",
          "Practical 11: a clock, and the rising sun",
          [](const DemoSetup& setup) { return std::make_unique<Practical11>(setup); },
          1,
          "drag the minute hand",
          {"practical 11"}};
}

}  // namespace kinescope
