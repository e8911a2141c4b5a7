#include <array>
#include <cassert>

#include "raster/base/output_file.h"
#include "raster/image/codecs.h"

namespace kinescope {
namespace {

// ITU-R BT.601 in limited range: light 0..255 becomes luma 16..235 and chroma 16..240. In 2^-16,
// with each row's sum right: luma 219/255 of 65536, chroma 0 (grey stays grey).
struct Weights {
  int r, g, b, offset;
};
constexpr Weights kLuma{16829, 33039, 6416, 16};
constexpr Weights kBlueDifference{-9714, -19070, 28784, 128};
constexpr Weights kRedDifference{28784, -24103, -4681, 128};

std::uint8_t weighted(const Weights& w, Srgb8 p) {
  return static_cast<std::uint8_t>(
      (w.r * p.r + w.g * p.g + w.b * p.b + (w.offset << 16) + (1 << 15)) >> 16);
}

}  // namespace

struct Y4mWriter::State {
  OutputFile file;
  int width, height;
  std::vector<std::uint8_t> planes;
};

Y4mWriter::Y4mWriter(const std::string& path, int width, int height, Rate frame_rate)
    : state_(new State{OutputFile(path), width, height, {}}) {
  const Rate rate = frame_rate.reduced();
  state_->file.write("YUV4MPEG2 W" + std::to_string(width) + " H" + std::to_string(height) + " F" +
                     std::to_string(rate.numerator) + ":" + std::to_string(rate.denominator) +
                     " Ip A1:1 C444 XCOLORRANGE=LIMITED XMATRIX=601\n");
}

Y4mWriter::~Y4mWriter() = default;

void Y4mWriter::write(const Image<Srgb8>& frame) {
  assert(frame.width() == state_->width && frame.height() == state_->height);
  const std::size_t count = frame.pixels().size();
  state_->planes.resize(3 * count);
  std::uint8_t* plane = state_->planes.data();
  for (const Weights& weights : {kLuma, kBlueDifference, kRedDifference}) {
    for (const Srgb8 pixel : frame.pixels()) *plane++ = weighted(weights, pixel);
  }
  state_->file.write("FRAME\n");
  state_->file.write(state_->planes);
}

void Y4mWriter::close() { state_->file.commit(); }

}  // namespace kinescope
