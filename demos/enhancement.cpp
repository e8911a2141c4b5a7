// Picture enhancement: tone curves by the histogram, convolutions, and the median.
#include <fmt/format.h>

#include "demos/lesson/histogram_track.h"
#include "demos/lesson/lesson.h"
#include "demos/lesson/photograph.h"
#include "engine/fractals/random.h"
#include "raster/base/error.h"
#include "raster/image/enhancement.h"

namespace kinescope {
namespace {

enum { kOperation, kSpecks, kFaint };
enum { kBefore, kAfter, kHistogramBefore, kHistogramAfter };

class EnhancementDemo : public ClonableDemo<EnhancementDemo, Lesson> {
 public:
  explicit EnhancementDemo(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "A faint picture's tones crowd in the middle of its histogram; curves "
                         "spread them. Sums of neighbours blur or find edges. Specks yield to the "
                         "median, not to a mean: x, then box and median.",
             .figures = {{"amount", 1.5, 0.25, 4, 0.25}},
             .resolution = 7,
             .speed = 4},
            {choice_knob("operation", {"o"},
                         {"stretch", "equalize", "contrast", "gamma", "negative", "box", "Gaussian",
                          "sharpen", "Laplacian", "Sobel", "emboss", "median"},
                         static_cast<int>(Enhancement::kEqualize), "what is done to the picture"),
             toggle_knob("specks", "x", false, "white and black specks spoil the picture first"),
             toggle_knob("faint", "f", true, "the picture is taken through mist")}),
        seed_(setup.seed) {}

 private:
  glm::ivec2 panes() const override { return {2, 2}; }

  GreyImage subject() const {
    GreyImage image =
        grey_of(photograph(studio().workers, world().columns(), world().rows()), false);
    if (knob(kFaint).on()) {
      image = with_curve(std::move(image), tone_curve([](double t) { return 0.42 + 0.25 * t; }));
    }
    SeededRandom random(seed_);
    for (std::uint8_t& tone : image.pixels()) {
      constexpr double kShare = 0.04;
      const double chance = random.uniform();
      if (knob(kSpecks).on() && chance < kShare) tone = chance < kShare / 2 ? 0 : 255;
    }
    return image;
  }

  double amount() const {
    const double amount = figure(0);
    if (!(amount > 0 && amount <= 10)) throw_bad_input("amount: above 0, at most 10");
    return amount;
  }

  static Srgb8 grey(std::uint8_t tone) { return {tone, tone, tone, 255}; }

  Course record() const override {
    const GreyImage image = subject();
    GreyImage result(image.width(), image.height());
    Track after(knob(kOperation).text(), {"row"}, kAfter);
    enhance(image, {Enhancement{knob(kOperation).index()}, amount()},
            [&](int x, int y, std::uint8_t tone) {
              result.at(x, y) = tone;
              after.plot(x, y, grey(tone));
              if (x + 1 == image.width()) after.step({double(y)});
            });
    Course course;
    course.papers.resize(1);
    course.papers[0] = Image<Srgb8>(image.width(), image.height());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
      course.papers[0].pixels()[i] = grey(image.pixels()[i]);
    }
    const Histogram before = histogram(image), now = histogram(result);
    course.tracks.push_back(Track("before", {}, kBefore));
    course.tracks.push_back(std::move(after));
    course.tracks.push_back(
        histogram_track(world(), "its histogram", before, kHistogramBefore, theme::kCool));
    course.tracks.push_back(
        histogram_track(world(), "and now", now, kHistogramAfter, theme::kAccent));
    course.remarks = {"before: " + told(before), "after: " + told(now)};
    return course;
  }

  static std::string told(const Histogram& counts) {
    const ToneSpread spread = tone_spread(counts);
    return fmt::format("mean {:.1f}, deviation {:.1f}, {} tones", spread.mean, spread.deviation,
                       spread.tones);
  }

  std::uint64_t seed_;
};

}  // namespace

DemoInfo enhancement_demo() {
  return {"enhancement",
          "1 Displays and coordinates",
          "A picture enhanced: histogram, contrast, convolution, edges, median",
          [](const DemoSetup& setup) { return std::make_unique<EnhancementDemo>(setup); },
          1,
          {},
          {"applications: picture enhancement", "imaging"}};
}

}  // namespace kinescope
