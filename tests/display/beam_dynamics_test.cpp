#include "display/vector/beam_dynamics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "display/vector/beam_cutter.h"
#include "display/vector/beam_painter.h"
#include "raster/image/image.h"

namespace kinescope {
namespace {

/// 64 x 64 units of a millimetre.
VectorMachine small_machine() {
  VectorMachine m;
  m.width = m.height = 64;
  m.screen_mm = 64;
  m.spot_sigma_mm = 1;
  m.deflection_khz = 500;
  m.damping = 0.5;
  return m;
}

BeamMove move_of(double x0, double y0, double x1, double y1, double begin_us, double us,
                 float intensity = 1) {
  return {x0,        y0,        x1, y1, microseconds(begin_us), microseconds(begin_us + us),
          intensity, {1, 1, 1}, 0};
}

/// The oracle: the law in small steps by Runge and Kutta, of one axis.
class SteppedAxis {
 public:
  SteppedAxis(const VectorMachine& m)
      : w_(2 * std::numbers::pi * DeflectionLaw{m.deflection_khz, m.damping, 0}.natural_hz()),
        damping_(m.damping),
        slew_(m.slew_mm_us > 0 ? m.slew_mm_us * 1e6 * m.width / m.screen_mm : 1e30) {}

  void step(double command, double dt) {
    const double most = slew_ * dt, before = stage_;
    stage_ += std::clamp(command - stage_, -most, most);
    const auto pull = [&](double at, double speed, double t) {
      return w_ * w_ * (std::lerp(before, stage_, t) - at) - 2 * damping_ * w_ * speed;
    };
    const double v1 = v, a1 = pull(x, v, 0);
    const double v2 = v + dt / 2 * a1, a2 = pull(x + dt / 2 * v1, v2, 0.5);
    const double v3 = v + dt / 2 * a2, a3 = pull(x + dt / 2 * v2, v3, 0.5);
    const double v4 = v + dt * a3, a4 = pull(x + dt * v3, v4, 1);
    x += dt / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    v += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  double x = 0, v = 0;

 private:
  double w_, damping_, slew_, stage_ = 0;
};

/// Where the moves ask for the beam at a time.
std::pair<double, double> asked_at(const std::vector<BeamMove>& moves, double t) {
  std::pair<double, double> asked{0, 0};
  for (const BeamMove& m : moves) {
    if (t < m.begin.count()) break;
    const double share = std::min(1.0, (t - m.begin.count()) / (m.end - m.begin).count());
    asked = {std::lerp(m.x0, m.x1, share), std::lerp(m.y0, m.y1, share)};
  }
  return asked;
}

/// The mean current that they ask for in a step of time.
double asked_current(const std::vector<BeamMove>& moves, double from, double to) {
  double sum = 0;
  for (const BeamMove& m : moves) {
    const double lit = std::min(to, m.end.count()) - std::max(from, m.begin.count());
    sum += std::max(0.0, lit) * static_cast<double>(m.intensity);
  }
  return sum / (to - from);
}

constexpr int kScale = 2;

/// Light of a beam in small steps: at each a spot at rest, integrated over pixels.
Image<double> stepped_picture(const VectorMachine& m, const std::vector<BeamMove>& moves,
                              double end_us, double dt_us = 0.0025) {
  const int size = 64 * kScale;
  Image<double> light(size, size);
  SteppedAxis x(m), y(m);
  const double dt = dt_us * 1e-6, lag = DeflectionLaw{m.deflection_khz, m.damping, 0}.lag().count();
  const double tau = m.intensity_mhz > 0 ? 1 / (2e6 * std::numbers::pi * m.intensity_mhz) : 0;
  double current = 0;
  const auto below = [](double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); };
  for (double t = 0; t < end_us * 1e-6; t += dt) {
    const auto [asked_x, asked_y] = asked_at(moves, t + dt);
    const double before_x = x.x, before_y = y.x;
    x.step(asked_x, dt);
    y.step(asked_y, dt);
    const double aim = asked_current(moves, t - lag, t + dt - lag);
    const double next = tau > 0 ? aim + (current - aim) * std::exp(-dt / tau) : aim;
    const double dose = 0.5 * (tau > 0 ? current + next : 2 * aim) * dt;
    current = next;
    if (dose < 1e-14) continue;
    const double sigma =
        kScale * m.spot_sigma_mm * std::pow(std::max(0.02, dose / dt), m.spot_growth);
    const double cx = kScale * 0.5 * (x.x + before_x), cy = size - kScale * 0.5 * (y.x + before_y);
    for (int row = std::max(0, int(cy - 6 * sigma)); row < std::min<double>(size, cy + 6 * sigma);
         ++row) {
      const double down = below((row + 1 - cy) / sigma) - below((row - cy) / sigma);
      for (int col = std::max(0, int(cx - 6 * sigma)); col < std::min<double>(size, cx + 6 * sigma);
           ++col) {
        light.at(col, row) +=
            dose * down * (below((col + 1 - cx) / sigma) - below((col - cx) / sigma));
      }
    }
  }
  return light;
}

std::vector<BeamPiece> pieces_of(const VectorMachine& m, const std::vector<BeamSpan>& spans) {
  const BeamCutter cutter(m);
  std::vector<BeamPiece> pieces;
  for (const BeamSpan& span : spans) cutter.cut(span, span.from, span.to, pieces);
  return pieces;
}

/// What pieces leave on 64 x 64 units, so many pixels each.
BeamMarks marks_of(const VectorMachine& m, const std::vector<BeamPiece>& pieces, int scale) {
  BeamMarks marks;
  const auto pixels = static_cast<float>(scale), size = 64 * pixels;
  const auto at = [&](double v) { return pixels * static_cast<float>(v); };
  const float sigma = pixels * static_cast<float>(m.spot_sigma_mm);
  for (const BeamPiece& p : pieces) {
    const float dose = p.current * static_cast<float>(p.to - p.from);
    if (p.spots == 0) {
      marks.strokes.push_back(
          {at(p.x[0]), size - at(p.y[0]), at(p.x[1]), size - at(p.y[1]), sigma * p.spread[0]});
      marks.stroke_weights.push_back(dose);
      continue;
    }
    BeamSpots spots;
    spots.count = p.spots;
    for (std::size_t i = 0; i < static_cast<std::size_t>(p.spots); ++i) {
      spots.x[i] = at(p.x[i]), spots.y[i] = size - at(p.y[i]);
      spots.sigma[i] = sigma * p.spread[i], spots.share[i] = p.share[i];
    }
    marks.spots.push_back(spots);
    marks.spot_weights.push_back(dose);
  }
  return marks;
}

TiledLight picture_of(const VectorMachine& m, const std::vector<BeamMove>& moves, double end_us,
                      int scale = kScale, int slices = 1) {
  BeamDynamics dynamics(m);
  std::vector<BeamSpan> spans;
  std::size_t next = 0;
  for (int i = 1; i <= slices; ++i) {
    const Seconds end = microseconds(end_us * i / slices);
    const std::size_t first = next;
    while (next < moves.size() && moves[next].begin < end) ++next;
    dynamics.follow(std::span(moves).subspan(first, next - first), end, spans);
  }
  BeamMarks marks = marks_of(m, pieces_of(m, spans), scale);
  Workers workers(1);
  TiledLight light(64 * scale, 64 * scale, 1);
  BeamPainter().draw(std::span(&marks, 1), light, workers);
  return light;
}

double sum_of(const TiledLight& light) {
  double sum = 0;
  for (int y = 0; y < light.height(); ++y) {
    for (int x = 0; x < light.width(); ++x) sum += static_cast<double>(light.at(0, x, y));
  }
  return sum;
}

/// A jump, a slow and a fast line with a corner between, a point, a rest.
std::vector<BeamMove> figure() {
  return {move_of(0, 0, 20, 20, 0, 1, 0),        move_of(20, 20, 20, 20, 1, 5, 0),
          move_of(20, 20, 45, 24, 6, 6),         move_of(45, 24, 22, 45, 12, 2.5),
          move_of(22, 45, 42, 45, 14.5, 3, 0),   move_of(42, 45, 42, 45, 17.5, 0.7),
          move_of(42, 45, 15, 52, 18.2, 2, 0.4f)};
}

/// As fast as a list is drawn: lines with a corner between, a short one, dark ways.
std::vector<BeamMove> fast_figure() {
  return {move_of(0, 0, 20, 20, 0, 3, 0),           move_of(20, 20, 45, 24, 3, 1.35),
          move_of(45, 24, 22, 45, 4.35, 1.65),      move_of(22, 45, 42, 36, 6, 2.5, 0),
          move_of(42, 36, 41, 39, 8.5, 0.17),       move_of(41, 39, 12, 20, 8.67, 2.8, 0),
          move_of(12, 20, 12, 52, 11.47, 1.7, 0.4f)};
}

void expect_as_stepped(const VectorMachine& m, const std::vector<BeamMove>& moves = figure()) {
  const Image<double> want = stepped_picture(m, moves, 24);
  const TiledLight got = picture_of(m, moves, 24);
  double most = 0, worst = 0;
  for (const double v : want.pixels()) most = std::max(most, v);
  for (int y = 0; y < want.height(); ++y) {
    for (int x = 0; x < want.width(); ++x) {
      worst = std::max(worst, std::abs(static_cast<double>(got.at(0, x, y)) - want.at(x, y)));
    }
  }
  EXPECT_LT(worst / most, 1e-3) << m.damping << " " << m.slew_mm_us << " " << m.intensity_mhz;
}

TEST(BeamDynamics, DrawsWhatTheLawDoesInSmallSteps) {
  for (const double damping : {0.3, 0.7, 1.0, 1.8}) {
    VectorMachine m = small_machine();
    m.damping = damping;
    expect_as_stepped(m);
  }
  VectorMachine m = small_machine();
  m.slew_mm_us = 8;
  expect_as_stepped(m);
  m.intensity_mhz = 2;
  expect_as_stepped(m);
  m.spot_growth = 0.33;
  m.intensity_mhz = 0;
  expect_as_stepped(m);
}

TEST(BeamDynamics, DrawsAListsVectorsAsTheLawDoesInSmallSteps) {
  VectorMachine m = find_vector_machine("generic");
  m.width = m.height = 64;
  m.screen_mm = 64;
  m.spot_sigma_mm = 1;
  m.slew_mm_us = 60;
  expect_as_stepped(m, fast_figure());
  m.spot_growth = 0;
  expect_as_stepped(m, fast_figure());
}

/// The fast way of letting a transient settle, and the closed form.
TEST(BeamDynamics, ShortStepsAreTheClosedForm) {
  for (const double damping : {0.0, 0.3, 0.7, 1.0, 1.8}) {
    const Settling law(DeflectionLaw{700, damping, 0});
    const double tick = law.short_time() / 7;
    std::array<double, Settling::kSteps> times;
    for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i) * tick;
    const auto together = law.short_steps(times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Settling::Step want = law.closed_step(times[i]), got = law.short_step(times[i]);
      EXPECT_NEAR(got.answer, want.answer, 1e-7 * tick) << damping << " " << i;
      EXPECT_NEAR(got.speed, want.speed, 1e-7) << damping << " " << i;
      EXPECT_NEAR(together[i].answer, want.answer, 1e-7 * tick) << damping << " " << i;
      EXPECT_NEAR(together[i].speed, want.speed, 1e-7) << damping << " " << i;
    }
  }
}

TEST(BeamDynamics, KeepsEveryBitOfEnergyAtAnyResolution) {
  VectorMachine m = small_machine();
  m.slew_mm_us = 8;
  m.spot_growth = 0.33;
  for (const double mhz : {0.0, 2.0}) {
    m.intensity_mhz = mhz;
    for (const int scale : {1, 2, 5, 16}) {
      // Lit for 6, 2.5, 0.7, and 2 us at 0.4.
      EXPECT_NEAR(sum_of(picture_of(m, figure(), 40, scale)), 10e-6, 10e-9) << scale;
    }
  }
}

TEST(BeamDynamics, OvershootsByItsDamping) {
  for (const double damping : {0.2, 0.5, 0.7}) {
    VectorMachine m = small_machine();
    m.damping = damping;
    BeamDynamics dynamics(m);
    std::vector<BeamSpan> spans;
    const std::vector<BeamMove> jump{move_of(40, 0, 40, 0, 0, 0.001, 0)};
    double most = 0;
    for (int i = 1; i < 4000; ++i) {
      dynamics.follow(i == 1 ? jump : std::vector<BeamMove>{}, microseconds(0.002 * i), spans);
      most = std::max(most, dynamics.x());
    }
    const double want =
        1 + std::exp(-std::numbers::pi * damping / std::sqrt(1 - damping * damping));
    EXPECT_NEAR(most / 40, want, 1e-3 * want);
    EXPECT_TRUE(spans.empty());
  }
}

TEST(BeamDynamics, TheGenericMachineSettlesAsTheVr14Did) {
  const VectorMachine& m = find_vector_machine("generic");
  const std::vector<BeamMove> jump{move_of(4095, 0, 4095, 0, 0, 0.001, 0)};
  const auto miss_mm = [&](double us) {
    BeamDynamics dynamics(m);
    std::vector<BeamSpan> spans;
    dynamics.follow(jump, microseconds(us), spans);
    return std::abs(dynamics.x() - 4095) * m.screen_mm / m.width;
  };
  // To half of its spot of 0.02 inch.
  EXPECT_LT(miss_mm(18), 0.25);
  EXPECT_GT(miss_mm(16), 0.25);
}

TEST(BeamDynamics, AnEvenMotionLagsAndItsCurrentWithIt) {
  const VectorMachine m = small_machine();
  BeamDynamics dynamics(m);
  std::vector<BeamSpan> spans;
  const std::vector<BeamMove> line{move_of(0, 32, 60, 32, 0, 60)};
  dynamics.follow(line, microseconds(40), spans);
  const Seconds lag = DeflectionLaw{m.deflection_khz, m.damping, 0}.lag();
  EXPECT_NEAR(dynamics.x(), 40 - lag.count() * 1e6, 1e-9);
  EXPECT_NEAR((spans.front().begin() - lag).count(), 0, 1e-12);
}

/// Green of a pixel over the middle of the first line of two that meet at a right angle.
double light_at(const TiledLight& light, double x, double y) {
  return static_cast<double>(light.at(0, static_cast<int>(x), 63 - static_cast<int>(y)));
}

TEST(BeamDynamics, CornersGlowByTheTimeThatTheBeamTakesToTurn) {
  VectorMachine m = small_machine();
  m.damping = 1;
  m.deflection_khz = 200;
  // There and back again: the beam stands still at the turn.
  const std::vector<BeamMove> moves{move_of(8, 32, 8, 32, 0, 10, 0), move_of(8, 32, 48, 32, 10, 10),
                                    move_of(48, 32, 8, 32, 20, 10)};
  const TiledLight light = picture_of(m, moves, 40, 1);
  const double middle = light_at(light, 28, 32);
  double most = 0;
  for (int x = 40; x < 56; ++x) most = std::max(most, light_at(light, x, 32));
  // An ideal beam's turn is no brighter than its way.
  EXPECT_GT(most / middle, 1.15);
  m.deflection_khz = 0;
  const TiledLight ideal = picture_of(m, moves, 40, 1);
  double brightest = 0;
  for (int x = 40; x < 56; ++x) brightest = std::max(brightest, light_at(ideal, x, 32));
  EXPECT_LT(brightest / light_at(ideal, 28, 32), 1.001);
}

TEST(BeamDynamics, LightIsAsTheCurrentAndTheTimeTaken) {
  VectorMachine m = small_machine();
  const auto middle = [&](double us, float current) {
    const std::vector<BeamMove> moves{move_of(8, 32.5, 8, 32.5, 0, 10, 0),
                                      move_of(8, 32.5, 56, 32.5, 10, us, current)};
    return light_at(picture_of(m, moves, 100, 1), 32, 32);
  };
  const double usual = middle(10, 1);
  EXPECT_NEAR(middle(20, 1), 2 * usual, 2e-3 * usual);
  EXPECT_NEAR(middle(10, 0.5f), 0.5 * usual, 1e-3 * usual);
  // A third as wide a spot, but for the pixel's own width.
  m.spot_growth = 0.5;
  EXPECT_GT(middle(10, 0.25f), 0.42 * usual);
}

TEST(BeamDynamics, TheSpotIsWiderTowardsTheEdge) {
  VectorMachine m = small_machine();
  m.edge_spread = 1;
  BeamDynamics dynamics(m);
  std::vector<BeamSpan> spans;
  const std::vector<BeamMove> line{move_of(0, 32, 64, 32, 0, 30)};
  dynamics.follow(line, microseconds(60), spans);
  const std::vector<BeamPiece> pieces = pieces_of(m, spans);
  EXPECT_NEAR(pieces.back().spread[0], 2, 0.1);
  const auto thin = std::min_element(pieces.begin(), pieces.end(),
                                     [](auto& a, auto& b) { return a.spread[0] < b.spread[0]; });
  EXPECT_NEAR(thin->spread[0], 1, 0.01);
  EXPECT_NEAR(thin->x[0], 32, 2);
}

TEST(BeamDynamics, IsTheSameInSlices) {
  VectorMachine m = small_machine();
  m.slew_mm_us = 8;
  m.intensity_mhz = 2;
  const TiledLight whole = picture_of(m, figure(), 24),
                   slices = picture_of(m, figure(), 24, kScale, 241);
  double most = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) most = std::max(most, double{whole.at(0, x, y)});
  }
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      ASSERT_NEAR(whole.at(0, x, y), slices.at(0, x, y), 2e-3 * most) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace kinescope
