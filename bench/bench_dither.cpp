// Dithers of a 12-megapixel picture beside ImageMagick's `convert`, one thread each: its time with
// the dither less its time without, medians of interleaved runs.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bench/program.h"
#include "bench/statistics.h"
#include "raster/dither/error_diffusion.h"
#include "raster/dither/ordered_dither.h"
#include "raster/dither/void_and_cluster.h"

namespace kinescope::bench {
namespace {

constexpr int kWidth = 4000, kHeight = 3000, kPairs = 5;

GreyImage picture() {
  GreyImage image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double wave = std::sin(x * 0.011) * std::cos(y * 0.017) + std::sin((x + y) * 0.003);
      image.at(x, y) = static_cast<std::uint8_t>(127.5 + 63 * wave);
    }
  }
  return image;
}

/// Seconds that `convert` works on the picture with these options.
void convert(const std::string& file, const std::string& options) {
  const std::string command =
      "MAGICK_THREAD_LIMIT=1 convert -size 4000x3000 -depth 8 'gray:" + file + "' " + options +
      " null:";
  if (std::system(command.c_str()) != 0) {
    throw Error(ErrorKind::kUsage, "ImageMagick's convert is needed (scripts/setup installs it)");
  }
}

template <typename Ours>
void contest(const char* name, const std::string& file, const std::string& options, Ours&& ours) {
  std::vector<double> our_ms, their_ms, ratios;
  for (int i = 0; i < kPairs; ++i) {
    const double a = milliseconds_of(ours);
    const double with = milliseconds_of([&] { convert(file, options); });
    const double without = milliseconds_of([&] { convert(file, ""); });
    our_ms.push_back(a);
    their_ms.push_back(with - without);
    ratios.push_back((with - without) / a);
  }
  std::printf("%-16s ours %8.2f ms  ImageMagick %8.2f ms  ratio %7.2f\n", name, median(our_ms),
              median(their_ms), median(ratios));
}

int run_all(int, char**) {
  const GreyImage image = picture();
  const std::string file =
      (std::filesystem::temp_directory_path() / "kinescope-bench.gray").string();
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(image.pixels().data()),
             static_cast<std::streamsize>(image.pixels().size()));
  GreyImage result(kWidth, kHeight);
  contest("floyd-steinberg", file, "-dither FloydSteinberg -remap pattern:gray50", [&] {
    diffuse_errors<kFloydSteinberg>(image, 2, true, [&](int x, int y, int level) {
      result.at(x, y) = static_cast<std::uint8_t>(-level);
    });
  });
  const ThresholdMatrix blue = blue_noise_matrix(64, 1);
  // It has no blue noise; its ordered dither does the same work with a smaller tile.
  contest("blue-noise", file, "-ordered-dither o8x8",
          [&] { result = ordered_dither(image, blue); });
  std::filesystem::remove(file);
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

int main(int argc, char** argv) {
  return kinescope::bench::run_program("bench_dither", kinescope::bench::run_all, argc, argv);
}
