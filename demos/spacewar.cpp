// Two ships, a star, and gravity, on a long phosphor: a program on the display processor.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "demos/demo.h"
#include "demos/spacewar_world.h"
#include "demos/vector_monitor.h"

namespace kinescope {
namespace {

enum { kGravity, kPhosphor, kSky };

constexpr std::array kPhosphors = {"P7", "P31"};
// P7's flash is a blue that the eye sees little of: exposed for what is green in it.
constexpr std::array kIris = {12.0, 1.0};
constexpr Address kList = 0, kShips = 600, kSkyList = 1000;
constexpr int kStars = 120;
// Outlines, units: nose along x. The first is a needle, the second a wedge.
constexpr std::array<std::array<glm::dvec2, 5>, 2> kHulls = {
    {{{{70, 0}, {-50, 16}, {-60, 0}, {-50, -16}, {70, 0}}},
     {{{55, 0}, {-45, 42}, {-20, 0}, {-45, -42}, {55, 0}}}}};

class Spacewar : public ClonableDemo<Spacewar> {
 public:
  explicit Spacewar(const DemoSetup& setup)
      : ClonableDemo(setup,
                     {toggle_knob("gravity", "g", true, "the star pulls"),
                      choice_knob("phosphor", {"p"}, {"P7 long", "P31 short"}, 0, "of the tube"),
                      toggle_knob("sky", "k", true, "stars behind it all")}),
        world_(setup.seed),
        monitor_(demo_machine(kPhosphors[0]), setup.width, setup.height) {
    monitor_.load("sync\nagain\n");
    write_sky(setup.seed);
  }
  std::size_t state_bytes() const override { return monitor_.state_bytes(); }

 private:
  void resized() override { monitor_.resize(width(), height()); }

  void update(const Step& step) override {
    const auto phosphor = static_cast<std::size_t>(knob(kPhosphor).index());
    monitor_.coat(kPhosphors[phosphor]);
    monitor_.open_iris(kIris[phosphor]);
    for (const InputEvent& event : step.events) answer(event);
    world_.run_to(step.exposure.end, knob(kGravity).on());
    write_list();
  }
  void answer(const InputEvent& event) {
    const bool down = event.kind == InputKind::kKeyDown;
    if (!down && event.kind != InputKind::kKeyUp) return;
    const auto steer = [&](SpacewarShip& ship, const char* left, const char* right,
                           const char* thrust, const char* fire) {
      if (event.key == left) ship.turns_left = down;
      if (event.key == right) ship.turns_right = down;
      if (event.key == thrust) ship.thrusts = down;
      if (event.key == fire) ship.fires = down;
    };
    steer(world_.ships[0], "a", "d", "w", "f");
    steer(world_.ships[1], "Left", "Right", "Up", "Down");
  }

  void write_sky(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Address at = monitor_.write(kSkyList, "intensity", {60});
    for (int i = 0; i < kStars; ++i) {
      const auto x = static_cast<std::int64_t>(random() % 4096);
      const auto y = static_cast<std::int64_t>(random() % 4096);
      at = monitor_.write(at, "point", {x, y});
    }
    monitor_.write(monitor_.write(at, "intensity", {255}), "return", {});
  }

  void write_list() {
    Address at = monitor_.write(kList, "sync", {});
    if (knob(kSky).on()) at = monitor_.write(at, "call", {kSkyList});
    at = write_star(at);
    Address hull = kShips;
    for (std::size_t i = 0; i < 2; ++i) {
      const SpacewarShip& ship = world_.ships[i];
      if (ship.dead_for > Seconds(0)) continue;
      at = move(at, ship.place);
      at = monitor_.write(at, "call", {hull});
      hull = write_hull(hull, ship, kHulls[i]);
    }
    for (const Torpedo& t : world_.torpedoes) {
      if (at + 4 >= kShips) break;
      at = monitor_.write(at, "point", {whole(t.place.x), whole(t.place.y)});
    }
    monitor_.write(at, "again", {});
  }
  static std::int64_t whole(double v) { return std::clamp<std::int64_t>(std::llround(v), 0, 4095); }
  Address move(Address at, glm::dvec2 to) {
    return monitor_.write(at, "move", {whole(to.x), whole(to.y)});
  }
  /// A different line through it each time.
  Address write_star(Address at) {
    const double angle = 2.4 * ++flares_;
    const glm::dvec2 ray =
        SpacewarWorld::kStarRadius * glm::dvec2(std::cos(angle), std::sin(angle));
    at = move(at, glm::dvec2(2048) - ray);
    return monitor_.write(at, "rdraw", {std::llround(2 * ray.x), std::llround(2 * ray.y)});
  }
  Address write_hull(Address at, const SpacewarShip& ship,
                     const std::array<glm::dvec2, 5>& outline) {
    const double c = std::cos(ship.heading_rad), s = std::sin(ship.heading_rad);
    std::int64_t x = 0, y = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const std::int64_t to_x = std::llround(c * outline[i].x - s * outline[i].y);
      const std::int64_t to_y = std::llround(s * outline[i].x + c * outline[i].y);
      at = monitor_.write(at, i == 0 ? "rmove" : "rdraw", {to_x - x, to_y - y});
      x = to_x, y = to_y;
    }
    if (ship.thrusts) {  // a flame behind
      const auto back = [&](double by) { return std::pair(-c * by, -s * by); };
      const auto [fx, fy] = back(60);
      at = monitor_.write(at, "rmove", {std::llround(fx) - x, std::llround(fy) - y});
      const auto [gx, gy] = back(flares_ % 2 == 0 ? 60 : 40);
      at = monitor_.write(at, "rdraw", {std::llround(gx), std::llround(gy)});
    }
    return monitor_.write(at, "return", {});
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    monitor_.expose(step, studio().workers, picture);
  }

  SpacewarWorld world_;
  VectorMonitor monitor_;
  int flares_ = 0;
};

std::unique_ptr<Demo> create(const DemoSetup& setup) { return std::make_unique<Spacewar>(setup); }

}  // namespace

DemoInfo spacewar_demo() {
  return {"spacewar",
          "1 Displays and coordinates",
          "A duel about a star: a d w f against the arrow keys, on a phosphor that remembers",
          create,
          1,
          {},
          {"random scan: a display file in motion"}};
}

}  // namespace kinescope
