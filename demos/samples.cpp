// A picture as samples: a bitmap, a pixmap of 2 to 24 bits, both magnified, and the same as
// vectors.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "demos/lesson/lesson.h"
#include "engine/clip/liang_barsky.h"
#include "raster/antialias/area_coverage.h"
#include "raster/base/error.h"
#include "raster/image/bit_depth.h"

namespace kinescope {
namespace {

enum { kBits, kTimes };
enum { kBitmap, kPixmap, kMagnified, kVectors };

/// Corners in shares of the picture, and its colours at the left and right.
struct Shape {
  Contour corners;
  LinearRgb left, right;
};

const std::array<Shape, 4>& boat() {
  static const std::array<Shape, 4> kShapes = {
      {{{{0, 0.72}, {1, 0.72}, {1, 1}, {0, 1}}, {0.01f, 0.08f, 0.3f}, {0.1f, 0.42f, 0.6f}},
       {{{0.2, 0.68}, {0.88, 0.68}, {0.74, 0.86}, {0.32, 0.86}},
        {0.06f, 0.02f, 0.01f},
        {0.3f, 0.12f, 0.03f}},
       {{{0.53, 0.08}, {0.53, 0.62}, {0.86, 0.62}}, {0.08f, 0.05f, 0.02f}, {1.0f, 0.8f, 0.4f}},
       {{{0.49, 0.14}, {0.49, 0.62}, {0.22, 0.62}}, {0.55f, 0.05f, 0.04f}, {0.12f, 0.01f, 0.01f}}}};
  return kShapes;
}

class Samples : public ClonableDemo<Samples, Lesson> {
 public:
  explicit Samples(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "A bitmap keeps one bit a pixel, a pixmap more; magnified, both show "
                         "their samples, vectors their edge. Drag the lens, change the bits; "
                         "PageUp and PageDown change the resolution.",
             .handles = {{"lens", {0.5, 0.45}}},
             .figures = {{"bits", 8, 2, 24, 1, false}, {"times", 5, 2, 12, 1, false}},
             .resolution = 5,
             .speed = 4},
            {}) {}

 private:
  glm::ivec2 panes() const override { return {2, 2}; }

  Image<LinearRgb> exact() const {
    const World pane = world();
    Image<LinearRgb> light(pane.columns(), pane.rows(), {0.5f, 0.62f, 0.75f});
    const glm::dvec2 size(pane.columns(), pane.rows());
    for (const Shape& shape : boat()) {
      Contour contour;
      for (const glm::dvec2& corner : shape.corners) contour.push_back(corner * size);
      area_coverage({contour}, FillRule::kNonZero, pane.window(), [&](int x, int y, float share) {
        const float t = (static_cast<float>(x) + 0.5f) / static_cast<float>(pane.columns());
        LinearRgb& below = light.at(x, y);
        const auto mix = [&](float under, float left, float right) {
          return std::lerp(under, std::lerp(left, right, t), share);
        };
        below = {mix(below.r, shape.left.r, shape.right.r),
                 mix(below.g, shape.left.g, shape.right.g),
                 mix(below.b, shape.left.b, shape.right.b)};
      });
    }
    return light;
  }

  Course record() const override {
    const World pane = world();
    const int bits = whole_figure(kBits), times = whole_figure(kTimes);
    if (bits < 1 || bits > 24) throw_bad_input("bits: from 1 to 24 a pixel");
    if (times < 1 || times > 100) throw_bad_input("times: from 1 to 100");
    const glm::ivec2 lens =
        glm::clamp(pixel(0), glm::ivec2(0), glm::ivec2(pane.columns() - 1, pane.rows() - 1));
    const Image<LinearRgb> light = exact();
    Track bitmap("bitmap, 1 bit", {}, kBitmap),
        pixmap(fmt::format("pixmap, {} bits", bits), {}, kPixmap);
    Track magnified(fmt::format("{} times", times), {}, kMagnified);
    const auto at = [&](int x, int y) {
      return with_bit_depth(encode_srgb8(light.at(std::clamp(x, 0, pane.columns() - 1),
                                                  std::clamp(y, 0, pane.rows() - 1))),
                            bits);
    };
    const glm::ivec2 middle(pane.columns() / 2, pane.rows() / 2);
    for (int y = 0; y < pane.rows(); ++y) {
      for (int x = 0; x < pane.columns(); ++x) {
        bitmap.plot(x, y, with_bit_depth(encode_srgb8(light.at(x, y)), 1));
        pixmap.plot(x, y, at(x, y));
        const auto sample = [&](int v, int centre, int of) {
          return of + static_cast<int>(std::floor((v - centre + 0.5) / times + 0.5));
        };
        magnified.plot(x, y, at(sample(x, middle.x, lens.x), sample(y, middle.y, lens.y)));
      }
      for (Track* track : {&bitmap, &pixmap, &magnified}) track->step({});
    }
    Course course;
    course.tracks = {std::move(bitmap), std::move(pixmap), std::move(magnified)};
    course.tracks.push_back(Track("vectors", {}, kVectors));
    add_vectors(course, lens, times);
    tell(course, bits);
    return course;
  }

  void add_vectors(Course& course, glm::ivec2 lens, int times) const {
    const glm::dvec2 size(world().columns(), world().rows()), middle = glm::floor(size / 2.0);
    for (const Shape& shape : boat()) {
      Contour contour;
      for (const glm::dvec2& corner : shape.corners) contour.push_back(corner * size);
      contour_edges(contour, [&](glm::dvec2 a, glm::dvec2 b) {
        const auto enlarged = [&](glm::dvec2 p) {
          return middle + (p - glm::dvec2(lens) - 0.5) * double(times);
        };
        course.guides.push_back({a, b, theme::kAccent, kVectors});
        const ClipWindow room{{0, 0}, size};
        if (const auto seen = clip_liang_barsky(room, {enlarged(a), enlarged(b)})) {
          course.guides.push_back({seen->from, seen->to, theme::kAccent, kMagnified});
        }
      });
    }
  }

  void tell(Course& course, int bits) const {
    const World pane = world();
    const int across = pane.columns(), down = pane.rows();
    const ChannelBits share = channel_bits(bits);
    std::size_t corners = 0;
    for (const Shape& shape : boat()) corners += shape.corners.size();
    course.remarks = {
        fmt::format("resolution {} x {}, aspect ratio {:.3f} to 1", across, down,
                    double(across) / down),
        fmt::format("bitmap: 2 colours, frame buffer {} bytes",
                    frame_buffer_bytes(across, down, 1)),
        fmt::format("pixmap: {} colours{}, frame buffer {} bytes", std::int64_t{1} << bits,
                    bits < 4 ? "" : fmt::format(" ({}-{}-{})", share.red, share.green, share.blue),
                    frame_buffer_bytes(across, down, bits)),
        fmt::format("vectors: {} corners of two numbers, whatever the size", corners)};
  }
};

}  // namespace

DemoInfo samples_demo() {
  return {"samples",
          "1 Displays and coordinates",
          "A picture as a bitmap, as a pixmap of 2 to 24 bits, magnified, and as vectors",
          [](const DemoSetup& setup) { return std::make_unique<Samples>(setup); },
          1,
          "drag the lens",
          {"image as samples", "bitmap and pixmap", "magnified pixel grid against vectors",
           "resolution", "aspect ratio", "frame buffer"}};
}

}  // namespace kinescope
