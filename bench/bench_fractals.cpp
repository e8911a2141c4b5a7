// The Mandelbrot set at 1920x1080, 1000 iterations: SIMD beside the scalar loop, and deep zoom to
// 1e-100; all on one core, medians of interleaved runs.
#include <cstdio>
#include <vector>

#include "bench/flags/flags.h"
#include "bench/program.h"
#include "bench/statistics.h"
#include "engine/fractals/deep_zoom.h"
#include "engine/fractals/escape_time.h"
#include "raster/base/workers.h"

namespace kinescope::bench {
namespace {

std::int64_t scalar_sum(const EscapeView& view) {
  std::int64_t sum = 0;
  for (int j = 0; j < view.height; ++j) {
    for (int i = 0; i < view.width; ++i) sum += escape_time(view, i, j);
  }
  return sum;
}

std::int64_t simd_sum(const EscapeView& view, Workers& workers) {
  std::int64_t sum = 0;
  for (const std::int32_t time : escape_times(view, workers)) sum += time;
  return sum;
}

int run(int argc, char** argv) {
  int pairs = 5, height = 1080;
  bool json = false;
  Flags flags("Escape-time fractals: SIMD beside the scalar loop, one core; deep zoom.");
  flags.option("--pairs", &pairs, "timed pairs", Flags::Within{1, 1000});
  flags.option("--height", &height, "of the picture, 16:9", Flags::Within{9, 4320});
  flags.flag("--json", json, "one object of figures instead of the table");
  if (const auto exit = flags.parse(argc, argv)) return *exit;
  EscapeView view;
  view.height = height;
  view.width = height * 16 / 9;
  view.step = 3.0 / height;
  Workers one(1);
  std::vector<double> scalar_ms, simd_ms, ratios;
  for (int i = 0; i < pairs; ++i) {
    std::int64_t scalar = 0, simd = 0;
    scalar_ms.push_back(milliseconds_of([&] { scalar = scalar_sum(view); }));
    simd_ms.push_back(milliseconds_of([&] { simd = simd_sum(view, one); }));
    ratios.push_back(scalar_ms.back() / simd_ms.back());
    if (scalar != simd) throw Error(ErrorKind::kBadInput, "SIMD and scalar times differ");
  }
  DeepView deep;
  deep.centre_x = "0";
  deep.centre_y = "1";
  deep.width = view.width / 4;
  deep.height = view.height / 4;
  const double deep_ms = milliseconds_of([&] { deep_escape_times(deep, one); });
  std::printf(json ? "{\"scalar_ms\": %.3f, \"simd_ms\": %.3f, \"ratio\": %.3f, "
                     "\"deep_zoom_ms\": %.3f}\n"
                   : "mandelbrot  scalar %.2f ms  SIMD %.2f ms  ratio %.2f\n"
                     "deep zoom to 1e-100, a sixteenth of the pixels: %.2f ms\n",
              median(scalar_ms), median(simd_ms), median(ratios), deep_ms);
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

int main(int argc, char** argv) {
  return kinescope::bench::run_program("bench_fractals", kinescope::bench::run, argc, argv);
}
