// Random frames for as long as asked: each drawn by the fast path in several ways and by the
// reference. Ends with exit code 1 at the first that disagrees, and says how to draw it again.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "bench/flags/flags.h"
#include "raster/base/error.h"
#include "tests/soak/random_frame.h"

namespace kinescope::soak {
namespace {

std::string check(std::uint64_t seed) {
  try {
    return seed % 3 == 2 ? check_random_scene(seed) : check_random_frame(seed);
  } catch (const Error& error) {
    return std::string("an error: ") + error.what();
  }
}

int run(double minutes, std::uint64_t seed, std::uint64_t frames) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(60 * minutes);
  std::uint64_t drawn = 0;
  while (drawn < frames && std::chrono::steady_clock::now() < end) {
    const std::string fault = check(seed);
    if (!fault.empty()) {
      fmt::print("{}\nsoak_scenes --seed {} --frames 1 draws it again\n", fault, seed);
      return 1;
    }
    ++seed;
    ++drawn;
  }
  fmt::print("{} frames, none disagreed; the next seed is {}\n", drawn, seed);
  return 0;
}

}  // namespace
}  // namespace kinescope::soak

int main(int argc, char** argv) {
  double minutes = 1;
  std::uint64_t seed = 1, frames = ~std::uint64_t{0};
  kinescope::Flags flags("Random scenes against the reference rasterizer, and against themselves.");
  flags.option("--minutes", &minutes, "how long");
  flags.option("--seed", &seed, "of the first frame; each takes the next");
  flags.option("--frames", &frames, "how many at most");
  if (const auto exit = flags.parse(argc, argv)) return *exit;
  return kinescope::soak::run(minutes, seed, frames);
}
