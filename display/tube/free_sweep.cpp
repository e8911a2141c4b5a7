#include "display/tube/free_sweep.h"

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

constexpr double kOne = static_cast<double>(BeamTime::kOne);

double fraction(double turns) { return turns - std::floor(turns); }

}  // namespace

bool is_free(const TubeSettings& settings) {
  const SweepSettings& s = settings.sweep;
  return s.line_hz != 0 || s.field_hz != 0 || s.hum_x != 0 || s.hum_y != 0 || s.sag != 0 ||
         (settings.mode.interlaced && s.interlace_error != 0);
}

int field_lines(const VideoMode& mode) {
  return mode.interlaced ? (mode.vertical.active + 1) / 2 : mode.vertical.active;
}

FreeSweep::FreeSweep(const SweepSettings& settings, const VideoMode& mode)
    : settings_(settings),
      video_hz_(mode.pixel_clock_hz),
      line_hz_(settings.line_hz > 0 ? settings.line_hz : mode.line_rate_hz()),
      line_clocks_(mode.horizontal.total()),
      interlaced_(mode.interlaced),
      lines_(field_lines(mode)) {
  const int fields = mode.interlaced ? 2 : 1;
  const SyncTiming& v = mode.vertical;
  // Locked to both, a field has a whole number of lines or of half lines, exactly.
  const bool locked = settings.line_hz <= 0 && settings.field_hz <= 0;
  const double field_s =
      settings.field_hz > 0 ? 1 / settings.field_hz : mode.field_period().count();
  field_clocks_ =
      locked ? static_cast<double>(v.total()) / fields * line_clocks_ : field_s * clock_hz();
  fly_back_lines_ = (v.sync + v.back_porch) / fields;
}

void FreeSweep::take_over(const FreeSweep& before, BeamTime video_now) {
  const double then = to_clocks(before.of_video(video_now)), now = to_clocks(of_video(video_now));
  if (settings_.field_hz > 0) {
    const double phase = fraction((then - before.field_origin_) / before.field_clocks_);
    field_origin_ = now - phase * field_clocks_;
  }
  if (settings_.line_hz > 0) {
    const double phase = fraction((then - to_clocks(before.line_origin_)) / line_clocks_);
    line_origin_ = BeamTime::from_raw(std::llround((now - phase * line_clocks_) * kOne));
  }
}

BeamTime FreeSweep::of_video(BeamTime video) const {
  if (settings_.line_hz <= 0) return video;
  return BeamTime::from_raw(std::llround(static_cast<double>(video.raw()) / video_clocks()));
}

std::int64_t FreeSweep::field_begin_raw(std::int64_t number) const {
  return std::llround((field_origin_ + static_cast<double>(number) * field_clocks_) * kOne);
}

SweptField FreeSweep::field(std::int64_t number) const {
  SweptField f;
  f.number = number;
  f.begin = BeamTime::from_raw(field_begin_raw(number));
  f.end = BeamTime::from_raw(field_begin_raw(number + 1));
  const BeamTime in_line = divide(f.begin - line_origin_, line_period()).rest;
  f.first_line = in_line == BeamTime() ? f.begin : f.begin + line_period() - in_line;
  const double whole_lines = to_clocks(f.end - f.begin) / line_clocks_ - fly_back_lines_;
  f.lines = std::clamp(static_cast<int>(whole_lines), 0, lines_);
  f.fly_back = std::max(0.0, whole_lines);
  f.first_place = to_clocks(f.first_line - f.begin) / line_clocks_;
  // Of two fields' lines, which lie between each other, the first lie a quarter above the middle.
  if (interlaced_) f.first_place -= 0.25;
  if (interlaced_ && number % 2 != 0) f.first_place += 0.5 * settings_.interlace_error;
  return f;
}

SweptField FreeSweep::field_at(BeamTime t) const {
  std::int64_t number =
      static_cast<std::int64_t>(std::floor((to_clocks(t) - field_origin_) / field_clocks_));
  while (field_begin_raw(number) > t.raw()) --number;
  while (field_begin_raw(number + 1) <= t.raw()) ++number;
  return field(number);
}

}  // namespace kinescope
