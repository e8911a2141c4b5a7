// Time against size, count, pixels or threads: the points of one curve.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "bench/flags/flags.h"
#include "bench/peer_llvmpipe.h"
#include "bench/program.h"
#include "bench/statistics.h"
#include "bench/workload_kinds.h"
#include "engine/renderer.h"
#include "raster/base/error.h"

namespace kinescope::bench {
namespace {

struct Options {
  std::string curve;
  std::vector<int> samples{1, 4};
  int threads = 2, pairs = 3;
  bool json = false;
};

/// A point of a curve: what is drawn, where it lies on the axis, and what it cost.
struct Point {
  double x = 0;
  int width = 1920, height = 1080, samples = 1;
  std::string workload = {};
  RasterStats stats = {};
  double ours_ms = 0, peer_ms = 0;
  double spread = 1;  ///< our slowest frame over our fastest: far from 1, the machine was busy
};
using Points = std::vector<Point>;

Point measured(const Options& options, const Workload& workload, Point at) {
  Workers workers(options.threads);
  Renderer renderer(workers);
  RenderTarget target(at.width, at.height, at.samples, ColourFormat::kLinear8);
  RenderSettings settings;
  settings.shading = workload.shading;
  LlvmpipePeer peer(workload, at.width, at.height, at.samples);
  std::vector<double> ours_ms, peer_ms;
  constexpr int kWarmUp = 1;
  for (int frame = 0; frame < options.pairs + kWarmUp; ++frame) {
    const Camera camera =
        workload.camera(frame, static_cast<float>(at.width) / static_cast<float>(at.height));
    const double ours = milliseconds_of(
        [&] { at.stats = renderer.render(workload.scene, camera, settings, target).raster; });
    const double theirs = peer.draw(camera);
    if (frame < kWarmUp) continue;
    ours_ms.push_back(ours);
    peer_ms.push_back(theirs);
  }
  at.workload = workload.name;
  at.ours_ms = median(ours_ms);
  at.peer_ms = median(peer_ms);
  const auto [fastest, slowest] = std::minmax_element(ours_ms.begin(), ours_ms.end());
  at.spread = *slowest / *fastest;
  return at;
}

/// Triangles with legs of 1 to 500 pixels.
Points size_curve(const Options& options) {
  constexpr int kMost = 200'000;
  Points points;
  for (const int leg : {1, 2, 3, 5, 7, 10, 14, 20, 30, 50, 100, 200, 500}) {
    Workload workload = sweep_workload(leg, kMost);
    workload.name = "sweep";
    for (const int samples : options.samples) {
      points.push_back(measured(options, workload, {double(leg), 1920, 1080, samples}));
    }
  }
  return points;
}

/// A knot of a thousand to ten million triangles.
Points count_curve(const Options& options) {
  Points points;
  for (const double wanted : {1e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6, 1e7}) {
    const int around = std::max(4, static_cast<int>(std::lround(std::sqrt(wanted / 64))));
    const int along = static_cast<int>(std::lround(wanted / (2 * around)));
    Workload workload = knot_workload({along, around, ShadingModel::kGouraud, false});
    workload.name = "knot";
    for (const int samples : options.samples) {
      points.push_back(measured(options, workload, {2.0 * along * around, 1920, 1080, samples}));
    }
  }
  return points;
}

/// From 640x360 to 7680x4320.
Points pixels_curve(const Options& options) {
  const Workload workload = make_workload("knot-phong");
  Points points;
  for (const int height : {360, 540, 720, 1080, 1440, 2160, 4320}) {
    const int width = height * 16 / 9;
    for (const int samples : options.samples) {
      points.push_back(
          measured(options, workload, {double(width) * height, width, height, samples}));
    }
  }
  return points;
}

/// Two frames, by the number of threads asked for: llvmpipe keeps the number that it began with.
Points threads_curve(const Options& options) {
  Points points;
  for (const char* name : {"knot-phong", "knot-gouraud"}) {
    points.push_back(measured(options, make_workload(name), {double(options.threads)}));
  }
  return points;
}

void print_json(const Options& options, const Points& points) {
  const char* separator = "[";
  for (const Point& p : points) {
    fmt::print(
        "{}\n  {{\"curve\": \"{}\", \"workload\": \"{}\", \"x\": {}, \"samples\": {}, "
        "\"threads\": {}, \"pixels\": {}, \"triangles\": {}, \"drawn\": {}, \"fragments\": {}, "
        "\"ours_ms\": {:.4f}, \"peer_ms\": {:.4f}, \"spread\": {:.3f}}}",
        separator, options.curve, p.workload, p.x, p.samples, options.threads,
        std::int64_t{p.width} * p.height, p.stats.triangles, p.stats.drawn, p.stats.fragments,
        p.ours_ms, p.peer_ms, p.spread);
    separator = ",";
  }
  fmt::print("\n]\n");
}

void print_table(const Points& points) {
  fmt::print("{:<14}{:>12}{:>9}{:>12}{:>12}{:>10}{:>10}\n", "workload", "at", "samples",
             "triangles", "fragments", "ours ms", "peer ms");
  for (const Point& p : points) {
    fmt::print("{:<14}{:>12}{:>9}{:>12}{:>12}{:>10.2f}{:>10.2f}\n", p.workload, p.x, p.samples,
               p.stats.triangles, p.stats.fragments, p.ours_ms, p.peer_ms);
  }
}

int run(int argc, char** argv) {
  Options options;
  Flags flags("The points of one cost curve, ours and llvmpipe's.");
  const std::map<std::string, Points (*)(const Options&)> curves = {{"size", size_curve},
                                                                    {"count", count_curve},
                                                                    {"pixels", pixels_curve},
                                                                    {"threads", threads_curve}};
  flags.option("--curve", &options.curve, "size, count, pixels, or threads (one point of it)",
               Flags::OneOf{{"size", "count", "pixels", "threads"}}, Flags::Need::kRequired);
  flags.option("--samples", &options.samples, "samples a pixel: 1, 4", Flags::OneOf{{"1", "4"}});
  flags.option("--threads", &options.threads, "threads of each", Flags::Within{1, 64});
  flags.option("--pairs", &options.pairs, "timed pairs of frames", Flags::Within{1, 1000});
  flags.flag("--json", options.json, "a list of figures instead of the table");
  if (const auto exit = flags.parse(argc, argv)) return *exit;
  LlvmpipePeer::set_threads(options.threads);
  const Points points = curves.at(options.curve)(options);
  options.json ? print_json(options, points) : print_table(points);
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

int main(int argc, char** argv) {
  return kinescope::bench::run_program("bench_curves", kinescope::bench::run, argc, argv);
}
