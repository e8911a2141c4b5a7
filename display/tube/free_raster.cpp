#include "display/tube/free_raster.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "display/decay.h"
#include "display/tube/line_ranges.h"
#include "display/tube/video_signal.h"

namespace kinescope {
namespace {

// A cell of a field is excited once; it has been dark for so many clocks before.
constexpr double kNever = 1e9;
constexpr int kLead = 4;  // lines by which a place is known ahead: what a spot's weights look at

}  // namespace

int FreeRaster::cells_begun(BeamTime since_first, int cells) {
  const std::int64_t begun = (since_first.raw() + BeamTime::kOne - 1) >> BeamTime::kBits;
  return static_cast<int>(std::clamp<std::int64_t>(begun, 0, cells));
}

FreeRaster::FreeRaster(const TubeSettings& settings, std::span<const Signal> signals,
                       std::span<const FaceplateLayer> layers, std::span<const Phosphor> laws)
    : settings_(settings),
      sweep_(settings.sweep, settings.mode),
      gun_(settings.gun, SpotModel(settings.spot), sweep_.clock_hz()),
      signals_(signals.begin(), signals.end()),
      layers_(layers.begin(), layers.end()),
      laws_(laws.begin(), laws.end()),
      cells_(settings.mode.horizontal.active),
      lines_(field_lines(settings.mode)),
      dose_scale_(static_cast<float>(sweep_.video_clocks() / (settings.mode.interlaced ? 2 : 1))),
      currents_(static_cast<std::size_t>(lines_)) {}

void FreeRaster::turn_knobs(const TubeSettings& settings) {
  settings_ = settings;
  gun_ = Gun(settings.gun, SpotModel(settings.spot), sweep_.clock_hz());
}

void FreeRaster::take_over(const FreeSweep& before, BeamTime video_now) {
  sweep_.take_over(before, video_now);
}

void FreeRaster::prepare(const Workers& workers) {
  while (doses_.size() < signals_.size()) doses_.push_back({{cells_, lines_}, {cells_, lines_}});
  const std::size_t n = static_cast<std::size_t>(cells_);
  scratch_.resize(static_cast<std::size_t>(workers.count()));
  for (Scratch& s : scratch_) {
    s.video.resize(n);
    s.drives.resize(n);
    s.voltage.resize(n + 2 * static_cast<std::size_t>(gun_.reach()) + kGroup);
    s.phosphor.old_weight.resize(n);
    s.phosphor.new_weight.resize(n);
  }
}

/// The last field but one has been shown and left: its memory serves the new one.
void FreeRaster::begin_field(const SweptField& swept) {
  Field field;
  if (fields_.size() == 2) {
    field = std::move(fields_.front());
    fields_.erase(fields_.begin());
    for (PhosphorLayer& phosphor : field.phosphor) phosphor.darken();
  } else {
    for (const Phosphor& law : laws_) {
      field.phosphor.emplace_back(law, sweep_.clock_hz(), kNever, cells_, lines_);
      field.light.push_back({{cells_, lines_}, {cells_, lines_}});
    }
  }
  const std::size_t n = static_cast<std::size_t>(lines_);
  field.swept = swept;
  field.warp = {std::vector<float>(n), std::vector<float>(n), std::vector<float>(n)};
  fields_.push_back(std::move(field));
  const double dark_s = std::max(0.0, to_clocks(swept.begin - loaded_until_) / sweep_.clock_hz());
  const double load = load_ * decayed(dark_s, settings_.sweep.sag_time_s).left;
  for (int line = 0; line < lines_; ++line) bend_line(line, load);
}

BeamTime FreeRaster::line_begin(const SweptField& swept, int line) const {
  return BeamTime::from_raw(swept.first_line.raw() + line * sweep_.line_period().raw());
}

void FreeRaster::read_line(const RasterScan& scan, const FrameBuffer& buffer, int line,
                           Scratch& s) {
  const double step = sweep_.video_clocks();
  const double begin = to_clocks(line_begin(fields_.back().swept, line));
  const double first = (begin + 0.5) * step;
  read_video(scan, buffer, first, step, s.video, s.drives);
  if (settings_.gun.sync > 0) {
    find_sync_tips(settings_.mode, first, step, cells_, s.tips);
  }
  float sum = 0;
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    float* const narrow = doses_[i].narrow.line(line);
    float* const wide = doses_[i].wide.line(line);
    gun_.doses(s.drives, signals_[i], s.voltage, narrow, wide, s.tips);
    sum = std::accumulate(narrow, narrow + cells_, sum);
    sum = std::accumulate(wide, wide + cells_, sum);
  }
  currents_[static_cast<std::size_t>(line)] =
      sum / static_cast<float>(cells_) / static_cast<float>(signals_.size());
}

/// Places a line of the last field at the voltage of a load.
void FreeRaster::bend_line(int line, double load) {
  Field& field = fields_.back();
  const double seconds = to_clocks(line_begin(field.swept, line)) / sweep_.clock_hz();
  kinescope::bend_line(field.warp, field.swept, line, sweep_bend(settings_.sweep, seconds, load),
                       cells_, lines_);
}

/// What lines that begin in [begin, end) draw loads the high voltage. The deflection feels that
/// kLead lines later, so that a line's neighbours have their places when it is drawn.
void FreeRaster::load_voltage(BeamTime begin, BeamTime end) {
  const SweepSettings& s = settings_.sweep;
  if (s.sag <= 0) return;
  const SweptField& swept = fields_.back().swept;
  const double hz = sweep_.clock_hz(), line_s = to_clocks(sweep_.line_period()) / hz;
  const SyncTiming& v = settings_.mode.vertical;
  const double white = static_cast<double>(v.active) / v.total();
  for (int line = 0; line < swept.lines; ++line) {
    const BeamTime at = line_begin(swept, line);
    if (at < begin || at >= end) continue;
    const double dark_s = std::max(0.0, to_clocks(at - loaded_until_) / hz);
    load_ *= decayed(dark_s, s.sag_time_s).left;
    if (line + kLead < lines_) bend_line(line + kLead, load_);
    const double current = static_cast<double>(currents_[static_cast<std::size_t>(line)]) / white;
    load_ += (current - load_) * decayed(line_s, s.sag_time_s).lost;
    loaded_until_ = at + sweep_.line_period();
  }
}

