// The vector beam: vectors of mean length 20 pixels and a spot of deviation 1 pixel onto a picture,
// the wall time of the whole picture.
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "bench/flags/flags.h"
#include "bench/program.h"
#include "bench/statistics.h"
#include "display/vector/beam_painter.h"
#include "display/vector/vector_tube.h"

namespace kinescope::bench {
namespace {

struct Options {
  int width = 1920, height = 1080, vectors = 1000000, runs = 9;
  float length = 20, sigma = 1;
  std::vector<int> threads{1, 2};
  std::vector<int> planes{1};
  int list = 100000;
  bool json = false;
};

struct Row {
  int threads, planes;
  double ms, vectors_a_second;
};

/// Random places and directions, lengths even from nothing to twice the mean.
std::vector<BeamStroke> random_strokes(const Options& o) {
  std::mt19937 random(1);
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  std::vector<BeamStroke> strokes;
  for (int i = 0; i < o.vectors; ++i) {
    const float x = between(0, static_cast<float>(o.width));
    const float y = between(0, static_cast<float>(o.height));
    const float angle = between(0, 2 * std::numbers::pi_v<float>);
    const float length = between(0, 2 * o.length);
    strokes.push_back({x, y, x + length * std::cos(angle), y + length * std::sin(angle), o.sigma});
  }
  return strokes;
}

Row measure(const Options& o, const std::vector<BeamStroke>& strokes, int threads, int planes) {
  Workers workers(threads);
  TiledLight light(o.width, o.height, planes);
  const std::vector<float> weights(strokes.size() * static_cast<std::size_t>(planes), 1.0f);
  BeamPainter painter;
  std::vector<double> times;
  for (int run = 0; run < o.runs + 1; ++run) {
    const double ms = milliseconds_of([&] {
      light.clear();
      painter.draw(strokes, weights, light, workers);
    });
    if (run > 0) times.push_back(ms);
  }
  const double ms = median(times);
  return {threads, planes, ms, 1e3 * o.vectors / ms};
}

/// A list that is refreshed: an exposure in which it is drawn, one that adds its light again, and
/// one in balance. Of a tube that draws it anew each time every vector's time changes.
struct ListRow {
  int threads;
  double drawn_ms, repeated_ms, balanced_ms;
};

ListRow measure_list(const Options& o, const std::vector<BeamStroke>& strokes, int threads) {
  Workers workers(threads);
  VectorMachine machine = find_vector_machine("generic");
  machine.width = o.width, machine.height = o.height;
  machine.screen_mm = o.width, machine.spot_sigma_mm = static_cast<double>(o.sigma);
  machine.deflection_khz = machine.slew_mm_us = machine.intensity_mhz = machine.spot_growth = 0;
  VectorTube tube(machine, o.width, o.height);
  const Seconds frame(1.0 / 60), each = 0.99 * frame / static_cast<double>(strokes.size());
  std::vector<BeamMove> moves(strokes.size());
  std::array<std::vector<double>, 3> times;
  Seconds now{0};
  for (int run = 0; run < o.runs; ++run) {
    for (int i = 0; i < 60; ++i, now += frame) {
      // Backwards in every other run: no repetition of the one before.
      for (std::size_t m = 0; m < moves.size(); ++m) {
        const BeamStroke& s = strokes[run % 2 ? moves.size() - 1 - m : m];
        const Seconds at = now + each * static_cast<double>(m);
        moves[m] = {s.x0, o.height - s.y0, s.x1, o.height - s.y1, at, at + each, 1, {1, 1, 1}, 0};
      }
      const double ms = milliseconds_of([&] { tube.expose(moves, now + frame, workers); });
      if (i == 1 || i == 5 || i == 59) times[i == 1 ? 0 : i == 5 ? 1 : 2].push_back(ms);
    }
  }
  return {threads, median(times[0]), median(times[1]), median(times[2])};
}

int run(int argc, char** argv) {
  Options o;
  Flags flags("Times the vector beam: many strokes onto a dark picture");
  flags.option("--width", &o.width, "of the picture", Flags::Within{1, 16384});
  flags.option("--height", &o.height, "of the picture", Flags::Within{1, 16384});
  flags.option("--vectors", &o.vectors, "a picture", Flags::Within{1, 100000000});
  flags.option("--length", &o.length, "mean, pixels", Flags::Within{0.0, 10000.0});
  flags.option("--sigma", &o.sigma, "of the spot, pixels", Flags::Within{0.1, 30.0});
  flags.option("--threads", &o.threads, "each a row");
  flags.option("--planes", &o.planes, "drawn on at once; each a row");
  flags.option("--list", &o.list, "vectors of a list that is refreshed; 0: none",
               Flags::Within{0, 10000000});
  flags.option("--runs", &o.runs, "timed", Flags::Within{1, 1000});
  flags.flag("--json", o.json, "a list instead of a table");
  if (const auto exit = flags.parse(argc, argv)) return *exit;
  const std::vector<BeamStroke> strokes = random_strokes(o);
  std::vector<Row> rows;
  for (const int planes : o.planes) {
    for (const int threads : o.threads) rows.push_back(measure(o, strokes, threads, planes));
  }
  if (o.json) fmt::print("[");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& r = rows[i];
    if (o.json) {
      fmt::print(
          "{}\n  {{\"workload\": \"beam\", \"threads\": {}, \"planes\": {}, \"ms\": {:.3f}, "
          "\"vectors_a_second\": {:.0f}}}",
          i ? "," : "", r.threads, r.planes, r.ms, r.vectors_a_second);
    } else {
      fmt::print("beam: {} threads, {} planes: {:.1f} ms, {:.2f} million vectors a second\n",
                 r.threads, r.planes, r.ms, 1e-6 * r.vectors_a_second);
    }
  }
  if (o.list > 0) {
    Options list = o;
    list.vectors = o.list;
    const ListRow r = measure_list(list, random_strokes(list), o.threads.back());
    if (o.json) {
      fmt::print(
          ",\n  {{\"workload\": \"list\", \"threads\": {}, \"vectors\": {}, \"drawn_ms\": {:.3f}, "
          "\"repeated_ms\": {:.3f}, \"balanced_ms\": {:.3f}}}",
          r.threads, o.list, r.drawn_ms, r.repeated_ms, r.balanced_ms);
    } else {
      fmt::print(
          "list of {} vectors: {} threads: drawn {:.1f} ms, repeated {:.1f} ms ({:.3f}), in "
          "balance "
          "{:.2f} ms ({:.4f})\n",
          o.list, r.threads, r.drawn_ms, r.repeated_ms, r.repeated_ms / r.drawn_ms, r.balanced_ms,
          r.balanced_ms / r.drawn_ms);
    }
  }
  if (o.json) fmt::print("\n]\n");
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

int main(int argc, char** argv) {
  return kinescope::bench::run_program("bench_vector", kinescope::bench::run, argc, argv);
}
