#include "demos/monitor.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "demos/picture.h"
#include "raster/colour/encode.h"

namespace kinescope {
namespace {

constexpr double kAspect = 4.0 / 3.0;  // of every tube here, whatever its mode

void encode_scaled(std::span<const LinearRgb> light, float gain, std::span<Srgb8> out) {
  if (gain == 1.0f) return encode_row(light, out);
  std::vector<LinearRgb> scaled(light.begin(), light.end());
  for (LinearRgb& c : scaled) c = {c.r * gain, c.g * gain, c.b * gain};
  encode_row(scaled, out);
}

}  // namespace

Monitor::Monitor(const TubeSettings& settings, PixelFormat format, int pages, int width, int height)
    : buffer_(settings.mode.horizontal.active, settings.mode.vertical.active, format, pages),
      tube_(settings, fit_within({width, height}, kAspect).width,
            fit_within({width, height}, kAspect).height) {
  place(width, height);
}

void Monitor::place(int width, int height) {
  const Size face = fit_within({width, height}, kAspect);
  width_ = face.width;
  height_ = face.height;
  left_ = (width - face.width) / 2;
  top_ = (height - face.height) / 2;
}

void Monitor::resize(int width, int height) {
  place(width, height);
  tube_.resize(width_, height_);
}

std::size_t Monitor::state_bytes() const {
  const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  const auto page =
      static_cast<std::size_t>(buffer_.pitch_bytes()) * static_cast<std::size_t>(buffer_.height());
  return pixels * 2 * sizeof(LinearRgb) + page * static_cast<std::size_t>(buffer_.pages());
}

void Monitor::switch_on(Seconds now) {
  on_ = true;
  shown_ = false;
  frame_ = -1;
  origin_ = now;
  tube_.reset();
  buffer_.vertical_retrace();
}

bool Monitor::frame_begins(const Step& step) {
  if (!on_) switch_on(step.exposure.begin);
  // A frame that begins within rounding of the step's end belongs to the next step.
  const double period = refresh().period().count();
  const auto frame =
      static_cast<std::int64_t>(std::floor(tube_time(step.exposure.begin).count() / period + 1e-6));
  if (frame == frame_) return false;
  frame_ = frame;
  return true;
}

void Monitor::show(const Image<Srgb8>& picture) {
  const int page = shown_ ? buffer_.hidden_page() : buffer_.visible_page();
  buffer_.store(page, picture);
  if (shown_) buffer_.flip_at_retrace(page);
  shown_ = true;
}

void Monitor::expose(const Step& step, Workers& workers, Image<Srgb8>& picture, double stops) {
  const Image<LinearRgb>& light = tube_.expose(buffer_, tube_time(step.exposure.end), workers);
  const double gain = refresh().period() / step.exposure.length() * std::exp2(-stops);
  // An exposure of one period, give or take rounding, needs none.
  const float applied = std::abs(gain - 1) < 1e-6 ? 1.0f : static_cast<float>(gain);
  constexpr int kRows = 16;
  workers.run((picture.height() + kRows - 1) / kRows, [&](int task, int) {
    for (int y = task * kRows; y < std::min(picture.height(), (task + 1) * kRows); ++y) {
      const std::span<Srgb8> row(picture.row(y), static_cast<std::size_t>(picture.width()));
      const bool inside = y >= top_ && y < top_ + height_;
      if (!inside || width_ < picture.width()) std::fill(row.begin(), row.end(), Srgb8{});
      if (!inside) continue;
      const auto width = static_cast<std::size_t>(width_);
      encode_scaled({light.row(y - top_), width}, applied,
                    row.subspan(static_cast<std::size_t>(left_), width));
    }
  });
}

}  // namespace kinescope
