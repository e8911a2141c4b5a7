// Coverage of any number of random triangles against the oracle, family after family.
// exactness_run --triangles 100000000 is the long run; the tests run a million.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "bench/flags/flags.h"
#include "tests/exactness/families.h"
#include "tests/exactness/near_eye.h"

namespace kinescope::exactness {
namespace {

struct Options {
  std::uint64_t triangles = 1'000'000;
  unsigned seed = 1;
  double minutes = 0;  ///< 0: until all triangles are done
};

struct Totals {
  Tally device;
  std::uint64_t homogeneous_samples = 0, homogeneous_differing = 0;
};

/// One sheet of every family, and triangles near the eye.
void run_round(Comparer& comparer, unsigned seed, int samples, Totals& totals) {
  for (const Family family : kFamilies) {
    totals.device += compare(comparer, family, seed, samples);
  }
  const NearEyeTally near_eye = compare_near_eye(comparer, 64, seed, samples);
  totals.device += near_eye.device;
  totals.homogeneous_samples += near_eye.samples;
  totals.homogeneous_differing += near_eye.samples_differing;
}

int run(const Options& options) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  const bool terminal = isatty(STDERR_FILENO) != 0;
  Comparer comparer;
  Totals totals;
  for (unsigned round = 0; totals.device.triangles < options.triangles; ++round) {
    if (options.minutes > 0 && seconds() > 60 * options.minutes) break;
    const int samples = std::array{1, 4, 8}[round % 3];
    // Three rounds share a seed, so that each sheet is drawn at every sample count.
    run_round(comparer, options.seed + round / 3, samples, totals);
    if (terminal) {
      fmt::print(stderr, "\r{:.1f} of {:.1f} million triangles, {:.0f} s ",
                 static_cast<double>(totals.device.triangles) / 1e6,
                 static_cast<double>(options.triangles) / 1e6, seconds());
    }
  }
  if (terminal) fmt::print(stderr, "\n");
  fmt::print(
      "{} triangles, {} samples compared, {} triangles differ; near the eye {} samples in "
      "homogeneous coordinates, {} differ; {:.0f} s\n",
      totals.device.triangles, totals.device.samples, totals.device.differing,
      totals.homogeneous_samples, totals.homogeneous_differing, seconds());
  return totals.device.differing + totals.homogeneous_differing == 0 ? 0 : 1;
}

}  // namespace
}  // namespace kinescope::exactness

int main(int argc, char** argv) {
  kinescope::exactness::Options options;
  kinescope::Flags flags(
      "Coverage of random triangles at 1, 4 and 8 samples against an independent oracle.");
  flags.option("--triangles", &options.triangles, "how many, at least");
  flags.option("--seed", &options.seed, "where the random numbers begin");
  flags.option("--minutes", &options.minutes, "stop after this long; 0: never");
  if (const auto exit = flags.parse(argc, argv)) return *exit;
  return kinescope::exactness::run(options);
}
