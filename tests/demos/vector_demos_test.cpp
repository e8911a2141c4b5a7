// Demos of vector displays: what their programs, pens and worlds come to, in numbers.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "demo_testing.h"
#include "demos/demo_screen.h"
#include "demos/spacewar_world.h"
#include "demos/vector_monitor.h"

namespace kinescope {
namespace {

Step step_of(int number) { return {{Seconds(number / 60.0), Seconds((number + 1) / 60.0)}, {}}; }

TEST(VectorMonitor, ARefreshLastsAsLongAsItsInstructions) {
  VectorMonitor monitor(demo_machine("P31"), 64, 64);
  // Ways of 1000 units at 0.025 us, 2 us for each, and 1 us for again: 2000 draws are 54.001 ms.
  std::string list = "rmove 0 0\n";
  for (int i = 0; i < 2000; ++i) list += i % 2 == 0 ? "draw 1000 0\n" : "draw 0 0\n";
  monitor.load(list + "again\n");
  EXPECT_NEAR(monitor.period().count() * 1e3, 0.002 + 2000 * 0.027 + 0.001, 0.054);
  Image<Srgb8> picture(64, 64);
  std::int64_t refreshes = 0;
  for (int i = 0; i < 120; ++i) {
    monitor.expose(step_of(i), test_studio()->workers, picture);
    refreshes += monitor.refreshes();
  }
  EXPECT_NEAR(static_cast<double>(refreshes), 2 / 0.054003, 1);
}

TEST(VectorMonitor, ASyncedListKeepsItsClock) {
  VectorMonitor monitor(demo_machine("P31"), 64, 64);
  monitor.load("sync\nmove 0 0\ndraw 4000 4000\nagain\n");
  EXPECT_NEAR(monitor.period().count(), 1.0 / 60, 1e-6);
}

TEST(VectorMonitor, ThePenTellsTheInstructionAndItsCall) {
  VectorMonitor monitor(demo_machine("P31"), 64, 64);
  monitor.load(
      "sync\npen 1\nmove 100 100\ncall box\nmove 2000 2000\ncall box\nagain\n"
      "box: rdraw 500 0\nrdraw 0 500\nrdraw -500 0\nrdraw 0 -500\nreturn\n");
  Image<Srgb8> picture(64, 64);
  const auto seen = [&](double x, double y, int at) {
    monitor.hold_pen(BeamPen{x, y, 20});
    monitor.expose(step_of(2 * at), test_studio()->workers, picture);
    monitor.expose(step_of(2 * at + 1), test_studio()->workers, picture);
    return monitor.hits();
  };
  const auto first = seen(600, 350, 0), second = seen(2250, 2500, 1);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].address, 8u);
  EXPECT_EQ(first[0].calls, std::vector<Address>{3});
  EXPECT_NEAR(first[0].x, 600, 1e-6);
  ASSERT_EQ(second.size(), 1u);
  EXPECT_EQ(second[0].address, 9u);
  EXPECT_EQ(second[0].calls, std::vector<Address>{5});
  EXPECT_TRUE(seen(3500, 500, 2).empty());
  EXPECT_EQ(monitor.text_at(8), "rdraw 0 500");
}

TEST(VectorMonitor, CopiesGoOnAlikeAndAlone) {
  VectorMonitor one(demo_machine("P7"), 64, 64);
  one.load("sync\nmove 500 500\ndraw 3000 3000\nagain\n");
  Image<Srgb8> a(64, 64), b(64, 64);
  one.expose(step_of(0), test_studio()->workers, a);
  VectorMonitor two = one;
  one.expose(step_of(1), test_studio()->workers, a);
  two.expose(step_of(1), test_studio()->workers, b);
  EXPECT_EQ(hash_picture(a), hash_picture(b));
  two.write(2, "draw", {500, 3000});
  one.expose(step_of(2), test_studio()->workers, a);
  two.expose(step_of(2), test_studio()->workers, b);
  EXPECT_NE(hash_picture(a), hash_picture(b));
}

