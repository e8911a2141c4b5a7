// Frames of video as pictures. Sources: ITU-R BT.601-7 and BT.709-6 (matrices, ranges); MPEG-2
// (ISO/IEC 13818-2, 6.1.1.8) for where chroma lies.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "raster/image/video.h"

namespace kinescope {
namespace {

std::size_t sample_bytes(const VideoFormat& f) { return f.bits > 8 ? 2 : 1; }

int divided_up(int a, int b) { return (a + b - 1) / b; }

/// R' = y + red_v V, G' = y + green_u U + green_v V, B' = y + blue_u U, with U and V in -0.5..0.5.
struct Matrix {
  float red_v, green_u, green_v, blue_u;
};

Matrix matrix_of(YuvMatrix kind) {
  const double kr = kind == YuvMatrix::kBt601 ? 0.299 : 0.2126;
  const double kb = kind == YuvMatrix::kBt601 ? 0.114 : 0.0722;
  const double kg = 1 - kr - kb;
  return {static_cast<float>(2 * (1 - kr)), static_cast<float>(-2 * kb * (1 - kb) / kg),
          static_cast<float>(-2 * kr * (1 - kr) / kg), static_cast<float>(2 * (1 - kb))};
}

/// From codes to numbers: luma 0..1, chroma -0.5..0.5.
struct Range {
  float luma_black, luma_scale, chroma_zero, chroma_scale;
};

Range range_of(const VideoFormat& f) {
  const float unit = static_cast<float>(1 << (f.bits - 8));
  if (!f.full_range) return {16 * unit, 1 / (219 * unit), 128 * unit, 1 / (224 * unit)};
  const float most = 256 * unit - 1;
  return {0, 1 / most, 128 * unit, 1 / most};
}

std::uint8_t to_code(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/// Sample i of a row of samples.
class Samples {
 public:
  Samples(const std::uint8_t* bytes, bool wide) : bytes_(bytes), wide_(wide) {}
  float operator[](std::size_t i) const {
    return wide_ ? static_cast<float>(bytes_[2 * i] | bytes_[2 * i + 1] << 8)
                 : static_cast<float>(bytes_[i]);
  }

 private:
  const std::uint8_t* bytes_;
  bool wide_;
};

/// Between which two samples a place lies, and how near the second.
struct Between {
  int first, second;
  float second_weight;
};

/// @param site of sample 0; samples are `step` apart, `count` of them
Between between(int place, double site, int step, int count) {
  const double at = (place - site) / step;
  const double below = std::floor(at);
  const int first = static_cast<int>(below);
  return {std::clamp(first, 0, count - 1), std::clamp(first + 1, 0, count - 1),
          static_cast<float>(at - below)};
}

std::vector<Between> columns_of(const VideoFormat& f, ChromaSite site) {
  std::vector<Between> columns;
  for (int x = 0; x < f.width; ++x) {
    columns.push_back(between(x, site.x, f.chroma_across, divided_up(f.width, f.chroma_across)));
  }
  return columns;
}

/// One chroma plane, read at luma's places.
class ChromaPlane {
 public:
  /// @param columns where luma's columns lie between the plane's
  ChromaPlane(const VideoFormat& f, const std::uint8_t* plane, ChromaSite site,
              std::span<const Between> columns)
      : format_(f),
        plane_(plane),
        site_(site),
        columns_(columns),
        width_(divided_up(f.width, f.chroma_across)),
        height_(divided_up(f.height, f.chroma_down)),
        blended_(static_cast<std::size_t>(width_)) {}

  /// The plane's codes along luma line y.
  void read_line(int y, std::span<float> out) {
    blend_rows(y);
    for (std::size_t x = 0; x < out.size(); ++x) {
      const Between& c = columns_[x];
      const float a = blended_[static_cast<std::size_t>(c.first)];
      out[x] = a + (blended_[static_cast<std::size_t>(c.second)] - a) * c.second_weight;
    }
  }

 private:
  Samples row(int y) const {
    const std::size_t offset = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    return {plane_ + offset * sample_bytes(format_), format_.bits > 8};
  }

  // Fields were taken at different times: a line takes chroma from its own field alone.
  void blend_rows(int y) {
    const int fields = format_.fields == FieldOrder::kProgressive ? 1 : 2;
    const int field = y % fields, rows = (height_ - field + fields - 1) / fields;
    double site = site_.y;
    // Halfway between two lines of the frame is 1/4 or 3/4 of the way between two of a field.
    if (fields == 2 && site == 0.5) site = field == 0 ? 0.25 : 0.75;
    const Between r = between(y / fields, site, format_.chroma_down, std::max(rows, 1));
    const int last = height_ - 1;  // of a frame so low that a field has no chroma of its own
    const Samples a = row(std::min(r.first * fields + field, last));
    const Samples b = row(std::min(r.second * fields + field, last));
    for (std::size_t x = 0; x < blended_.size(); ++x) {
      blended_[x] = a[x] + (b[x] - a[x]) * r.second_weight;
    }
  }

  const VideoFormat& format_;
  const std::uint8_t* plane_;
  ChromaSite site_;
  std::span<const Between> columns_;
  int width_, height_;
  std::vector<float> blended_;
};

/// What all lines of a frame share.
struct YuvFrame {
  const VideoFormat& format;
  const std::uint8_t* bytes;
  Matrix matrix;
  Range range;
  std::vector<Between> blue_columns, red_columns;
};

void decode_lines(const YuvFrame& frame, int begin, int end, Image<Srgb8>& out) {
  const VideoFormat& f = frame.format;
  const std::size_t width = static_cast<std::size_t>(f.width);
  const std::size_t row_bytes = width * sample_bytes(f);
  const std::size_t luma_bytes = row_bytes * static_cast<std::size_t>(f.height);
  const std::size_t chroma_bytes = (frame_bytes(f) - luma_bytes) / 2;
  const Matrix& m = frame.matrix;
  const Range& range = frame.range;
  const std::uint8_t* const chroma = frame.bytes + luma_bytes;
  ChromaPlane blue(f, chroma, f.blue_site, frame.blue_columns);
  ChromaPlane red(f, chroma + chroma_bytes, f.red_site, frame.red_columns);
  std::vector<float> u(width), v(width);
  for (int y = begin; y < end; ++y) {
    const Samples luma(frame.bytes + static_cast<std::size_t>(y) * row_bytes, f.bits > 8);
    blue.read_line(y, u);
    red.read_line(y, v);
    Srgb8* const to = out.row(y);
    for (std::size_t x = 0; x < width; ++x) {
      const float light = (luma[x] - range.luma_black) * range.luma_scale;
      const float cb = (u[x] - range.chroma_zero) * range.chroma_scale;
      const float cr = (v[x] - range.chroma_zero) * range.chroma_scale;
      to[x] = {to_code(light + m.red_v * cr), to_code(light + m.green_u * cb + m.green_v * cr),
               to_code(light + m.blue_u * cb), 255};
    }
  }
}

void decode_yuv(const VideoFormat& f, const std::uint8_t* bytes, Workers& workers,
                Image<Srgb8>& out) {
  constexpr int kLinesATask = 32;
  const YuvFrame frame{f,
                       bytes,
                       matrix_of(f.matrix),
                       range_of(f),
                       columns_of(f, f.blue_site),
                       columns_of(f, f.red_site)};
  workers.run(divided_up(f.height, kLinesATask), [&](int task, int) {
    decode_lines(frame, task * kLinesATask, std::min(f.height, (task + 1) * kLinesATask), out);
  });
}

void decode_grey(const VideoFormat& f, const std::uint8_t* bytes, Image<Srgb8>& out) {
  const Range range = range_of(f);
  const Samples luma(bytes, f.bits > 8);
  std::size_t i = 0;
  for (Srgb8& pixel : out.pixels()) {
    const std::uint8_t grey = to_code((luma[i++] - range.luma_black) * range.luma_scale);
    pixel = {grey, grey, grey, 255};
  }
}

void decode_packed(FrameLayout layout, const std::uint8_t* bytes, Image<Srgb8>& out) {
  const std::size_t step = layout == FrameLayout::kRgb ? 3 : 4;
  for (Srgb8& pixel : out.pixels()) {
    pixel = {bytes[0], bytes[1], bytes[2], step == 4 ? bytes[3] : std::uint8_t{255}};
    if (layout == FrameLayout::kBgra) std::swap(pixel.r, pixel.b);
    bytes += step;
  }
}

}  // namespace

YuvMatrix usual_matrix(int width, int height) {
  return width >= 1280 || height > 576 ? YuvMatrix::kBt709 : YuvMatrix::kBt601;
}

std::size_t frame_bytes(const VideoFormat& f) {
  const std::size_t pixels = static_cast<std::size_t>(f.width) * static_cast<std::size_t>(f.height);
  switch (f.layout) {
    case FrameLayout::kRgb:
      return 3 * pixels;
    case FrameLayout::kRgba:
    case FrameLayout::kBgra:
      return 4 * pixels;
    case FrameLayout::kGrey:
      return pixels * sample_bytes(f);
    case FrameLayout::kYuv:
      break;
  }
  const std::size_t chroma = static_cast<std::size_t>(divided_up(f.width, f.chroma_across)) *
                             static_cast<std::size_t>(divided_up(f.height, f.chroma_down));
  return (pixels + 2 * chroma) * sample_bytes(f);
}

void decode_frame(const VideoFormat& format, std::span<const std::uint8_t> bytes, Workers& workers,
                  Image<Srgb8>& out) {
  assert(bytes.size() == frame_bytes(format));
  if (out.width() != format.width || out.height() != format.height) {
    out = Image<Srgb8>(format.width, format.height);
  }
  if (format.layout == FrameLayout::kYuv) return decode_yuv(format, bytes.data(), workers, out);
  if (format.layout == FrameLayout::kGrey) return decode_grey(format, bytes.data(), out);
  decode_packed(format.layout, bytes.data(), out);
}

}  // namespace kinescope
