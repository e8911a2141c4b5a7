// A fence that turns to stripes, and what cures it.
#include <algorithm>
#include <cmath>

#include "demos/lesson/lesson.h"
#include "raster/antialias/area_coverage.h"
#include "raster/antialias/edge_blur.h"
#include "raster/antialias/filtered_coverage.h"
#include "raster/antialias/supersample.h"
#include "raster/base/error.h"
#include "raster/scan/wu_line.h"

namespace kinescope {
namespace {

enum { kFourth };
enum { kFilter, kWu, kBlur };

class Antialiasing : public ClonableDemo<Antialiasing, Lesson> {
 public:
  explicit Antialiasing(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Pickets narrower than a pixel come and go: aliasing. Weights keep "
                         "their light. Change the width of a picket, drag the vanishing "
                         "point.",
             .handles = {{"vanishing point", {0.7, 0.2}}},
             .figures = {{"pickets", 12, 2, 40, 1, false}},
             .resolution = 4,
             .speed = 4},
            {choice_knob("fourth", {"1", "2", "3"}, {"Gaussian filter", "Wu lines", "edge blur"},
                         kFilter, "what the fourth picture shows")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 2}; }

  /// Pickets that run from the bottom to one point.
  Polygon fence() const {
    const double count = figure(0), width = world().columns(), bottom = world().rows();
    if (!(count >= 1 && count <= 1000)) throw_bad_input("pickets: from 1 to 1000");
    Polygon polygon;
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const double left = width * i / count;
      polygon.push_back({{left, bottom}, {left + width / (2 * count), bottom}, corner(0)});
    }
    return polygon;
  }

  template <typename Draw>
  Track rows(const char* name, int pane, Draw&& draw) const {
    Track track(name, {"light"}, pane);
    Image<float> weights(world().columns(), world().rows());
    draw([&](int x, int y, float weight) {
      if (weights.contains(x, y)) weights.at(x, y) = std::min(1.0f, weights.at(x, y) + weight);
    });
    double light = 0;  // of the rows so far, in whole pixels
    for (int y = 0; y < weights.height(); ++y) {
      for (int x = 0; x < weights.width(); ++x) {
        if (weights.at(x, y) > 0) track(x, y, weights.at(x, y));
        light += static_cast<double>(weights.at(x, y));
      }
      track.step({light});
    }
    return track;
  }

  Course record() const override {
    const Polygon polygon = fence();
    const PixelRect window = world().window();
    constexpr FillRule kRule = FillRule::kNonZero;
    const auto centres = [&](auto&& sink) {
      scanline_fill(polygon, kRule, window, [&](const RowSpan& span) {
        for (int x = span.x_begin; x < span.x_end; ++x) sink(x, span.y, 1.0f);
      });
    };
    Course course;
    course.tracks.push_back(rows("centres only", 0, centres));
    course.tracks.push_back(rows("4x4 supersampling", 1, [&](auto&& sink) {
      supersample(polygon, kRule, window, 4, sink);
    }));
    course.tracks.push_back(
        rows("exact area", 2, [&](auto&& sink) { area_coverage(polygon, kRule, window, sink); }));
    course.tracks.push_back(fourth(polygon, window, centres));
    return course;
  }

  template <typename Centres>
  Track fourth(const Polygon& polygon, const PixelRect& window, const Centres& centres) const {
    switch (knob(kFourth).index()) {
      case kFilter:
        return rows("Gaussian filter", 3, [&](auto&& sink) {
          filtered_coverage(polygon, FillRule::kNonZero, window, CoverageFilter::kGaussian, 8,
                            sink);
        });
      case kWu:
        return rows("Wu lines", 3, [&](auto&& sink) {
          for (const Contour& c : polygon) {
            wu_line(glm::ivec2(glm::floor(c[0])), glm::ivec2(glm::floor(c[2])), sink);
          }
        });
      default:
        break;
    }
    Image<LinearRgb> sharp(window.x1, window.y1);
    centres([&](int x, int y, float) {
      if (sharp.contains(x, y)) sharp.at(x, y) = {1, 1, 1};
    });
    const Image<LinearRgb> blurred = blur_edges(sharp);
    return rows("edge blur afterwards", 3, [&](auto&& sink) {
      for (int y = 0; y < window.y1; ++y) {
        for (int x = 0; x < window.x1; ++x) sink(x, y, blurred.at(x, y).g);
      }
    });
  }
};

}  // namespace

DemoInfo antialiasing_demo() {
  return {
      "antialiasing",
      "8 Filling, characters, sampling",
      "A fence that turns to stripes: supersampling, exact area, filtering, Wu lines, edge blur",
      [](const DemoSetup& setup) { return std::make_unique<Antialiasing>(setup); },
      1,
      "drag the vanishing point",
      {"aliasing shown (a fence that turns to stripes)", "supersampling", "exact area", "Wu lines",
       "filtering", "edge-finding blur"}};
}

}  // namespace kinescope
