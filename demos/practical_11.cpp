// A clock, and the sun that rises: pictures of a time that goes on.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "engine/transform/transform2d.h"
#include "raster/base/error.h"
#include "raster/fill/round_fill.h"
#include "raster/scan/thick_area.h"

namespace kinescope {
namespace {

enum { kScene, kTick };
enum { kClock, kSun };
enum { kHour, kMinute, kNoonHeight };
constexpr std::array kTickSeconds = {1, 60, 600};
constexpr double kSunrise = 6, kDay = 86400;
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

  /// A line from the middle, its angle clockwise from the top.
  static void hand(Image<Srgb8>& paper, const World& world, double turns, double from, double to,
                   double width, Srgb8 colour) {
    const glm::dvec2 middle = 0.5 * glm::dvec2(world.columns(), world.rows());
    const glm::dvec2 up = apply(rotation_deg(360 * turns), glm::dvec2(0, -1));
    const double radius = 0.46 * world.rows();
    thick_line_area(middle + from * radius * up, middle + to * radius * up, width * radius,
                    world.window(), [&](const RowSpan& span) {
                      std::fill_n(paper.row(span.y) + span.x_begin, span.length(), colour);
                    });
  }

  static void disc(Image<Srgb8>& paper, const glm::dvec2& centre, double radius, Srgb8 colour) {
    PaperInk ink{paper};
    filled_circle(glm::ivec2(glm::floor(centre)), static_cast<int>(radius),
                  [&](const RowSpan& span) {
                    for (int x = span.x_begin; x < span.x_end; ++x) ink.plot(x, span.y, colour);
                  });
  }

  static void paint_clock(Image<Srgb8>& paper, const World& world, double time) {
    const glm::dvec2 middle = 0.5 * glm::dvec2(world.columns(), world.rows());
    disc(paper, middle, 0.48 * world.rows(), theme::kKeyCap);
    disc(paper, middle, 0.46 * world.rows(), {20, 26, 40, 255});
    for (int mark = 0; mark < 60; ++mark) {
      const bool hour = mark % 5 == 0;
      hand(paper, world, mark / 60.0, hour ? 0.86 : 0.93, 0.97, hour ? 0.035 : 0.012,
           hour ? theme::kText : theme::kDim);
    }
    hand(paper, world, time / 43200, -0.1, 0.55, 0.06, theme::kAccent);
    hand(paper, world, time / 3600, -0.12, 0.82, 0.04, theme::kText);
    hand(paper, world, time / 60, -0.2, 0.9, 0.015, theme::kRed);
    disc(paper, middle, 0.03 * world.rows(), theme::kRed);
  }

  static Srgb8 between(Srgb8 a, Srgb8 b, double share) {
    const double s = std::clamp(share, 0.0, 1.0);
    const auto mix = [&](int from, int to) {
      return static_cast<std::uint8_t>(std::lround(from + s * (to - from)));
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 255};
  }

  /// The sun's height above the horizon as a share of its highest.
  static double sun_height(double time) {
    return std::sin((time / 3600 - kSunrise) / 12 * std::numbers::pi);
  }

  static void paint_sun(Image<Srgb8>& paper, const World& world, double time, double noon_deg) {
    const double height = sun_height(time), columns = world.columns(), rows = world.rows();
    const double horizon = 0.8 * rows;
    const Srgb8 zenith = between({4, 6, 18, 255}, {40, 110, 200, 255}, 0.35 + 1.3 * height);
    const Srgb8 low = height < 0.3
                          ? between({10, 12, 30, 255}, {255, 120, 50, 255}, 1 + 3.3 * height)
                          : between({255, 120, 50, 255}, {170, 210, 240, 255}, 3 * height - 0.9);
    for (int y = 0; y < world.rows(); ++y) {
      std::fill_n(paper.row(y), world.columns(), between(zenith, low, y / horizon));
    }
    std::mt19937 random(11);  // stars, as long as the sky is dark
    for (int i = 0; i < 60 && height < -0.1; ++i) {
      const int x = static_cast<int>(random() % unsigned(world.columns()));
      const int y = static_cast<int>(random() % unsigned(horizon));
      paper.at(x, y) = theme::kText;
    }
    const glm::dvec2 sun(columns * ((time / 3600 - kSunrise) / 12 * 0.8 + 0.1),
                         horizon - 0.72 * rows * height * noon_deg / 90);
    const double radius = 0.07 * rows;
    PaperInk ink{paper};
    for (int ray = 0; ray < 12 && height > -0.2; ++ray) {
      const glm::dvec2 way = apply(rotation_deg(30 * ray + time / 40), glm::dvec2(1, 0));
      ink_line(ink, world, sun + 1.3 * radius * way, sun + 2 * radius * way, theme::kAccent);
    }
    if (height > -0.5) disc(paper, sun, radius, {255, 220, 110, 255});
    const Srgb8 ground = between({8, 14, 10, 255}, {50, 110, 50, 255}, 0.2 + height);
    for (int x = 0; x < world.columns(); ++x) {
      const double hill = 0.05 * rows * std::sin(7 * x / columns) * std::sin(3 * x / columns + 1);
      for (int y = std::max(0, static_cast<int>(horizon - hill)); y < world.rows(); ++y) {
        paper.at(x, y) = ground;
      }
    }
  }

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
