#include "display/light_pen.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "display/tube/spread_kernels.h"
#include "display/tube/video_signal.h"

namespace kinescope {
namespace {

constexpr int kLagSteps = 8;  // of the amplifier's time constant
constexpr int kLags = 8;      // after which it has followed

/// Where a rising signal passes a level between two samples.
double crossing(double before, double after, double level) {
  return (level - before) / (after - before);
}

}  // namespace

/// A line as it passes, and what came before it.
struct LightPen::Line {
  explicit Line(const Photodiode& dark) : diode(dark) {}
  Photodiode diode;
  double clock = 0;                     // now, from the beginning of the run
  BeamTime origin;                      // of the run
  std::vector<GunDrive> video, drives;  // work space
  std::vector<CellSpan> tips;
  std::vector<float> voltage;
  std::array<std::array<std::vector<float>, 2>, 3> doses;  // [gun][basis]
};

LightPen::LightPen(const TubeSettings& tube, const LightPenSettings& settings)
    : tube_(tube),
      settings_(settings),
      scan_(tube.mode),
      free_(is_free(tube)),
      sweep_(tube.sweep, tube.mode),
      cell_clocks_(sweep_.video_clocks()),
      spot_(tube.spot),
      gun_(tube.gun, spot_, sweep_.clock_hz()),
      phosphor_(&find_phosphor(tube.phosphor)),
      view_{SpotInView(spot_, settings.view_mm), {}, settings.place, phosphor_->colour ? 3 : 1},
      dark_(phosphor_->layers, tube.mode.pixel_clock_hz, settings.rise, settings.coupling) {
  if (phosphor_->colour) {
    view_.mask =
        PenMask(tube.mask, {view_.spot.seen(0, 0, 0).sigma_mm, view_.spot.seen(1, 0, 0).sigma_mm});
  }
  look();
}

void LightPen::move(Place place) {
  settings_.place = view_.axis = place;
  look();
}

void LightPen::look() {
  constexpr double kStepsAWidth = 4;
  constexpr int kLeastSteps = 4, kMostSteps = 64;
  const double widths = cell_mm(tube_, settings_.place) / view_.spot.least_mm();
  view_.steps = static_cast<int>(
      std::clamp(std::ceil(kStepsAWidth * widths), double{kLeastSteps}, double{kMostSteps}));
  step_ = dark_.span(cell_clocks_ / view_.steps);
  const double rise_clocks = settings_.rise.count() * tube_.mode.pixel_clock_hz;
  lag_step_ = dark_.span(std::max(step_.clocks, rise_clocks / kLagSteps));
  if (!free_) lines_ = lines_in_view(tube_, view_, nullptr);
  std::sort(lines_.begin(), lines_.end(), [&](const LineInView& a, const LineInView& b) {
    return scan_.line_start_clocks(0, a.line) < scan_.line_start_clocks(0, b.line);
  });
  calibrate();
}

/// A lone white line passes below the axis.
void LightPen::calibrate() {
  const double current = gun_.current(1), wide = spot_.wide_part(current);
  const double speed_mm = cell_mm(tube_, settings_.place) / view_.steps;  // a step
  const int reach = static_cast<int>(std::ceil(view_.spot.reach_mm() / speed_mm));
  Photodiode diode = dark_;
  std::vector<double> rates(phosphor_->layers.size());
  std::vector<Sample> samples;  // times from the axis, clocks
  const auto pass = [&](const Photodiode::Span& span, double rate, double clock) {
    std::fill(rates.begin(), rates.end(), rate);
    diode.pass(span, rates);
    samples.push_back({Seconds(clock), diode.signal()});
  };
  for (int i = -reach; i < reach; ++i) {
    const double across_mm = (i + 0.5) * speed_mm;
    pass(step_,
         (current - wide) * view_.spot.share(0, across_mm, 0) +
             wide * view_.spot.share(1, across_mm, 0),
         (i + 1) * step_.clocks);
  }
  for (int i = 0; i < kLagSteps * kLags; ++i) {
    pass(lag_step_, 0, samples.back().time.count() + lag_step_.clocks);
  }
  const auto peak =
      std::max_element(samples.begin(), samples.end(),
                       [](const Sample& a, const Sample& b) { return a.signal < b.signal; });
  unit_ = std::max(peak->signal, 1e-30);
  const double level = settings_.threshold * unit_;
  auto after = std::find_if(samples.begin(), peak,
                            [&](const Sample& sample) { return sample.signal >= level; });
  double clock = after->time.count();
  if (after != samples.begin() && after->signal > level) {
    const Sample& before = *(after - 1);
    clock = before.time.count() +
            (clock - before.time.count()) * crossing(before.signal, after->signal, level);
  }
  delay_ = Seconds(clock / tube_.mode.pixel_clock_hz);
}

/// @param first_clock of the video, in the middle of a free sweep's first cell
void LightPen::read(const FrameBuffer& buffer, const LineInView& view, double first_clock,
                    Line& line) const {
  constexpr std::array kGuns = {Signal::kRed, Signal::kGreen, Signal::kBlue};
  const int cells = tube_.mode.horizontal.active;
  const auto n = static_cast<std::size_t>(cells);
  line.drives.assign(n, GunDrive{});
  if (free_) {
    line.video.resize(n);
    read_video(scan_, buffer, first_clock, cell_clocks_, line.video, line.drives);
    if (tube_.gun.sync > 0) {
      find_sync_tips(tube_.mode, first_clock, cell_clocks_, cells, line.tips);
    }
  } else if (view.line < buffer.height()) {
    buffer.read_line(view.line, line.drives);
  }
  line.voltage.resize(n + 2 * static_cast<std::size_t>(gun_.reach()) + kGroup);
  for (std::size_t gun = 0; gun < (phosphor_->colour ? 3 : 1); ++gun) {
    auto& doses = line.doses[gun];
    for (auto& row : doses) row.resize(n);
    gun_.doses(line.drives, phosphor_->colour ? kGuns[gun] : Signal::kGrey, line.voltage,
               doses[0].data(), doses[1].data(), line.tips);
  }
}

/// No beam in view until a clock of the run: step by step while the amplifier follows, then at
/// once.
bool LightPen::run_dark(double until, Line& line, const Visit& visit) const {
  const std::array<double, 8> none{};
  const auto pass = [&](const Photodiode::Span& span) {
    line.diode.pass(span, none);
    line.clock += span.clocks;
    const Seconds since(line.clock / tube_.mode.pixel_clock_hz);
    return visit({scan_.clock().seconds(line.origin) + since, line.diode.signal() / unit_});
  };
  for (int i = 0; i < kLagSteps * kLags && line.clock + lag_step_.clocks < until; ++i) {
    if (pass(lag_step_)) return true;
  }
  return line.clock < until && pass(dark_.span(until - line.clock));
}

bool LightPen::run_line(const LineInView& view, Line& line, const Visit& visit) const {
  std::array<double, 8> rates{};
  const double start = line.clock;
  for (int step = 0; step < view.cells * view_.steps; ++step) {
    const auto cell = static_cast<std::size_t>(view.first + step / view_.steps);
    const auto at = static_cast<std::size_t>(step);
    for (std::size_t layer = 0; layer < phosphor_->layers.size(); ++layer) {
      const std::size_t gun = phosphor_->colour ? layer : 0;
      const auto& share = view.share[gun];
      const auto& dose = line.doses[gun];
      rates[layer] =
          static_cast<double>(dose[0][cell] * share[0][at] + dose[1][cell] * share[1][at]);
    }
    line.diode.pass(step_, rates);
    line.clock = start + (step + 1) * step_.clocks;
    const Seconds since(line.clock / tube_.mode.pixel_clock_hz);
    if (visit({scan_.clock().seconds(line.origin) + since, line.diode.signal() / unit_}))
      return true;
  }
  return false;
}

/// A line in view, which begins at a clock of the run. @return whether no more is wanted
bool LightPen::run_view(const FrameBuffer& buffer, const LineInView& view, double begins,
                        double until, double first_clock, Line& line, const Visit& visit) const {
  if (run_dark(std::min(begins, until), line, visit) || begins >= until) return true;
  read(buffer, view, first_clock, line);
  return run_line(view, line, visit);
}

void LightPen::run(const FrameBuffer& buffer, Exposure window, const Visit& visit) const {
  return free_ ? run_free(buffer, window, visit) : run_locked(buffer, window, visit);
}

void LightPen::run_locked(const FrameBuffer& buffer, Exposure window, const Visit& visit) const {
  const BeamTime frame = scan_.frame_clocks(), end = scan_.clock().at(window.end);
  Line line(dark_);
  // What a frame before has left is there when the window opens.
  line.origin =
      BeamTime::from_raw((divide(scan_.clock().at(window.begin), frame).whole - 1) * frame.raw());
  const double until = to_clocks(end - line.origin);
  for (BeamTime start = line.origin; start < end; start = start + frame) {
    for (const LineInView& view : lines_) {
      const BeamTime begins = start + scan_.line_start_clocks(0, view.line) + clocks(view.first);
      if (run_view(buffer, view, to_clocks(begins - line.origin), until, 0, line, visit)) return;
    }
  }
  run_dark(until, line, visit);
}

std::vector<LineInView> LightPen::field_in_view(const SweptField& field) const {
  const int cells = tube_.mode.horizontal.active, lines = field_lines(tube_.mode);
  const auto n = static_cast<std::size_t>(lines);
  SweepWarp warp{std::vector<float>(n), std::vector<float>(n), std::vector<float>(n)};
  for (int line = 0; line < lines; ++line) {
    const double clock = to_clocks(field.first_line) + line * to_clocks(sweep_.line_period());
    const SweepBend bend = sweep_bend(tube_.sweep, clock / sweep_.clock_hz(), 0);
    bend_line(warp, field, line, bend, cells, lines);
  }
  return lines_in_view(tube_, view_, &warp);
}

void LightPen::run_free(const FrameBuffer& buffer, Exposure window, const Visit& visit) const {
  SweptField field = sweep_.field_at(sweep_.of_video(scan_.clock().at(window.begin)));
  field = sweep_.field(field.number - 1);
  Line line(dark_);
  const auto video_clock = [&](double swept) { return swept * cell_clocks_; };
  const double origin = video_clock(to_clocks(field.begin));
  line.origin = BeamTime::from_raw(std::llround(origin * static_cast<double>(BeamTime::kOne)));
  const double until = to_clocks(scan_.clock().at(window.end) - line.origin);
  for (; video_clock(to_clocks(field.begin)) < origin + until;
       field = sweep_.field(field.number + 1)) {
    for (const LineInView& view : field_in_view(field)) {
      if (view.line >= field.lines) break;
      const double at = to_clocks(field.first_line) + view.line * to_clocks(sweep_.line_period());
      if (run_view(buffer, view, video_clock(at + view.first) - origin, until,
                   video_clock(at + 0.5), line, visit)) {
        return;
      }
    }
  }
  run_dark(until, line, visit);
}

std::optional<Seconds> LightPen::watch(const FrameBuffer& buffer, Exposure window) const {
  std::optional<Seconds> tripped;
  Sample before;
  run(buffer, window, [&](const Sample& sample) {
    if (before.signal < settings_.threshold && sample.signal >= settings_.threshold) {
      const double share = crossing(before.signal, sample.signal, settings_.threshold);
      const Seconds time = before.time + share * (sample.time - before.time);
      if (time >= window.begin && time < window.end) tripped = time;
    }
    before = sample;
    return tripped || sample.time >= window.end;
  });
  return tripped;
}

PixelAddress LightPen::address(Seconds tripped) const {
  const SyncTiming& across = scan_.mode().horizontal;
  BeamPosition beam = scan_.at(tripped - delay_);
  // At a margin the time may fall beside it, into the blanked part of the line.
  const double past_middle = beam.pixel - 0.5 * (across.active + across.total());
  if (past_middle > 0) {
    const double to_next = across.total() - beam.pixel + 0.5;
    beam = scan_.at(tripped - delay_ + Seconds(to_next / scan_.mode().pixel_clock_hz));
  }
  const int pixel = static_cast<int>(std::floor(beam.pixel));
  return {beam.frame, beam.line, std::min(pixel, across.active - 1)};
}

std::vector<LightPen::Sample> LightPen::record(const FrameBuffer& buffer, Exposure window) const {
  std::vector<Sample> samples;
  run(buffer, window, [&](const Sample& sample) {
    if (sample.time >= window.begin && sample.time < window.end) samples.push_back(sample);
    return sample.time >= window.end;
  });
  return samples;
}

}  // namespace kinescope