TEST(Spacewar, OneSeedOneCourse) {
  SpacewarWorld one(7), two(7), other(8);
  for (SpacewarWorld* world : {&one, &two, &other}) {
    world->ships[0].thrusts = world->ships[1].turns_left = true;
  }
  one.run_to(Seconds(2), true);
  for (int i = 1; i <= 200; ++i) two.run_to(Seconds(i * 0.01), true);
  other.run_to(Seconds(2), true);
  EXPECT_EQ(one.ships[0].place, two.ships[0].place);
  EXPECT_EQ(one.ships[1].heading_rad, two.ships[1].heading_rad);
  EXPECT_NE(one.ships[0].place, other.ships[0].place);
}

TEST(Spacewar, OrbitsKeepTheirEnergyAndStraightWaysTheirSpeed) {
  SpacewarWorld world(1);
  const double before = world.energy(0);
  world.run_to(Seconds(20), true);
  EXPECT_NEAR(world.energy(0) / before, 1, 1e-3);
  EXPECT_NEAR(std::hypot(world.ships[0].place.x - 2048, world.ships[0].place.y - 2048), 1200, 2);
  SpacewarWorld empty(1);
  const auto speed = empty.ships[0].speed;
  empty.run_to(Seconds(20), false);
  EXPECT_EQ(empty.ships[0].speed, speed);
}

TEST(Spacewar, ATorpedoEndsAShipAndTheStarToo) {
  SpacewarWorld world(1);
  world.ships[0].place = {500, 3000}, world.ships[0].speed = {0, 0}, world.ships[0].heading_rad = 0;
  world.ships[1].place = {1100, 3000}, world.ships[1].speed = {0, 0};
  world.ships[0].fires = true;
  world.run_to(Seconds(1), false);
  EXPECT_EQ(world.ships[0].hits, 1);
  EXPECT_GT(world.ships[1].dead_for.count(), 0);
  EXPECT_TRUE(world.torpedoes.empty());
  world.ships[0].place = {2048, 2048};
  world.run_to(Seconds(1.1), true);
  EXPECT_GT(world.ships[0].dead_for.count(), 0);
}

/// Drags from one place to another of a picture of 640 x 480, and lets go.
Image<Srgb8> drag(std::string_view name, int x0, int y0, int x1, int y1) {
  Player player(find_demo(name), small_setup(640, 480), 0);
  const Seconds frame(1.0 / 60);
  player.forward(frame, {mouse_event(InputKind::kMouseDown, x0, y0, MouseButton::kLeft)});
  for (int i = 1; i <= 60; ++i) {
    player.forward(frame, {mouse_event(InputKind::kMouseMove, x0 + (x1 - x0) * i / 60,
                                       y0 + (y1 - y0) * i / 60)});
  }
  player.forward(frame, {mouse_event(InputKind::kMouseUp, x1, y1, MouseButton::kLeft)});
  player.forward(frame, {mouse_event(InputKind::kMouseMove, 5, 5)});
  for (int i = 0; i < 3; ++i) player.forward(frame);
  return player.picture();
}
int green(const Image<Srgb8>& picture, int x, int y) {
  int most = 0;
  for (int i = 0; i < 25; ++i)
    most = std::max<int>(most, picture.at(x + i % 5 - 2, y + i / 5 - 2).g);
  return most;
}

TEST(RubberBand, TheLineThatWasLetGoStays) {
  // The grid's spacing of 512 units is 60 pixels: ends jump from (205, 235) to (200, 240).
  const Image<Srgb8> picture = drag("rubber-band", 205, 235, 435, 245);
  EXPECT_GT(green(picture, 230, 239), 100);
  EXPECT_LT(green(picture, 230, 225), 30);
}

