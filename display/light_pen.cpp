#include "display/light_pen.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "display/tube/spread_kernels.h"

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
  double clock = 0;              // now, from the beginning of the run
  BeamTime origin;               // of the run
  std::vector<GunDrive> drives;  // work space
  std::vector<float> voltage;
  std::array<std::array<std::vector<float>, 2>, 3> doses;  // [gun][basis]
};

LightPen::LightPen(const TubeSettings& tube, const LightPenSettings& settings)
    : tube_(tube),
      settings_(settings),
      scan_(tube.mode),
      spot_(tube.spot),
      gun_(tube.gun, spot_, tube.mode.pixel_clock_hz),
      phosphor_(&find_phosphor(tube.phosphor)),
      spot_in_view_(spot_, settings.view_mm),
      dark_(phosphor_->layers, tube.mode.pixel_clock_hz, settings.rise, settings.coupling) {
  look();
}

void LightPen::move(Place place) {
  settings_.place = place;
  look();
}

void LightPen::look() {
  constexpr double kStepsAWidth = 4;
  constexpr int kLeastSteps = 4, kMostSteps = 64;
  const double widths = cell_mm(tube_, settings_.place) / spot_in_view_.least_mm();
  steps_ = static_cast<int>(
      std::clamp(std::ceil(kStepsAWidth * widths), double{kLeastSteps}, double{kMostSteps}));
  step_ = dark_.span(1.0 / steps_);
  const double rise_clocks = settings_.rise.count() * tube_.mode.pixel_clock_hz;
  lag_step_ = dark_.span(std::max(1.0 / steps_, rise_clocks / kLagSteps));
  lines_ = lines_in_view(tube_, spot_in_view_, phosphor_->colour ? 3 : 1, settings_.place, steps_);
  std::sort(lines_.begin(), lines_.end(), [&](const LineInView& a, const LineInView& b) {
    return scan_.line_start_clocks(0, a.line) < scan_.line_start_clocks(0, b.line);
  });
  calibrate();
}

/// A lone white line passes below the axis.
void LightPen::calibrate() {
  const double current = gun_.current(1), wide = spot_.wide_part(current);
  const double speed_mm = cell_mm(tube_, settings_.place) / steps_;  // a step
  const int reach = static_cast<int>(std::ceil(spot_in_view_.reach_mm() / speed_mm));
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
         (current - wide) * spot_in_view_.share(0, across_mm, 0) +
             wide * spot_in_view_.share(1, across_mm, 0),
         static_cast<double>(i + 1) / steps_);
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

void LightPen::read(const FrameBuffer& buffer, const LineInView& view, Line& line) const {
  constexpr std::array kGuns = {Signal::kRed, Signal::kGreen, Signal::kBlue};
  const auto cells = static_cast<std::size_t>(tube_.mode.horizontal.active);
  line.drives.assign(cells, GunDrive{});
  if (view.line < buffer.height()) buffer.read_line(view.line, line.drives);
  line.voltage.resize(cells + 2 * static_cast<std::size_t>(gun_.reach()) + kGroup);
  for (std::size_t gun = 0; gun < (phosphor_->colour ? 3 : 1); ++gun) {
    auto& doses = line.doses[gun];
    for (auto& row : doses) row.resize(cells);
    gun_.doses(line.drives, phosphor_->colour ? kGuns[gun] : Signal::kGrey, line.voltage,
               doses[0].data(), doses[1].data());
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
  for (int step = 0; step < view.cells * steps_; ++step) {
    const auto cell = static_cast<std::size_t>(view.first + step / steps_);
    const auto at = static_cast<std::size_t>(step);
    for (std::size_t layer = 0; layer < phosphor_->layers.size(); ++layer) {
      const std::size_t gun = phosphor_->colour ? layer : 0;
      const auto& share = view.share[gun];
      const auto& dose = line.doses[gun];
      rates[layer] =
          static_cast<double>(dose[0][cell] * share[0][at] + dose[1][cell] * share[1][at]);
    }
    line.diode.pass(step_, rates);
    line.clock = start + static_cast<double>(step + 1) / steps_;
    const Seconds since(line.clock / tube_.mode.pixel_clock_hz);
    if (visit({scan_.clock().seconds(line.origin) + since, line.diode.signal() / unit_}))
      return true;
  }
  return false;
}

void LightPen::run(const FrameBuffer& buffer, Exposure window, const Visit& visit) const {
  const BeamTime frame = scan_.frame_clocks(), end = scan_.clock().at(window.end);
  Line line(dark_);
  // What a frame before has left is there when the window opens.
  line.origin =
      BeamTime::from_raw((divide(scan_.clock().at(window.begin), frame).whole - 1) * frame.raw());
  for (BeamTime start = line.origin; start < end; start = start + frame) {
    for (const LineInView& view : lines_) {
      const BeamTime begins = start + scan_.line_start_clocks(0, view.line) + clocks(view.first);
      if (run_dark(to_clocks(std::min(begins, end) - line.origin), line, visit)) return;
      if (begins >= end) return;
      read(buffer, view, line);
      if (run_line(view, line, visit)) return;
    }
  }
  run_dark(to_clocks(end - line.origin), line, visit);
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
