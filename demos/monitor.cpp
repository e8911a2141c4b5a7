#include "demos/monitor.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "demos/picture.h"
#include "raster/colour/encode.h"

namespace kinescope {
namespace {

constexpr double kAspect = 4.0 / 3.0;  // of every tube here, whatever its mode
constexpr int kPages = 2;

Rect fitted(const Rect& room) {
  const Size size = fit_within(
      {std::max(1, static_cast<int>(room.width)), std::max(1, static_cast<int>(room.height))},
      kAspect);
  const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
  // Centred; in a room less than a pixel wide it is the pixel in which the room begins.
  return {std::floor(room.x + std::max(0.0f, room.width - width) * 0.5f),
          std::floor(room.y + std::max(0.0f, room.height - height) * 0.5f), width, height};
}

void encode_scaled(std::span<const LinearRgb> light, float gain, std::span<Srgb8> out) {
  if (gain == 1.0f) return encode_row(light, out);
  std::vector<LinearRgb> scaled(light.begin(), light.end());
  for (LinearRgb& c : scaled) c = {c.r * gain, c.g * gain, c.b * gain};
  encode_row(scaled, out);
}

void in_rows(Workers& workers, int height, const std::function<void(int y)>& body) {
  constexpr int kRows = 16;
  workers.run((height + kRows - 1) / kRows, [&](int task, int) {
    for (int y = task * kRows; y < std::min(height, (task + 1) * kRows); ++y) body(y);
  });
}

}  // namespace

Monitor::Monitor(const TubeSettings& settings, PixelFormat format, const Rect& room)
    : buffer_(settings.mode.horizontal.active, settings.mode.vertical.active, format, kPages),
      face_(fitted(room)),
      tube_(settings, static_cast<int>(face_.width), static_cast<int>(face_.height)),
      sum_(std::make_shared<Image<LinearRgb>>()) {}

Monitor::Monitor(const Monitor&) = default;
Monitor::Monitor(Monitor&&) noexcept = default;
Monitor& Monitor::operator=(const Monitor&) = default;
Monitor& Monitor::operator=(Monitor&&) noexcept = default;
Monitor::~Monitor() = default;

void Monitor::resize(const Rect& room) {
  face_ = fitted(room);
  tube_.resize(static_cast<int>(face_.width), static_cast<int>(face_.height));
}

bool Monitor::adjust(const TubeSettings& settings, Seconds now) {
  if (tube_.adjust(settings)) return true;
  buffer_ = FrameBuffer(settings.mode.horizontal.active, settings.mode.vertical.active,
                        buffer_.format(), kPages);
  switch_on(now);
  return false;
}

std::size_t Monitor::state_bytes() const {
  const auto pixels = static_cast<std::size_t>(face_.width * face_.height);
  const auto page =
      static_cast<std::size_t>(buffer_.pitch_bytes()) * static_cast<std::size_t>(buffer_.height());
  return pixels * 2 * sizeof(LinearRgb) + page * kPages;
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
  const double frames = tube_time(step.exposure.begin) / refresh().period();
  const auto frame = static_cast<std::int64_t>(std::floor(frames + 1e-6));
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

/// Light is additive in time: the parts between deeds add up to the whole.
const Image<LinearRgb>& Monitor::gather(const Step& step, Workers& workers,
                                        const std::vector<Deed>& deeds) {
  const auto expose_to = [&](Seconds end) -> const Image<LinearRgb>& {
    return tube_.expose(buffer_, tube_time(end), workers);
  };
  Image<LinearRgb>& sum = *sum_;
  bool any = false;
  Seconds now = step.exposure.begin;
  const auto add = [&](Seconds end) {
    if (!(end > now)) return;
    now = end;
    const Image<LinearRgb>& part = expose_to(end);
    if (!std::exchange(any, true)) {
      sum = part;
      return;
    }
    in_rows(workers, sum.height(), [&](int y) {
      for (int x = 0; x < sum.width(); ++x) {
        LinearRgb& s = sum.at(x, y);
        const LinearRgb p = part.at(x, y);
        s = {s.r + p.r, s.g + p.g, s.b + p.b};
      }
    });
  };
  for (const Deed& deed : deeds) {
    add(std::min(deed.when, step.exposure.end));
    deed.deed();
  }
  add(step.exposure.end);
  return sum;
}

void Monitor::expose(const Step& step, Workers& workers, Image<Srgb8>& picture, double stops,
                     const std::vector<Deed>& deeds) {
  if (!on_) switch_on(step.exposure.begin);
  const double refreshes = step.exposure.length() / refresh().period();
  const double whole = refreshes > 1 ? 1 / refreshes : std::max(1.0, 1 / (refreshes * kIris));
  const double gain = whole * std::exp2(-stops);
  // An exposure of one period, give or take rounding, needs none.
  const float applied = std::abs(gain - 1) < 1e-6 ? 1.0f : static_cast<float>(gain);
  const int left = static_cast<int>(face_.x), top = static_cast<int>(face_.y);
  if (deeds.empty()) {
    const Seconds end = tube_time(step.exposure.end);
    tube_.photograph(buffer_, end, workers, {picture, applied, left, top});
    return;
  }
  const Image<LinearRgb>& light = gather(step, workers, deeds);
  assert(picture.contains(left, top) &&
         picture.contains(left + light.width() - 1, top + light.height() - 1));
  const auto width = static_cast<std::size_t>(light.width());
  in_rows(workers, light.height(), [&](int y) {
    encode_scaled({light.row(y), width}, applied, {picture.row(top + y) + left, width});
  });
}

}  // namespace kinescope