TEST(LightPen, DragsThePartThatItPointsAt) {
  // The left edge of the upper gate: x 900 units is pixel 185, y 2300 to 2900 are 210 to 140.
  const Image<Srgb8> picture = drag("light-pen", 185, 175, 245, 175);
  EXPECT_LT(green(picture, 185, 160), 30) << "it has gone from here";
  EXPECT_GT(green(picture, 245, 160) + green(picture, 241, 160), 100);
}

/// Plays so many steps, with what comes before the first.
void play(Player& player, int steps, std::vector<InputEvent> events = {}) {
  for (int i = 0; i < steps; ++i) {
    player.forward(Seconds(1.0 / 60), std::exchange(events, {}));
  }
}
double brightness(const Image<Srgb8>& picture) {
  double sum = 0;
  for (const Srgb8 p : picture.pixels()) sum += p.r + p.g + p.b;
  return sum / (3.0 * static_cast<double>(picture.pixels().size()));
}

TEST(DisplayFile, TheMouseAddsAVector) {
  const Image<Srgb8> picture = drag("display-file", 100, 20, 540, 20);
  EXPECT_GT(green(picture, 320, 20), 100) << "above all that the list draws by itself";
}

TEST(Spacewar, KeysSteerUntilTheyAreLetGo) {
  const auto after = [](std::vector<InputEvent> keys) {
    Player player(find_demo("spacewar"), small_setup(320, 240), 0);
    play(player, 20, std::move(keys));
    return player.picture();
  };
  InputEvent up = key_down("a");
  up.kind = InputKind::kKeyUp;
  const auto rest = hash_picture(after({}));
  for (const char* const key : {"a", "d", "w", "f", "Left", "Right", "Up", "Down"}) {
    EXPECT_NE(hash_picture(after({key_down(key)})), rest) << key;
  }
  EXPECT_EQ(hash_picture(after({key_down("a"), up})), rest);
}

TEST(Spacewar, IsBrightOnItsLongPhosphor) {
  Player player(find_demo("spacewar"), small_setup(320, 240), 0);
  play(player, 10);
  int bright = 0;
  for (const Srgb8 p : player.picture().pixels()) bright += p.g > 160;
  EXPECT_GT(bright, 30);
}

TEST(Storage, PagesAndCopies) {
  Player player(find_demo("storage"), small_setup(320, 240), 0);
  play(player, 40, {key_down("l"), key_down("l"), key_down("w")});
  const double plotted = brightness(player.picture());
  EXPECT_GT(plotted, 4);
  // The copy is paper in the upper left third.
  play(player, 1, {key_down("h")});
  EXPECT_GT(player.picture().at(3, 3).g, 200);
  play(player, 1, {key_down("h")});
  EXPECT_LT(player.picture().at(3, 3).g, 60);
  // The page is erased with a flash, and darkness after it.
  play(player, 3, {key_down("p")});
  EXPECT_GT(brightness(player.picture()), 3 * plotted);
  play(player, 20);
  EXPECT_LT(brightness(player.picture()), plotted);
}

TEST(Storage, AStillScreenIsIdleUntilAKeyComes) {
  DemoScreen screen(find_demo("storage"), small_setup(160, 120));
  const auto ticks = [&](int count) {
    for (int i = 0; i < count; ++i) screen.tick(60);
  };
  for (const char* const key : {"l", "l", "w"}) screen.handle(key_down(key));
  ticks(5);
  EXPECT_FALSE(screen.idle()) << "the plot is being drawn";
  ticks(240);
  EXPECT_TRUE(screen.idle());
  EXPECT_FALSE(screen.tick(60)) << "nothing to show anew";
  screen.handle(key_down("p"));
  EXPECT_FALSE(screen.idle());
  EXPECT_TRUE((ticks(1), screen.tick(60)));
  // Paused in the midst of it, it waits for keys too.
  screen.handle(key_down("Space"));
  EXPECT_FALSE(screen.idle()) << "the line of state is yet to be drawn";
  ticks(1);
  EXPECT_TRUE(screen.idle());
  screen.handle(key_down("."));
  EXPECT_FALSE(screen.idle());
}

}  // namespace
}  // namespace kinescope
