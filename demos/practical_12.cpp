// A ball that bounces in a rectangle, as light bends back from a mirror, or under gravity.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "raster/base/error.h"
#include "raster/fill/round_fill.h"
#include "raster/scan/limits.h"

namespace kinescope {
namespace {

enum { kGravity };
enum { kLow, kHigh, kBall, kThrow };
enum { kRadius, kBounce };
constexpr std::size_t kSteps = 3600, kTrail = 90;
constexpr double kFall = 0.08;    // pixels a step, each step
constexpr double kThrown = 0.06;  // of the dragged way, a step

struct BallState {
  glm::dvec2 at{0}, velocity{0};
  int bounces = 0;
};

/// One coordinate between two walls: what lies beyond comes back as from a mirror, its speed
/// lowered.
void bounce(double& at, double& velocity, double low, double high, double kept, int& bounces) {
  const double room = high - low;
  if (room <= 0) {
    at = low;
    return;
  }
  for (int i = 0; i < 64 && (at < low || at > high); ++i) {
    at = at < low ? low + kept * (low - at) : high - kept * (at - high);
    velocity *= -kept;
    ++bounces;
  }
  at = std::clamp(at, low, high);
}

class Practical12 : public ClonableDemo<Practical12, Lesson> {
 public:
  explicit Practical12(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "At a wall one part of the velocity changes its sign. Drag the corners, "
                         "the ball and the tip of its throw; arrows push it; g lets it fall.",
             .handles = {{"corner", {0.1, 0.9}},
                         {"opposite", {0.9, 0.1}},
                         {"ball", {0.3, 0.4}},
                         {"throw", {0.45, 0.25}}},
             .figures = {{"radius", 6, 1, 30, 1}, {"bounce", 1, 0, 1, 0.05}},
             .resolution = 6,
             .speed = 4,
             .loops = true},
            {toggle_knob("gravity", "g", false, "downwards")}) {}

 private:
  bool answer(const InputEvent& event, LessonScreen::Spot) override {
    if (event.kind != InputKind::kKeyDown) return false;
    const glm::dvec2 push(int(event.key == "Right") - int(event.key == "Left"),
                          int(event.key == "Down") - int(event.key == "Up"));
    handles()[kThrow].at += push;
    return push != glm::dvec2(0);
  }

  std::vector<BallState> course_of(const glm::dvec2& low, const glm::dvec2& high) const {
    BallState ball{glm::clamp(corner(kBall), low, high),
                   kThrown * (corner(kThrow) - corner(kBall))};
    const double kept = figure(kBounce);
    std::vector<BallState> states = {ball};
    while (states.size() <= kSteps) {
      if (knob(kGravity).on()) ball.velocity.y += kFall;
      ball.at += ball.velocity;
      bounce(ball.at.x, ball.velocity.x, low.x, high.x, kept, ball.bounces);
      bounce(ball.at.y, ball.velocity.y, low.y, high.y, kept, ball.bounces);
      states.push_back(ball);
    }
    return states;
  }

  Course record() const override {
    for (int i = kLow; i <= kThrow; ++i) check_coordinates(pixel(i));
    const int radius = whole_figure(kRadius);
    if (radius < 1 || radius > 1000) throw_bad_input("radius: from 1 to 1000");
    if (!(figure(kBounce) >= 0 && figure(kBounce) <= 1)) throw_bad_input("bounce: from 0 to 1");
    const glm::dvec2 a = glm::min(corner(kLow), corner(kHigh));
    const glm::dvec2 b = glm::max(corner(kLow), corner(kHigh));
    const glm::dvec2 low = a + double(radius), high = b - double(radius);
    if (!(low.x <= high.x && low.y <= high.y)) throw_bad_input("the ball is too large to fit in");
    const auto states = std::make_shared<const std::vector<BallState>>(course_of(low, high));
    Track track("ball", {"x", "y", "vx", "vy", "hits"});
    for (std::size_t i = 1; i < states->size(); ++i) {
      const BallState& s = (*states)[i];
      track.step({s.at.x, s.at.y, s.velocity.x, s.velocity.y, double(s.bounces)});
    }
    Course course;
    course.tracks.push_back(std::move(track));
    const World world = this->world();
    course.painter = [states, world, radius](std::size_t shown, int, Image<Srgb8>& paper) {
      PaperInk ink{paper};
      shown = std::min(shown, states->size() - 1);
      for (std::size_t i = shown - std::min(shown, kTrail); i < shown; ++i) {
        ink_line(ink, world, (*states)[i].at, (*states)[i + 1].at, theme::kKeyCap);
      }
      filled_circle(glm::ivec2(glm::floor((*states)[shown].at)), radius, [&](const RowSpan& span) {
        for (int x = span.x_begin; x < span.x_end; ++x) ink.plot(x, span.y, theme::kAccent);
      });
    };
    const std::array<glm::dvec2, 4> c = {a, {b.x, a.y}, b, {a.x, b.y}};
    for (std::size_t i = 0; i < 4; ++i) course.guides.push_back({c[i], c[(i + 1) % 4]});
    course.guides.push_back({corner(kBall), corner(kThrow), theme::kRed});
    return course;
  }
};

}  // namespace

DemoInfo practical_12_demo() {
  return {"practical-12",
          "Practicals",
          "Practical 12: a ball bounces in a rectangle",
          [](const DemoSetup& setup) { return std::make_unique<Practical12>(setup); },
          1,
          "drag corners, the ball, its throw",
          {"practical 12"}};
}

}  // namespace kinescope
