#include "demos/tube_camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "display/light_encode.h"

namespace kinescope {
namespace {

constexpr float kSteady = 1e-4f;   // change of light from one refresh to the next
constexpr int kMostSettling = 60;  // refreshes; long phosphors have glowed for a second by then

float largest_change(const Image<LinearRgb>& before, const Image<LinearRgb>& after) {
  float largest = 0;
  for (std::size_t i = 0; i < after.pixels().size(); ++i) {
    const LinearRgb a = before.pixels()[i], b = after.pixels()[i];
    largest = std::max({largest, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
  }
  return largest;
}

}  // namespace

void add_light(Image<LinearRgb>& sum, const Image<LinearRgb>& light) {
  for (std::size_t i = 0; i < light.pixels().size(); ++i) {
    LinearRgb& to = sum.pixels()[i];
    const LinearRgb from = light.pixels()[i];
    to = {to.r + from.r, to.g + from.g, to.b + from.b};
  }
}

TubeCamera::TubeCamera(const TubeSettings& settings, int width, int height, Source source,
                       Workers& workers, TubeSignal signal)
    : settings_(settings),
      source_(std::move(source)),
      workers_(workers),
      signal_(signal),
      correct_(settings.gun.gamma),
      buffer_(settings.mode.horizontal.active, settings.mode.vertical.active,
              PixelFormat::kXrgb8888, 1),
      tube_(settings, width, height),
      period_(settings.mode.frame_period()) {
  settle();
}

void TubeCamera::show(std::int64_t refresh) {
  refresh_ = refresh;
  const Image<Srgb8>& picture = source_(refresh);
  buffer_.store(0, signal_ == TubeSignal::kPicture ? correct_(picture, workers_) : picture);
}

void TubeCamera::settle() {
  show(0);
  Image<LinearRgb> before;
  do {
    ++settling_;
    const Image<LinearRgb>& light =
        tube_.expose(buffer_, static_cast<double>(settling_) * period_, workers_);
    const bool steady = !before.empty() && largest_change(before, light) < kSteady;
    if (steady) break;
    before = light;
  } while (settling_ < kMostSettling);
}

void TubeCamera::turn_page() {
  if (now_ >= static_cast<double>(refresh_ + 1) * period_) show(refresh_ + 1);
}

const Image<LinearRgb>& TubeCamera::run_to(Seconds end) {
  turn_page();
  now_ = std::min(end, static_cast<double>(refresh_ + 1) * period_);
  return tube_.expose(buffer_, static_cast<double>(settling_) * period_ + now_, workers_);
}

Seconds TubeCamera::snapped(Seconds t) const {
  const double refreshes = t / period_;
  const double whole = std::round(refreshes);
  return std::abs(refreshes - whole) < 1e-6 ? whole * period_ : t;
}

void TubeCamera::pass_to(Seconds time) {
  time = snapped(time);
  while (now_ < time) run_to(time);
  turn_page();
}

bool TubeCamera::photograph(Exposure exposure, const RasterTube::Print& print) {
  exposure = {snapped(exposure.begin), snapped(exposure.end)};
  pass_to(exposure.begin);
  turn_page();
  if (exposure.end <= static_cast<double>(refresh_ + 1) * period_) {
    now_ = exposure.end;
    return tube_.photograph(buffer_, static_cast<double>(settling_) * period_ + now_, workers_,
                            print);
  }
  encode_light(expose(exposure), ExposureGain::fixed(print.gain), workers_, encoded_);
  for (int y = 0; y < encoded_.height(); ++y) {
    std::copy_n(encoded_.row(y), encoded_.width(), print.out.row(print.top + y) + print.left);
  }
  return true;
}

const Image<LinearRgb>& TubeCamera::expose(Exposure exposure) {
  exposure = {snapped(exposure.begin), snapped(exposure.end)};
  pass_to(exposure.begin);
  const Image<LinearRgb>* light = &run_to(exposure.end);
  if (now_ < exposure.end) {
    sum_ = *light;
    while (now_ < exposure.end) add_light(sum_, run_to(exposure.end));
    light = &sum_;
  }
  return *light;
}

}  // namespace kinescope
