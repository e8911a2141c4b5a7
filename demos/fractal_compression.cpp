// A picture told as maps from its larger blocks to its smaller ones, and found again from grey.
#include <fmt/format.h>

#include "demos/lesson/chart.h"
#include "engine/fractals/compression.h"
#include "engine/fractals/plasma.h"

namespace kinescope {
namespace {

enum { kPicture, kBlock };
enum { kBall, kClouds };

constexpr int kSide = 64, kPasses = 10;

GreySquare ball() {
  GreySquare picture{kSide, {}};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double u = (x - 31.5) / 24, v = (y - 31.5) / 24, n2 = 1 - u * u - v * v;
      const double lit = -0.5 * u - 0.6 * v + 0.62 * std::sqrt(std::max(n2, 0.0));
      picture.level.push_back(
          static_cast<float>(n2 > 0 ? 0.1 + 0.85 * std::max(0.0, lit) : 0.75 * x / kSide));
    }
  }
  return picture;
}

GreySquare clouds() {
  const HeightField field = plasma(6, 0.9, 4);
  GreySquare picture{kSide, {}};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      picture.level.push_back(
          static_cast<float>(std::clamp(0.5 + 0.25 * field.at(x, y), 0.0, 1.0)));
    }
  }
  return picture;
}

/// Peak signal over noise.
double decibels(const GreySquare& a, const GreySquare& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.level.size(); ++i) {
    const double off = double(a.level[i]) - double(b.level[i]);
    squares += off * off;
  }
  return -10 * std::log10(std::max(squares / static_cast<double>(a.level.size()), 1e-12));
}

class FractalCompression : public ClonableDemo<FractalCompression, Lesson> {
 public:
  explicit FractalCompression(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "From plain grey the maps alone lead back to the picture. Drag the "
                         "point: its block (amber) is made of the larger one (blue).",
             .handles = {{"block", {0.35, 0.55}}},
             .resolution = 7,
             .speed = 1},
            {choice_knob("picture", {"p"}, {"ball", "clouds"}, kBall, "to be told"),
             choice_knob("block", {"1", "2"}, {"4x4", "8x8"}, 0, "pixels of each map")}) {}

 private:
  glm::ivec2 panes() const override { return {2, 1}; }

  int zoom() const { return std::max(1, std::min(world().columns(), world().rows()) / kSide); }
  glm::ivec2 origin() const {
    return (glm::ivec2(world().columns(), world().rows()) - zoom() * kSide) / 2;
  }

  template <typename Plot>
  void lay(const GreySquare& picture, Plot&& plot) const {
    const int side = zoom() * kSide;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const auto at = static_cast<std::size_t>(y / zoom() * kSide + x / zoom());
        const float level = std::clamp(picture.level[at], 0.0f, 1.0f);
        const auto grey = static_cast<std::uint8_t>(std::lround(255 * level));
        plot(origin().x + x, origin().y + y, Srgb8{grey, grey, grey, 255});
      }
    }
  }

  void frame(Course& course, int x, int y, int size, Srgb8 colour) const {
    const glm::dvec2 low = glm::dvec2(origin() + zoom() * glm::ivec2(x, y));
    const glm::dvec2 high = low + double(zoom() * size);
    guide_rectangle(course, low, high, colour);
  }

  /// The block under the handle, and what it is made of.
  void show_map(Course& course, const FractalCode& code) const {
    const glm::ivec2 at = (pixel(0) - origin()) / (zoom() * code.block_px);
    const int x = std::clamp(at.x, 0, code.blocks - 1), y = std::clamp(at.y, 0, code.blocks - 1);
    const BlockMap& map = code.maps[static_cast<std::size_t>(y * code.blocks + x)];
    const int from_x = map.domain_x * code.domain_step_px,
              from_y = map.domain_y * code.domain_step_px;
    frame(course, x * code.block_px, y * code.block_px, code.block_px, theme::kAccent);
    frame(course, from_x, from_y, 2 * code.block_px, theme::kCool);
    course.remarks.push_back(fmt::format("block ({}, {}) is made of ({}, {}), turn {}",
                                         x * code.block_px, y * code.block_px, from_x, from_y,
                                         map.turn));
    course.remarks.push_back(fmt::format("each grey v becomes {:.2f} v {} {:.2f}", map.contrast,
                                         map.brightness < 0 ? '-' : '+', std::abs(map.brightness)));
  }

  Course record() const override {
    const GreySquare picture = knob(kPicture).index() == kBall ? ball() : clouds();
    const int block = knob(kBlock).index() == 0 ? 4 : 8;
    const FractalCode code = compress_fractally(picture, block, 8, studio().workers);
    Course course;
    course.papers.emplace_back(world().columns(), world().rows(), kUnlit);
    lay(picture, [&](int x, int y, Srgb8 grey) {
      if (course.papers[0].contains(x, y)) course.papers[0].at(x, y) = grey;
    });
    Track original("picture", {}, 0), track("from its maps", {"pass", "change", "PSNR dB"}, 1);
    FractalDecoder decoder(code);
    float change = 0;
    for (int pass = 0; pass <= kPasses; ++pass) {
      if (pass > 0) change = decoder.next();
      lay(decoder.picture, [&](int x, int y, Srgb8 grey) { track.plot(x, y, grey); });
      track.step({double(pass), double(change), decibels(decoder.picture, picture)});
    }
    course.remarks = {fmt::format("{} pixels told by {} maps", kSide * kSide, code.maps.size())};
    show_map(course, code);
    course.tracks = {std::move(original), std::move(track)};
    return course;
  }
};

}  // namespace

DemoInfo fractal_compression_demo() {
  return {"fractal-compression",
          "9 Curves and fractals",
          "A picture told by maps from its larger blocks to its smaller ones, and decoded",
          [](const DemoSetup& setup) { return std::make_unique<FractalCompression>(setup); },
          1,
          "drag to another block",
          {"fractal image compression"}};
}

}  // namespace kinescope
