// Two levels that look like many: thresholds, ordered dither, error diffusion, blue noise.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "demos/lesson/lesson.h"
#include "demos/lesson/photograph.h"
#include "raster/base/error.h"
#include "raster/dither/error_diffusion.h"
#include "raster/dither/ordered_dither.h"
#include "raster/dither/palette_dither.h"
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
                         {"Bayer 2", "Bayer 4", "Bayer 8", "clustered 4", "clustered 8"}, 2,
                         "the matrix of the ordered dither"),
             choice_knob("diffusion", {"1", "2", "3"}, {"Floyd-Steinberg", "Jarvis", "Atkinson"}, 0,
                         "where a pixel's error goes"),
             choice_knob("into", {"i"}, {"few levels", "a palette"}, 0,
                         "what the picture is reduced to"),
             choice_knob("subject", {"p"}, {"photograph", "ball"}, 0, "what is dithered")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 2}; }

  /// A lit ball over a slope of greys: linear light.
  Image<Srgb8> ball() const {
    Image<Srgb8> image(world().columns(), world().rows());
    const double w = image.width(), h = image.height(), r = 0.36 * std::min(w, h);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const double u = (x + 0.5 - w / 2) / r, v = (y + 0.5 - h / 2) / r, n2 = 1 - u * u - v * v;
        const double lit =
            std::max(0.0, (-0.5 * u - 0.6 * v + 0.62 * std::sqrt(std::max(n2, 0.0))));
        const auto light = static_cast<float>(
            std::clamp(n2 > 0 ? 0.03 + 0.95 * lit : 0.6 * (x + 0.5) / w, 0., 1.));
        image.at(x, y) = encode_srgb8(LinearRgb{light, light, light});
      }
    }
    return image;
  }

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
            : ball();
    return knob(kInto).index() == kPalette ? to_a_palette(picture)
                                           : to_few_levels(grey_of(picture, true));
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

  /// The picture, its boxes of colours as they are cut, and what their mean colours make of it.
  Course to_a_palette(const Image<Srgb8>& picture) const {
    MedianCut cut(picture, from_2_to_256(kColours, "colours"));
    Course course;
    course.papers = {picture};
    Track boxes("boxes of colours", {"boxes"}, 1);
    Palette palette;
    do {
      const Palette before = std::exchange(palette, cut.palette());
      show_changes(boxes, before, palette);
      boxes.step({double(cut.boxes().size())});
    } while (cut.next());
    course.tracks.push_back(Track("photograph", {}, 0));
    course.tracks.push_back(std::move(boxes));
    course.tracks.push_back(rows("nearest", 2, to_palette(picture, palette), palette));
    course.tracks.push_back(rows("diffused", 3, diffuse_to_palette(picture, palette), palette));
    course.remarks.push_back(fmt::format("{} colours of the 16777216", palette.size()));
    return course;
  }

  /// A field for each entry; those that a cut changed are drawn anew.
  void show_changes(Track& track, const Palette& before, const Palette& now) const {
    const int side = static_cast<int>(std::ceil(std::sqrt(figure(kColours))));
    const int width = world().columns() / side, height = world().rows() / side;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (i < before.size() && before[i] == now[i]) continue;
      const int left = static_cast<int>(i) % side * width,
                top = static_cast<int>(i) / side * height;
      for (int y = top; y < top + height; ++y) track.span({y, left, left + width}, now[i]);
    }
  }

  Track rows(const char* name, int pane, const Image<std::uint8_t>& entries,
             const Palette& palette) const {
    Track track(name, {}, pane);
    for (int y = 0; y < entries.height(); ++y) {
      for (int x = 0; x < entries.width(); ++x) track.plot(x, y, palette[entries.at(x, y)]);
      track.step({});
    }
    return track;
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
           "error diffusion", "blue noise", "to 1 bit and to a palette of 256"}};
}

}  // namespace kinescope
