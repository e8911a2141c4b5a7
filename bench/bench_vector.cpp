// The vector beam: vectors of mean length 20 pixels and a spot of deviation 1 pixel onto a picture,
// the wall time of the whole picture: as even strokes, as a list that is refreshed, and by a beam
// that slews, settles and rings between dark ways.
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
#include "display/vector/drawing_moves.h"
#include "display/vector/vector_tube.h"

namespace kinescope::bench {
namespace {

struct Options {
  int width = 1920, height = 1080, vectors = 1000000, runs = 9;
  float length = 20, sigma = 1;
  std::vector<int> threads{1, 2};
  std::vector<int> planes{1};
  int list = 100000, bent = 100000;
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

/// The same vectors as a drawing on the generic machine, whose amplifiers, current and spot are
/// limited: moves, dynamics, phosphor and picture, in one exposure.
Row measure_bent(const Options& o, const std::vector<BeamStroke>& strokes, int threads) {
  Workers workers(threads);
  VectorMachine machine = find_vector_machine("generic");
  const double units = static_cast<double>(machine.width) / o.width;  // a pixel
  machine.height = static_cast<int>(units * o.height);
  machine.spot_sigma_mm = static_cast<double>(o.sigma) * machine.screen_mm / o.width;
  VectorDrawing drawing;
  drawing.size = {machine.width, machine.height};
  const auto scale = static_cast<float>(units);
  for (const BeamStroke& s : strokes) {
    drawing.line({s.x0 * scale, s.y0 * scale}, {s.x1 * scale, s.y1 * scale});
  }
  std::vector<BeamMove> moves;
  const Seconds end = draw_strokes_of(drawing, machine, Seconds(0), moves) + microseconds(100);
  std::vector<double> times;
  for (int run = 0; run < o.runs + 1; ++run) {
    VectorTube tube(machine, o.width, o.height);
    const double ms = milliseconds_of([&] { tube.expose(moves, end, workers); });
    if (run > 0 || o.runs == 1) times.push_back(ms);
  }
  const double ms = median(times);
  return {threads, 0, ms, 1e3 * static_cast<double>(strokes.size()) / ms};
}

/// Rows of one array, or lines.
class Report {
 public:
  explicit Report(bool json) : json_(json) {}
  ~Report() {
    if (json_) fmt::print("{}\n]\n", first_ ? "[" : "");
  }
  Report(const Report&) = delete;
  Report& operator=(const Report&) = delete;

  void beam(const Row& r) {
    begin();
    if (json_) {
      fmt::print(
          "{{\"workload\": \"beam\", \"threads\": {}, \"planes\": {}, \"ms\": {:.3f}, "
          "\"vectors_a_second\": {:.0f}}}",
          r.threads, r.planes, r.ms, r.vectors_a_second);
    } else {
      fmt::print("beam: {} threads, {} planes: {:.1f} ms, {:.2f} million vectors a second\n",
                 r.threads, r.planes, r.ms, 1e-6 * r.vectors_a_second);
    }
  }
  void bent(const Row& r, int vectors) {
    begin();
    if (json_) {
      fmt::print(
          "{{\"workload\": \"bent\", \"threads\": {}, \"vectors\": {}, \"ms\": {:.3f}, "
          "\"vectors_a_second\": {:.0f}}}",
          r.threads, vectors, r.ms, r.vectors_a_second);
    } else {
      fmt::print("bent beam: {} threads, {} vectors: {:.1f} ms, {:.3f} million vectors a second\n",
                 r.threads, vectors, r.ms, 1e-6 * r.vectors_a_second);
    }
  }
  void list(const ListRow& r, int vectors) {
    begin();
    if (json_) {
      fmt::print(
          "{{\"workload\": \"list\", \"threads\": {}, \"vectors\": {}, \"drawn_ms\": {:.3f}, "
          "\"repeated_ms\": {:.3f}, \"balanced_ms\": {:.3f}}}",
          r.threads, vectors, r.drawn_ms, r.repeated_ms, r.balanced_ms);
    } else {
      fmt::print(
          "list of {} vectors: {} threads: drawn {:.1f} ms, repeated {:.1f} ms ({:.3f}), in "
          "balance {:.2f} ms ({:.4f})\n",
          vectors, r.threads, r.drawn_ms, r.repeated_ms, r.repeated_ms / r.drawn_ms, r.balanced_ms,
          r.balanced_ms / r.drawn_ms);
    }
  }

 private:
  void begin() {
    if (json_) fmt::print("{}\n  ", first_ ? "[" : ",");
    first_ = false;
  }
  bool json_, first_ = true;
};

int run(int argc, char** argv) {
  Options o;
  Flags flags("Times the vector beam: many strokes onto a dark picture");
  flags.option("--width", &o.width, "of the picture", Flags::Within{1, 16384});
  flags.option("--height", &o.height, "of the picture", Flags::Within{1, 16384});
  flags.option("--vectors", &o.vectors, "a picture; 0: none", Flags::Within{0, 100000000});
  flags.option("--length", &o.length, "mean, pixels", Flags::Within{0.0, 10000.0});
  flags.option("--sigma", &o.sigma, "of the spot, pixels", Flags::Within{0.1, 30.0});
  flags.option("--threads", &o.threads, "each a row");
  flags.option("--planes", &o.planes, "drawn on at once; each a row");
  flags.option("--list", &o.list, "vectors of a list that is refreshed; 0: none",
               Flags::Within{0, 10000000});
  flags.option("--bent", &o.bent, "vectors of a beam with dynamics; 0: none",
               Flags::Within{0, 10000000});
  flags.option("--runs", &o.runs, "timed", Flags::Within{1, 1000});
  flags.flag("--json", o.json, "a list instead of a table");
  if (const auto exit = flags.parse(argc, argv)) return *exit;
  const auto of_count = [&](int vectors) {
    Options other = o;
    other.vectors = vectors;
    return other;
  };
  Report report(o.json);
  const std::vector<BeamStroke> strokes = random_strokes(o);
  for (const int planes : o.planes) {
    if (o.vectors == 0) break;
    for (const int threads : o.threads) report.beam(measure(o, strokes, threads, planes));
  }
  const std::vector<BeamStroke> bent = random_strokes(of_count(o.bent));
  for (const int threads : o.threads) {
    if (!bent.empty()) report.bent(measure_bent(o, bent, threads), o.bent);
  }
  if (o.list == 0) return 0;
  const Options list = of_count(o.list);
  report.list(measure_list(list, random_strokes(list), o.threads.back()), o.list);
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

int main(int argc, char** argv) {
  return kinescope::bench::run_program("bench_vector", kinescope::bench::run, argc, argv);
}
