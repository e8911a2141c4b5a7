// Two levels that look like many: thresholds, ordered dither, error diffusion, blue noise.
#include <fmt/format.h>

#include <array>

#include "demos/lesson/lesson.h"
#include "demos/lesson/photograph.h"
#include "demos/palette_course.h"
#include "raster/base/error.h"
#include "raster/dither/error_diffusion.h"
#include "raster/dither/ordered_dither.h"
#include "raster/dither/threshold.h"
#include "raster/dither/void_and_cluster.h"

namespace kinescope {
namespace {

enum { kMatrix, kKernel, kInto, kSubject };
enum { kLevels, kColours };
enum { kFewLevels, kPalette };

class Dithering : public ClonableDemo<Dithering, Lesson> {
 public:
  explicit Dithering(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Thresholds lose the shading; the others keep the mean: Bayer's in "
                         "crosses, diffusion in worms, blue noise without a pattern. i: a palette "
                         "by median cut, its boxes one a step.",
             .figures = {{"levels", 2, 2, 16, 2}, {"colours", 16, 2, 256, 2}},
             .resolution = 7,
             .speed = 6},
            {choice_knob("ordered", {"o"},
                         {"Bayer 2", "Bayer 4", "Bayer 8", "clustered 2", "clustered 3",
                          "clustered 4", "clustered 6", "clustered 8"},
                         2, "the matrix of the ordered dither"),
             choice_knob("diffusion", {"1", "2", "3"}, {"Floyd-Steinberg", "Jarvis", "Atkinson"}, 0,
                         "where a pixel's error goes"),
             choice_knob("into", {"i"}, {"few levels", "a palette"}, 0,
                         "what the picture is reduced to"),
             choice_knob("subject", {"p"}, {"photograph", "ball"}, 0, "what is dithered")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 2}; }

  int from_2_to_256(int index, const char* name) const {
    const int count = whole_figure(index);
    if (count < 2 || count > 256) throw_bad_input(std::string(name) + ": from 2 to 256");
    return count;
  }
  int levels() const { return from_2_to_256(kLevels, "levels"); }
  void plot(Track& track, int x, int y, int level) const {
    const float light = static_cast<float>(level) / static_cast<float>(levels() - 1);
    track.plot(x, y, encode_srgb8(LinearRgb{light, light, light}));
  }

  ThresholdMatrix matrix() const {
    constexpr std::array kSides = {2, 4, 8, 2, 3, 4, 6, 8};
    constexpr int kFirstClustered = 3;
    const int chosen = knob(kMatrix).index(), side = kSides[static_cast<std::size_t>(chosen)];
    return chosen < kFirstClustered ? bayer_matrix(side) : clustered_dot_matrix(side);
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
    const Image<Srgb8> picture =
        knob(kSubject).index() == 0
            ? photograph(studio().workers, world().columns(), world().rows())
            : lit_ball(world().columns(), world().rows());
    return knob(kInto).index() == kPalette
               ? palette_course(picture, from_2_to_256(kColours, "colours"))
               : to_few_levels(grey_of(picture, true));
  }

  static double mean_light(const Track& track) {
    double light = 0;
    for (const Mark& mark : track.all_marks()) light += static_cast<double>(decode(mark.colour).g);
    return light / static_cast<double>(track.all_marks().size());
  }

  Course to_few_levels(const GreyImage& image) const {
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
    ordered_dither(image, matrix(), levels(), sink(ordered));
    static const ThresholdMatrix kBlue = blue_noise_matrix(32, 1);
    ordered_dither(image, kBlue, levels(), sink(blue));
    course.tracks = {std::move(plain), std::move(ordered)};
    course.tracks.push_back(knob(kKernel).index() == 0   ? diffused<kFloydSteinberg>(image)
                            : knob(kKernel).index() == 1 ? diffused<kJarvis>(image)
                                                         : diffused<kAtkinson>(image));
    course.tracks.push_back(std::move(blue));
    double light = 0;
    for (const std::uint8_t grey : image.pixels()) light += grey / 255.0;
    course.remarks.push_back(
        fmt::format("mean light {:.3f}", light / static_cast<double>(image.pixels().size())));
    for (const Track& track : course.tracks) {
      course.remarks.push_back(fmt::format("  {}: {:.3f}", track.name(), mean_light(track)));
    }
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
          {"halftoning: clustered dots, 2x2 to 8x8", "thresholding at one and at several levels",
           "ordered dithering (Bayer)", "error diffusion (Floyd-Steinberg, Jarvis, Atkinson)",
           "blue noise", "to 1 bit and to a palette of 256"}};
}

}  // namespace kinescope