/// A cell's dose follows the time that the sweep gives it, and the voltage.
void FreeRaster::weigh_doses(const Field& field, int line) {
  const float scale = field.warp.scale[static_cast<std::size_t>(line)];
  const float weight = dose_scale_ / (scale * scale);
  if (weight == 1) return;
  for (LayerLight& doses : doses_) {
    for (CellPlane* plane : {&doses.narrow, &doses.wide}) {
      float* const dose = plane->line(line);
      for (int i = 0; i < cells_; ++i) dose[i] *= weight;
    }
  }
}

void FreeRaster::pass_line(Field& field, BeamTime begin, BeamTime end, int line, Scratch& s) {
  const BeamTime at = line_begin(field.swept, line);
  const int passed = cells_begun(begin - at, cells_), met = cells_begun(end - at, cells_);
  const double until = to_clocks(end - at) - passed;
  const CellRange glowing{0, passed, to_clocks(begin - at), false, 0};
  const CellRange excited{passed, met, kNever - (to_clocks(at - begin) + passed), true, until};
  if (met > passed) weigh_doses(field, line);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const LayerLight& doses = doses_[static_cast<std::size_t>(layers_[i].gun)];
    const DoseRows rows = {doses.narrow.line(line), doses.wide.line(line)};
    const LightRows light = {field.light[i].narrow.line(line), field.light[i].wide.line(line)};
    field.phosphor[i].pass(line, glowing, rows, s.phosphor, light);
    if (met > passed) field.phosphor[i].pass(line, excited, rows, s.phosphor, light);
  }
}

/// [begin, end) in sweep clocks lies within the last field.
void FreeRaster::pass_sweep(const RasterScan& scan, const FrameBuffer& buffer, BeamTime begin,
                            BeamTime end, Workers& workers) {
  const int lines = fields_.back().swept.lines;
  const auto each_line = [&](const auto& body) {
    workers.run(line_tasks(lines_), [&](int task, int worker) {
      const int stop = std::min(lines_, (task + 1) * kLinesATask);
      for (int line = task * kLinesATask; line < stop; ++line) {
        body(line, scratch_[static_cast<std::size_t>(worker)]);
      }
    });
  };
  each_line([&](int line, Scratch& s) {
    const BeamTime at = line_begin(fields_.back().swept, line);
    if (line < lines && at < end && begin < at + clocks(cells_)) read_line(scan, buffer, line, s);
  });
  load_voltage(begin, end);
  for (Field& field : fields_) {
    for (PhosphorLayer& phosphor : field.phosphor) phosphor.set_window(to_clocks(end - begin));
  }
  each_line([&](int line, Scratch& s) {
    for (Field& field : fields_) {
      if (line < field.swept.lines) pass_line(field, begin, end, line, s);
    }
  });
}

/// Of a field that may still be drawn.
int FreeRaster::lines_begun(const Field& field) const {
  int lines = field.swept.lines;
  while (lines > 0 && line_begin(field.swept, lines - 1) >= now_) --lines;
  return lines;
}

/// Lays the field's light of this pass on the faceplate.
void FreeRaster::show(Field& field, const GunRasters& rasters, const Faceplate& faceplate,
                      LightOverlay& sum, Workers& workers) const {
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const Faceplate::Spread spread{&field.light[i], {{{&sum[i], 1}}}, 0, lines_begun(field)};
    faceplate.spread(rasters, i, {&spread, 1}, workers);
    darken(field.light[i], workers);
  }
}

void FreeRaster::pass(const RasterScan& scan, FrameBuffer& buffer, BeamTime begin, BeamTime end,
                      const Faceplate& faceplate, FreeRetrace& retrace, Afterglow& afterglow,
                      LightOverlay& sum, Workers& workers) {
  prepare(workers);
  const auto pass_to = [&](BeamTime video_end) {
    const BeamTime until = sweep_.of_video(video_end);
    while (now_ < until) {
      if (fields_.empty() || fields_.back().swept.end <= now_) {
        if (fields_.size() == 2) {
          const auto rasters = faceplate.bent(fields_.front().warp);
          leave(fields_.front(), *rasters, faceplate, &sum, afterglow, workers);
        }
        begin_field(sweep_.field_at(now_));
      }
      const BeamTime cut = std::min(until, fields_.back().swept.end);
      afterglow.pass(Seconds(to_clocks(cut - now_) / sweep_.clock_hz()), sum, workers);
      pass_sweep(scan, buffer, now_, cut, workers);
      const Field& last = fields_.back();
      retrace.pass(sweep_, last.swept, last.warp, now_, cut, afterglow, sum, workers);
      now_ = cut;
    }
  };
  now_ = pass_begin_ = sweep_.of_video(begin);
  for (BeamTime flip = scan.retrace_from(begin); flip < end;
       flip = scan.retrace_from(flip + BeamTime::from_raw(1))) {
    pass_to(flip);
    buffer.vertical_retrace();
  }
  pass_to(end);
  for (Field& field : fields_) show(field, *faceplate.bent(field.warp), faceplate, sum, workers);
  afterglow.gather(sum, workers);
}

}  // namespace kinescope
