#include "display/vector/vector_tube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "display/vector/assembler.h"
#include "display/vector/display_processor.h"

namespace kinescope {
namespace {

VectorMachine small_machine() {
  VectorMachine m = find_vector_machine("generic");
  m.width = m.height = 100;
  m.screen_mm = 100;
  m.spot_sigma_mm = 1;
  m.speed_units_us = 1;
  m.deflection_khz = m.slew_mm_us = m.intensity_mhz = m.spot_growth = 0;
  return m;
}

/// A line in the middle, drawn once from t in 80 us, at the machine's usual speed.
BeamMove line_at(Seconds t) {
  return {10, 50.5, 90, 50.5, t, t + microseconds(80), 1, {1, 1, 1}, 0};
}

double sum_of(const Image<LinearRgb>& picture) {
  double sum = 0;
  for (const LinearRgb& p : picture.pixels()) sum += static_cast<double>(p.g);
  return sum;
}

TEST(VectorTube, ALineAtTheUsualSpeedIsAsBrightAsWhite) {
  VectorTube tube(small_machine(), 100, 100);
  Workers workers(1);
  const std::vector<BeamMove> moves{line_at(Seconds(0))};
  const Image<LinearRgb>& picture = tube.expose(moves, Seconds(10), workers);
  // A pixel sees a twentieth less than the very middle of a spot of one pixel.
  EXPECT_NEAR(picture.at(50, 49).g, 0.96f, 0.01f);
  EXPECT_EQ(picture.at(50, 20).g, 0);
}

TEST(VectorTube, SlicesAddUpToTheWhole) {
  Workers workers(2);
  std::vector<BeamMove> moves;
  for (int i = 0; i < 5; ++i) moves.push_back(line_at(microseconds(300 * i)));
  VectorTube once(small_machine(), 100, 100), often(small_machine(), 100, 100);
  const Image<LinearRgb> whole = once.expose(moves, milliseconds(20), workers);
  Image<LinearRgb> sum(100, 100);
  std::size_t next = 0;
  for (int i = 1; i <= 400; ++i) {
    const Seconds end = microseconds(50 * i);
    std::vector<BeamMove> now;
    while (next < moves.size() && moves[next].begin < end) now.push_back(moves[next++]);
    const Image<LinearRgb>& slice = often.expose(now, end, workers);
    for (std::size_t p = 0; p < sum.pixels().size(); ++p) sum.pixels()[p].g += slice.pixels()[p].g;
  }
  EXPECT_NEAR(sum_of(sum), sum_of(whole), 1e-4 * sum_of(whole));
  const float peak = whole.at(50, 49).g;
  for (std::size_t p = 0; p < sum.pixels().size(); ++p) {
    ASSERT_NEAR(sum.pixels()[p].g, whole.pixels()[p].g, 2e-3f * peak);
  }
}

TEST(VectorTube, LightDecaysAsThePhosphorSays) {
  Workers workers(1);
  VectorTube tube(small_machine(), 100, 100);
  const std::vector<BeamMove> moves{line_at(Seconds(0))};
  const double first = sum_of(tube.expose(moves, milliseconds(1), workers));
  const double rest = sum_of(tube.expose({}, Seconds(5), workers));
  const Phosphor& phosphor = find_phosphor("P31").layers[0];
  double left = 0;
  for (const DecayTerm& t : phosphor.terms) left += t.share * std::exp(-960e-6 / t.tau.count());
  EXPECT_NEAR(rest / (first + rest), left, 2e-3);
}

TEST(VectorTube, AListTooLongFlickers) {
  Workers workers(1);
  // 30 ms a refresh: of frames of 10 ms, two of three draw nothing of the line.
  VectorTube tube(small_machine(), 100, 100);
  std::vector<double> frames;
  for (int i = 0; i < 30; ++i) {
    std::vector<BeamMove> moves;
    if (i % 3 == 0) moves.push_back(line_at(milliseconds(10 * i + 1)));
    frames.push_back(sum_of(tube.expose(moves, milliseconds(10 * (i + 1)), workers)));
  }
  const auto [least, most] = std::minmax_element(frames.end() - 3, frames.end());
  EXPECT_LT(*least, 0.1 * *most);
}

/// Exposures of a list that is refreshed in step with them, and of the same one drawn anew: a tube
/// that is given one more, dark move each time in another place never sees a repetition.
TEST(VectorTube, ARepeatedListShowsTheSameLight) {
  Workers workers(2);
  VectorMachine machine = small_machine();
  machine.deflection_khz = 300;  // the dynamics' state goes on as well
  machine.phosphor = "P7";
  const Seconds frame(1.0 / 60);
  VectorTube tube(machine, 100, 100), anew(machine, 100, 100);
  int cheap = 0;
  for (int i = 0; i < 80; ++i) {
    std::vector<BeamMove> moves{line_at(frame * i + microseconds(3)),
                                line_at(frame * i + milliseconds(16) + microseconds(640))};
    const Image<LinearRgb>& got = tube.expose(moves, frame * (i + 1), workers);
    cheap += !tube.changed();
    const Seconds rest = frame * i + microseconds(1000 + i);
    moves.insert(moves.begin() + 1, {90, 50.5, 90, 50.5, rest, rest, 0, {}, 0});
    const Image<LinearRgb>& want = anew.expose(moves, frame * (i + 1), workers);
    ASSERT_TRUE(anew.changed());
    const float peak = std::abs(want.at(50, 49).b);
    for (int x = 0; x < 100; ++x) {
      ASSERT_NEAR(got.at(x, 49).g, want.at(x, 49).g, 1e-3f * peak) << i << " " << x;
      ASSERT_NEAR(got.at(x, 49).b, want.at(x, 49).b, 1e-3f * peak) << i << " " << x;
    }
  }
  EXPECT_GT(cheap, 5);
  // A change is seen at once.
  std::vector<BeamMove> other{line_at(frame * 80 + microseconds(3))};
  const float none = tube.expose({}, frame * 80 + Seconds(1e-6), workers).at(50, 49).b;
  const Image<LinearRgb>& one = tube.expose(other, frame * 81, workers);
  EXPECT_TRUE(tube.changed());
  EXPECT_GT(one.at(50, 49).b, none);
}

TEST(VectorTube, ThreeGunsMixColours) {
  Workers workers(1);
  VectorMachine machine = small_machine();
  machine.phosphor = "P22";
  const auto colour_of = [&](std::array<float, 3> guns) {
    VectorTube tube(machine, 100, 100);
    std::vector<BeamMove> moves{line_at(Seconds(0))};
    moves[0].colour = guns;
    return tube.expose(moves, Seconds(10), workers).at(50, 49);
  };
  const LinearRgb white = colour_of({1, 1, 1}), red = colour_of({1, 0, 0});
  const LinearRgb green = colour_of({0, 1, 0}), blue = colour_of({0, 0, 1});
  EXPECT_NEAR(white.r, white.g, 0.01f);
  EXPECT_NEAR(white.b, white.g, 0.01f);
  EXPECT_NEAR(red.r + green.r + blue.r, white.r, 0.01f);
  EXPECT_GT(red.r, 10 * std::abs(red.b));
  EXPECT_GT(blue.b, 10 * std::abs(blue.g));
}

TEST(VectorTube, APenetrationTubesVoltagePicksTheLayer) {
  Workers workers(1);
  VectorMachine machine = small_machine();
  machine.phosphor = "P14";
  const auto colour_of = [&](bool penetration, std::array<float, 3> layers) {
    machine.penetration = penetration;
    VectorTube tube(machine, 100, 100);
    std::vector<BeamMove> moves{line_at(Seconds(0))};
    moves[0].colour = layers;
    return tube.expose(moves, Seconds(10), workers).at(50, 49);
  };
  const LinearRgb outer = colour_of(true, {1, 0, 0}), inner = colour_of(true, {0, 1, 0});
  const LinearRgb both = colour_of(true, {1, 1, 0}), one_gun = colour_of(false, {1, 0, 0});
  EXPECT_GT(outer.b, outer.r);  // purplish blue
  EXPECT_GT(inner.r, inner.b);  // orange
  EXPECT_NEAR(outer.r + inner.r, both.r, 1e-3f);
  // Any other tube's layers are lit together, whatever the colour asked for.
  EXPECT_NEAR(one_gun.r, both.r, 1e-3f);
  EXPECT_NEAR(one_gun.b, both.b, 1e-3f);
}

/// Of a beam with dynamics, many vectors in several batches.
TEST(VectorTube, IsTheSameForAnyNumberOfThreads) {
  VectorMachine machine = find_vector_machine("generic");
  machine.width = machine.height = 512;
  machine.screen_mm = 512 * 0.13;
  std::vector<BeamMove> moves;
  Seconds time(0);
  for (int i = 0; i < 30000; ++i) {
    const double x0 = i * 97 % 480, y0 = i * 61 % 470, x1 = i * 31 % 450, y1 = i * 43 % 500;
    const Seconds end = time + microseconds(1 + i % 5);
    moves.push_back({x0, y0, x1, y1, time, end, i % 2 ? 1.0f : 0.0f, {1, 1, 1}, 0});
    time = end;
  }
  const auto picture_by = [&](int threads) {
    Workers workers(threads);
    VectorTube tube(machine, 512, 512);
    return tube.expose(moves, time + microseconds(50), workers);
  };
  const Image<LinearRgb> one = picture_by(1);
  EXPECT_GT(sum_of(one), 0);
  for (const int threads : {2, 8}) {
    const Image<LinearRgb> other = picture_by(threads);
    EXPECT_TRUE(std::equal(one.pixels().begin(), one.pixels().end(), other.pixels().begin(),
                           [](const LinearRgb& a, const LinearRgb& b) {
                             return a.r == b.r && a.g == b.g && a.b == b.b;
                           }))
        << threads;
  }
}

}  // namespace
}  // namespace kinescope
