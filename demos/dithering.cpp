// Two levels that look like many: thresholds, ordered dither, error diffusion, blue noise.
#include <algorithm>
#include <cmath>

#include "demos/lesson/lesson.h"
#include "raster/base/error.h"
#include "raster/dither/error_diffusion.h"
#include "raster/dither/ordered_dither.h"
#include "raster/dither/threshold.h"
#include "raster/dither/void_and_cluster.h"

namespace kinescope {
namespace {

enum { kMatrix, kKernel };

class Dithering : public ClonableDemo<Dithering, Lesson> {
 public:
  explicit Dithering(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for =
                 "Thresholds lose the shading; the others keep the mean: Bayer's in crosses, "
                 "diffusion in worms, blue noise without a pattern.",
             .figures = {{"levels", 2, 2, 16, 2}},
             .resolution = 6,
             .speed = 6},
            {choice_knob("ordered", {"o"},
                         {"Bayer 2", "Bayer 4", "Bayer 8", "clustered 4", "clustered 8"}, 2,
                         "the matrix of the ordered dither"),
             choice_knob("diffusion", {"1", "2", "3"}, {"Floyd-Steinberg", "Jarvis", "Atkinson"}, 0,
                         "where a pixel's error goes")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 2}; }

  /// A lit ball over a slope of greys: linear light.
  GreyImage subject() const {
    GreyImage image(world().columns(), world().rows());
    const double w = image.width(), h = image.height(), r = 0.36 * std::min(w, h);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const double u = (x + 0.5 - w / 2) / r, v = (y + 0.5 - h / 2) / r, n2 = 1 - u * u - v * v;
        const double ball =
            std::max(0.0, (-0.5 * u - 0.6 * v + 0.62 * std::sqrt(std::max(n2, 0.0))));
        const double light = n2 > 0 ? 0.03 + 0.95 * ball : 0.6 * (x + 0.5) / w;
        image.at(x, y) = static_cast<std::uint8_t>(std::lround(255 * std::clamp(light, 0.0, 1.0)));
      }
    }
    return image;
  }

  int levels() const {
    const int levels = whole_figure(0);
    if (levels < 2 || levels > 256) throw_bad_input("levels: from 2 to 256");
    return levels;
  }
  void plot(Track& track, int x, int y, int level) const {
    const float light = static_cast<float>(level) / static_cast<float>(levels() - 1);
    track.plot(x, y, encode_srgb8(LinearRgb{light, light, light}));
  }

  template <const DiffusionKernel& kShares>
  Track diffused(const GreyImage& image) const {
    Track track("error diffusion", {"value", "level", "error"}, 2);
    for (ErrorDiffusion<kShares> d(image, levels()); d.next();) {
      plot(track, d.at().x, d.at().y, d.level());
      track.step({d.value(), double(d.level()), d.error()});
    }
    return track;
  }

  Course record() const override {
    const GreyImage image = subject();
    Course course;
    const auto sink = [&](Track& track) {
      return [&](int x, int y, int level) {
        plot(track, x, y, level);
        track.step({});
      };
    };
    Track plain("threshold", {}, 0), ordered("ordered", {}, 1), blue("blue noise", {}, 3);
    const std::vector<std::uint8_t> thresholds = even_thresholds(levels());
    threshold(image, std::span<const std::uint8_t>(thresholds), sink(plain));
    const int matrix = knob(kMatrix).index();
    ordered_dither(
        image, matrix < 3 ? bayer_matrix(2 << matrix) : clustered_dot_matrix(matrix == 3 ? 4 : 8),
        levels(), sink(ordered));
    static const ThresholdMatrix kBlue = blue_noise_matrix(32, 1);
    ordered_dither(image, kBlue, levels(), sink(blue));
    course.tracks = {std::move(plain), std::move(ordered)};
    course.tracks.push_back(knob(kKernel).index() == 0   ? diffused<kFloydSteinberg>(image)
                            : knob(kKernel).index() == 1 ? diffused<kJarvis>(image)
                                                         : diffused<kAtkinson>(image));
    course.tracks.push_back(std::move(blue));
    return course;
  }
};

}  // namespace

DemoInfo dithering_demo() {
  return {"dithering",
          "8 Filling, characters, sampling",
          "Thresholds, halftones and ordered dither, error diffusion and blue noise side by side",
          [](const DemoSetup& setup) { return std::make_unique<Dithering>(setup); },
          1,
          {},
          {"halftoning", "thresholding at one and several levels", "ordered dithering",
           "error diffusion", "blue noise"}};
}

}  // namespace kinescope
