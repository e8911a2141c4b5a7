#include "demos/player.h"

#include <span>

#include "demo_testing.h"
#include "demos/trace.h"
#include "demos/transport.h"
#include "tests/sanitized.h"

namespace kinescope {
namespace {

TEST(Trace, EqualStepsStayWholePeriodsForHours) {
  Trace trace;
  const Seconds period(1001.0 / 60000);
  for (int i = 0; i < 1'000'000; ++i) trace.add(period, {});
  EXPECT_EQ(trace.end(), 1e6 * period);
  EXPECT_EQ(trace.step(999'999).exposure.end, trace.end());
  EXPECT_EQ(trace.step(500'000).exposure.begin, 5e5 * period);
}

TEST(Trace, StepsFollowEachOtherWithoutGaps) {
  Trace trace;
  for (int i = 0; i < 60; ++i) trace.add(Seconds(i % 7 < 3 ? 0.01 : 0.003 * (i % 5 + 1)), {});
  for (std::int64_t i = 1; i < trace.steps(); ++i) {
    EXPECT_EQ(trace.step(i - 1).exposure.end, trace.step(i).exposure.begin) << i;
    EXPECT_GT(trace.step(i).exposure.length(), Seconds(0));
  }
}

TEST(Trace, CutForgetsTheRestAndKeepsThePrefix) {
  Trace trace;
  trace.add(Seconds(1), {key_down("a")});
  trace.add(Seconds(2), {key_down("b")});
  trace.add(Seconds(2), {key_down("c")});
  trace.cut(2);
  EXPECT_EQ(trace.end(), Seconds(3));
  EXPECT_EQ(trace.step(1).events, std::vector<InputEvent>{key_down("b")});
  trace.add(Seconds(4), {});
  EXPECT_TRUE(trace.step(2).events.empty());
  EXPECT_EQ(trace.end(), Seconds(7));
  trace.cut(0);
  EXPECT_EQ(trace.end(), Seconds(0));
}

TEST(Transport, SlowsDownToAHundredThousandthAndUpAgain) {
  Transport transport;
  EXPECT_EQ(transport.text(), "1x");
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(transport.answer("["));
  EXPECT_DOUBLE_EQ(transport.time_scale(), Transport::kSlowest);
  EXPECT_EQ(transport.text(), "1/100000x");
  for (int i = 0; i < 40; ++i) transport.answer("]");
  EXPECT_EQ(transport.time_scale(), 1);
  EXPECT_DOUBLE_EQ(Transport(1.0 / 500).time_scale(), 1.0 / 500);
}

TEST(Transport, PausesAndStepsOnce) {
  Transport transport;
  EXPECT_EQ(transport.next(), Move::kForward);
  transport.answer("Space");
  EXPECT_EQ(transport.next(), Move::kNone);
  transport.answer(".");
  EXPECT_EQ(transport.next(), Move::kForward);
  EXPECT_EQ(transport.next(), Move::kNone);
  transport.answer(",");
  EXPECT_EQ(transport.next(), Move::kBack);
  EXPECT_EQ(transport.next(), Move::kNone);
  transport.answer("Space");
  EXPECT_EQ(transport.next(), Move::kForward);
  EXPECT_FALSE(transport.answer("q"));
}

/// What a user might do in step i: drags, the wheel, a resize, every knob's first key.
std::vector<InputEvent> inputs(const Demo& demo, int i) {
  const int turn = i - 4;
  if (i == 2) return {mouse_event(InputKind::kMouseDown, 60, 50, MouseButton::kLeft)};
  if (i == 3) return {mouse_event(InputKind::kMouseMove, 75, 58)};
  if (i == 9) return {mouse_event(InputKind::kMouseUp, 75, 58, MouseButton::kLeft)};
  if (i == 10) return {mouse_event(InputKind::kWheel, 75, 58, MouseButton::kNone, 2)};
  if (i == 12) return {mouse_event(InputKind::kResize, 128, 104)};
  if (turn >= 0 && turn % 2 == 0 && turn / 2 < static_cast<int>(demo.knobs().size())) {
    return {key_down(demo.knobs()[static_cast<std::size_t>(turn / 2)].keys[0])};
  }
  return {};
}

class ForwardAndBack : public EveryDemo {
 protected:
  /// Hashes after each step, the length of a step changing on the way.
  void play(Player& player, std::vector<std::uint64_t>& hashes, int steps) const {
    const Seconds period = Rate{60, 1}.period();
    for (int i = static_cast<int>(player.steps()); i < steps; ++i) {
      const double scale = i % 10 < 6 ? info().time_scale : info().time_scale * 0.21;
      player.forward(period * scale, inputs(player.demo(), i));
      hashes.push_back(hash_picture(player.picture()));
    }
  }
};

TEST_P(ForwardAndBack, GivesTheSamePicturesAndGoesOnAsIfItHadNeverGoneBack) {
  // With one snapshot, and with the usual budget: each must lead back to the same light. A
  // sanitizer has seen every path once all inputs were given, and a few steps back.
  constexpr std::pair<std::size_t, int> kRuns[] = {{Player::kSnapshotBytes, kSanitized ? 13 : 27},
                                                   {0, 7}};
  for (const auto& [budget, steps] : std::span(kRuns).first(kSanitized ? 1 : 2)) {
    Player player(info(), small_setup(), budget);
    std::vector<std::uint64_t> there, again;
    play(player, there, steps);
    ASSERT_EQ(there.size(), static_cast<std::size_t>(steps));
    EXPECT_NE(there.front(), there.back());
    const auto go_back_to = [&](int last) {
      for (int i = static_cast<int>(player.steps()) - 2; i >= last; --i) {
        ASSERT_TRUE(player.back());
        ASSERT_EQ(hash_picture(player.picture()), there[static_cast<std::size_t>(i)])
            << "back to step " << i << ", budget " << budget;
      }
    };
    const int last = kSanitized ? steps - 3 : std::max(4, steps - 10);
    go_back_to(last);
    again.assign(there.begin(), there.begin() + last + 1);
    play(player, again, steps);
    EXPECT_EQ(there, again) << "budget " << budget;
    if (kSanitized) return;
    go_back_to(0);
    EXPECT_FALSE(player.back()) << "the first picture stays";
    EXPECT_EQ(player.steps(), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Player, ForwardAndBack, ::testing::ValuesIn(demo_names()), test_name);

TEST(Player, SnapshotsStayWithinTheirBudget) {
  const DemoInfo& info = find_demo("pipeline");
  Player player(info, small_setup(32, 24), 0);
  Player roomy(info, small_setup(32, 24), std::size_t{1} << 14);
  for (int i = 0; i < 200; ++i) {
    player.forward(Seconds(0.01));
    roomy.forward(Seconds(0.01));
  }
  EXPECT_EQ(player.snapshots(), 1u);
  EXPECT_GT(roomy.snapshots(), 3u);
  EXPECT_LE(roomy.snapshots() * roomy.demo().state_bytes(), std::size_t{1} << 14);
  // Ten steps back cost far less than ten times the whole way.
  for (int i = 0; i < 10; ++i) roomy.back();
  EXPECT_LT(roomy.replayed(), 200);
}

TEST(Player, TheSeedDecidesWhatIsDrawnAtRandom) {
  const DemoInfo& info = find_demo("frame-buffer");
  const auto hash = [&](std::uint64_t seed) {
    DemoSetup setup = small_setup();
    setup.seed = seed;
    Player player(info, setup);
    player.forward(Seconds(1.0 / 60));
    return hash_picture(player.picture());
  };
  EXPECT_EQ(hash(1), hash(1));
  EXPECT_NE(hash(1), hash(2));
}

}  // namespace
}  // namespace kinescope
