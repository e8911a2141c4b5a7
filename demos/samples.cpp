// A picture as samples: a bitmap, a pixmap of 2 to 24 bits, both magnified, and the same as
// vectors.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "demos/boat.h"
#include "demos/lesson/lesson.h"
#include "engine/clip/liang_barsky.h"
#include "raster/base/error.h"
#include "raster/image/bit_depth.h"

namespace kinescope {
namespace {

enum { kBits, kTimes };
enum { kBitmap, kPixmap, kMagnified, kVectors };

class Samples : public ClonableDemo<Samples, Lesson> {
 public:
  explicit Samples(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "A bitmap keeps one bit a pixel, a pixmap more; magnified, both show "
                         "their samples, vectors their edge. Drag the lens, change the bits; "
                         "PageUp and PageDown change the resolution.",
             .handles = {{"lens", {0.7, 0.36}}},
             .figures = {{"bits", 8, 2, 24, 1, false}, {"times", 5, 2, 12, 1, false}},
             .resolution = 5,
             .speed = 4},
            {}) {}

 private:
  glm::ivec2 panes() const override { return {2, 2}; }
  bool handle_in(int, int pane) const override { return pane != kMagnified; }

  Course record() const override {
    const World pane = world();
    const int bits = whole_figure(kBits), times = whole_figure(kTimes);
    if (bits < 1 || bits > 24) throw_bad_input("bits: from 1 to 24 a pixel");
    if (times < 1 || times > 100) throw_bad_input("times: from 1 to 100");
    const glm::ivec2 lens =
        glm::clamp(pixel(0), glm::ivec2(0), glm::ivec2(pane.columns() - 1, pane.rows() - 1));
    const Image<LinearRgb> light = boat_picture(pane.columns(), pane.rows());
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
    for (const BoatPart& part : boat()) {
      Contour contour;
      for (const glm::dvec2& corner : part.corners) contour.push_back(corner * size);
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
    for (const BoatPart& part : boat()) corners += part.corners.size();
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
