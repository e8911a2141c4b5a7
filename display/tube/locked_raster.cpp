#include "display/tube/locked_raster.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "display/tube/line_ranges.h"
#include "display/tube/stage_timer.h"

namespace kinescope {
namespace {

constexpr float kLeastGlow = 1e-7f;  // of white; what is less is not left behind

/// Frames after which the light of a still picture changes by less than one part in 10^5.
int frames_to_settle(const Phosphor& phosphor, const VideoMode& mode) {
  double slowest_s = 0;
  for (const DecayTerm& term : phosphor.terms) slowest_s = std::max(slowest_s, term.tau.count());
  const double frames = 11.5 * slowest_s / mode.frame_period().count();
  return static_cast<int>(std::min(std::ceil(frames) + 1, 1e9));
}

}  // namespace

LockedRaster::LockedRaster(const VideoMode& mode, std::span<const Signal> signals,
                           std::span<const FaceplateLayer> layers, std::span<const Phosphor> laws)
    : cells_(mode.horizontal.active),
      lines_(mode.vertical.active),
      signals_(signals.begin(), signals.end()) {
  const double frame_clocks = to_clocks(RasterScan(mode).frame_clocks());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    settling_frames_ = std::max(settling_frames_, frames_to_settle(laws[i], mode));
    layers_.push_back({PhosphorLayer(laws[i], mode.pixel_clock_hz, frame_clocks, cells_, lines_),
                       static_cast<std::size_t>(layers[i].gun)});
  }
}

void LockedRaster::darken() {
  work_.steady_frames = 0;
  work_.doses.forget();
  for (Layer& layer : layers_) layer.phosphor.darken();
}

void LockedRaster::prepare(const RasterScan& scan, const Gun& gun, Workers& workers) {
  work_.doses.prepare(scan, gun, signals_, workers);
  while (work_.light.size() < layers_.size()) {
    work_.light.push_back({{cells_, lines_}, {cells_, lines_}});
  }
  work_.scratch.resize(static_cast<std::size_t>(workers.count()));
  for (LayerScratch& s : work_.scratch) {
    s.old_weight.resize(static_cast<std::size_t>(cells_));
    s.new_weight.resize(static_cast<std::size_t>(cells_));
  }
}

/// @param first whether nothing of this exposure has been gathered yet
void LockedRaster::pass_line(const LineRanges& ranges, const Gun& gun, int line, bool first,
                             int worker) {
  LayerScratch& scratch = work_.scratch[static_cast<std::size_t>(worker)];
  const bool met = std::any_of(ranges.begin(), ranges.end(),
                               [](const CellRange& r) { return r.excited && r.begin != r.end; });
  DoseRows doses{};
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    PhosphorLayer& phosphor = layers_[i].phosphor;
    const std::size_t signal = layers_[i].signal;
    if (met && (i == 0 || signal != layers_[i - 1].signal)) {
      doses = work_.doses.of(gun, signals_[signal], signal, line, worker, phosphor.doses(line));
    }
    float* const narrow = work_.light[i].narrow.line(line);
    float* const wide = work_.light[i].wide.line(line);
    if (first) {
      std::fill_n(narrow, cells_, 0.0f);
      std::fill_n(wide, cells_, 0.0f);
    }
    for (const CellRange& range : ranges)
      phosphor.pass(line, range, doses, scratch, {narrow, wide});
  }
}

void LockedRaster::pass_window(const RasterScan& scan, const Gun& gun, BeamTime begin, BeamTime end,
                               bool first, Workers& workers) {
  for (Layer& layer : layers_) layer.phosphor.set_window(to_clocks(end - begin));
  workers.run(line_tasks(lines_), [&](int task, int worker) {
    const int stop = std::min(lines_, (task + 1) * kLinesATask);
    for (int line = task * kLinesATask; line < stop; ++line) {
      pass_line(line_ranges(scan, begin, end, line), gun, line, first, worker);
    }
  });
}

/// Whether another frame of what was shown for so long that its light is steady has been read.
bool LockedRaster::is_steady(bool still) {
  const bool changed = work_.doses.take_changed() || !still;
  work_.steady_frames = changed ? 0 : work_.steady_frames + 1;
  return work_.steady_frames > settling_frames_;
}

bool LockedRaster::pass(const RasterScan& scan, const Gun& gun, FrameBuffer& buffer, BeamTime begin,
                        BeamTime end, bool still, Workers& workers, Times& times) {
  prepare(scan, gun, workers);
  StageTimer watch;
  still = still && end - begin == scan.frame_clocks();
  bool first = true;
  do {
    const BeamTime cut = std::min(end, begin + scan.frame_clocks());
    work_.doses.read(scan, gun, signals_, buffer, begin, cut, workers);
    times.guns += watch.lap();
    if (is_steady(still)) return false;
    pass_window(scan, gun, begin, cut, first, workers);
    first = false;
    begin = cut;
    times.phosphor += watch.lap();
  } while (begin < end);
  return true;
}

void LockedRaster::leave(const RasterScan& scan, BeamTime now, const Faceplate& faceplate,
                         Afterglow& afterglow, Workers& workers) {
  LayerLight light{{cells_, lines_}, {cells_, lines_}};
  std::vector<std::uint8_t> glows(static_cast<std::size_t>(lines_));
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    PhosphorLayer& phosphor = layers_[i].phosphor;
    for (std::size_t term = 0; term < phosphor.terms(); ++term) {
      workers.run(lines_, [&](int line, int) {
        const LightRows rows = {light.narrow.line(line), light.wide.line(line)};
        for (const CellRange& range : line_ranges(scan, now, now, line)) {
          if (!range.excited) phosphor.leave(term, line, range, rows);
        }
        const auto bright = [this](const float* row) {
          return std::any_of(row, row + cells_, [](float l) { return l > kLeastGlow; });
        };
        glows[static_cast<std::size_t>(line)] = bright(rows[0]) || bright(rows[1]);
      });
      if (std::find(glows.begin(), glows.end(), 1) == glows.end()) continue;
      const Afterglow::Opened opened = afterglow.open(i, term);
      const Faceplate::Spread spread{&light, {{{&opened.to_come, opened.scale}}}};
      faceplate.spread(faceplate.rasters(), i, {&spread, 1}, workers);
    }
    phosphor.darken();
  }
  work_.doses.forget();
}

}  // namespace kinescope
