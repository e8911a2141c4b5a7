#include "display/raster_tube.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "display/layer_colours.h"
#include "display/phosphor_layer.h"
#include "display/tube/gun.h"
#include "display/tube/screen.h"

namespace kinescope {
namespace {

constexpr int kLinesATask = 8;

int tasks_of(int lines) { return (lines + kLinesATask - 1) / kLinesATask; }

int cells_started(BeamTime span, int least, int most) {
  const std::int64_t started = (span.raw() + BeamTime::kOne - 1) >> BeamTime::kBits;
  return static_cast<int>(std::clamp<std::int64_t>(started, least, most));
}

/// What happens in one window, at most a frame long, to the cells of a line: those whose last
/// excitation lies in the frame that has begun when the window opens, and those of the frame
/// before.
struct LineRanges {
  CellRange range[4];
};

LineRanges line_ranges(const RasterScan& scan, BeamTime begin, BeamTime end, int line) {
  const int width = scan.mode().horizontal.active;
  const BeamTime frame = scan.frame_clocks();
  const BeamTime since = divide(begin - scan.line_start_clocks(0, line), frame).rest;
  const BeamTime length = end - begin;
  LineRanges ranges;
  const auto add_pair = [&](int at, int first, int last, BeamTime since_zero, BeamTime until_zero) {
    const int excited = cells_started(until_zero, first, last);
    const double shift = first;
    ranges.range[at] = {first, excited, to_clocks(since_zero) - shift, true,
                        to_clocks(until_zero) - shift};
    ranges.range[at + 1] = {excited, last, to_clocks(since_zero) - excited, false, 0};
  };
  const int passed = cells_started(since, 0, width);
  add_pair(0, 0, passed, since, length + since - frame);
  add_pair(2, passed, width, since + frame, length + since);
  return ranges;
}

/// Work space of one worker.
struct TubeScratch {
  LayerScratch layer;
  std::vector<GunDrive> drives;
  std::vector<float> voltage, narrow, wide;
};

/// What an exposure works in; nothing of it outlives the exposure but the picture handed out, so a
/// copy of a tube starts with none of it.
struct TubeWork {
  std::vector<LayerLight> doses;  // of each signal, of each cell's excitation in the window
  std::vector<LayerLight> light;  // of each layer, of the exposure
  Image<LinearRgb> picture;
  std::vector<TubeScratch> scratch;

  TubeWork() = default;
  TubeWork(const TubeWork&) : TubeWork() {}
  TubeWork& operator=(const TubeWork&) { return *this = TubeWork(); }
  TubeWork(TubeWork&&) = default;
  TubeWork& operator=(TubeWork&&) = default;
  ~TubeWork() = default;
};

struct TubeLayer {
  PhosphorLayer phosphor;
  std::size_t signal;
};

}  // namespace

struct RasterTube::State {
  State(const TubeSettings& s, int new_width, int new_height);

  void set_size(int new_width, int new_height);
  void prepare(Workers& workers);
  void gather(FrameBuffer& buffer, Seconds end, Workers& workers);
  void read_buffer(FrameBuffer& buffer, BeamTime end, Workers& workers);
  void read_lines(const FrameBuffer& buffer, BeamTime begin, BeamTime end, Workers& workers);
  void read_line(const FrameBuffer& buffer, BeamTime begin, BeamTime end, int line,
                 TubeScratch& scratch);
  void pass_window(BeamTime end, Workers& workers);
  void pass_line(BeamTime end, int line, bool first, TubeScratch& scratch);

  int cells() const { return scan.mode().horizontal.active; }
  int lines() const { return scan.mode().vertical.active; }

  TubeSettings settings;
  RasterScan scan;
  Gun gun;
  BeamTime now;
  bool fresh = true;  // no window of this exposure has passed yet
  std::vector<Signal> signals;
  std::vector<TubeLayer> layers;
  std::vector<ScreenLayer> screen_layers;
  int width = 0, height = 0;       // of the output
  std::shared_ptr<Screen> screen;  // follows from the settings and the size
  TubeWork work;
};

RasterTube::State::State(const TubeSettings& s, int new_width, int new_height)
    : settings(s), scan(s.mode), gun(s.gun, SpotModel(s.spot), s.mode.pixel_clock_hz) {
  const PhosphorType& type = find_phosphor(s.phosphor);
  const auto colours = layer_colours(type);
  signals = type.colour ? std::vector{Signal::kRed, Signal::kGreen, Signal::kBlue}
                        : std::vector{Signal::kGrey};
  for (std::size_t i = 0; i < type.layers.size(); ++i) {
    const std::size_t signal = type.colour ? i : 0;
    layers.push_back({PhosphorLayer(type.layers[i], s.mode.pixel_clock_hz,
                                    to_clocks(scan.frame_clocks()), cells(), lines()),
                      signal});
    screen_layers.push_back({static_cast<int>(signal), colours[i]});
  }
  set_size(new_width, new_height);
}

void RasterTube::State::set_size(int new_width, int new_height) {
  assert(new_width > 0 && new_height > 0);
  width = new_width;
  height = new_height;
  screen = std::make_shared<Screen>(settings, screen_layers, width, height);
  work = TubeWork();
}

void RasterTube::State::prepare(Workers& workers) {
  const auto resize = [&](std::vector<LayerLight>& planes, std::size_t count) {
    while (planes.size() < count) planes.push_back({{cells(), lines()}, {cells(), lines()}});
  };
  resize(work.doses, signals.size());
  resize(work.light, layers.size());
  const std::size_t n = static_cast<std::size_t>(cells());
  work.scratch.resize(static_cast<std::size_t>(workers.count()));
  for (TubeScratch& s : work.scratch) {
    s.layer.old_weight.resize(n);
    s.layer.new_weight.resize(n);
    s.drives.resize(n);
    s.narrow.resize(n);
    s.wide.resize(n);
    s.voltage.resize(n + 2 * static_cast<std::size_t>(gun.reach()) + kGroup);
  }
}

/// The controller reads what the beam passes in [now, end), and flips pages as it retraces.
void RasterTube::State::read_buffer(FrameBuffer& buffer, BeamTime end, Workers& workers) {
  BeamTime begin = now;
  std::int64_t frame = divide(now, scan.frame_clocks()).whole;
  for (int field = 0;; frame += ++field / scan.fields(), field %= scan.fields()) {
    const BeamTime retrace = scan.retrace_start_clocks(frame, field);
    if (retrace < begin) continue;
    if (retrace >= end) break;
    read_lines(buffer, begin, retrace, workers);
    buffer.vertical_retrace();
    begin = retrace;
  }
  read_lines(buffer, begin, end, workers);
}

void RasterTube::State::read_lines(const FrameBuffer& buffer, BeamTime begin, BeamTime end,
                                   Workers& workers) {
  if (begin >= end) return;
  workers.run(tasks_of(lines()), [&](int task, int worker) {
    const int last = std::min(lines(), (task + 1) * kLinesATask);
    for (int line = task * kLinesATask; line < last; ++line) {
      read_line(buffer, begin, end, line, work.scratch[static_cast<std::size_t>(worker)]);
    }
  });
}

/// The doses of those cells of a line that the beam meets in [begin, end).
void RasterTube::State::read_line(const FrameBuffer& buffer, BeamTime begin, BeamTime end, int line,
                                  TubeScratch& s) {
  const LineRanges ranges = line_ranges(scan, begin, end, line);
  const auto met = [](const CellRange& r) { return r.excited && r.begin != r.end; };
  if (std::none_of(std::begin(ranges.range), std::end(ranges.range), met)) return;
  if (line >= buffer.height()) {
    std::fill(s.drives.begin(), s.drives.end(), GunDrive{});
  } else {
    buffer.read_line(line, s.drives);
  }
  for (std::size_t signal = 0; signal < signals.size(); ++signal) {
    gun.doses(s.drives, signals[signal], s.voltage, s.narrow.data(), s.wide.data());
    for (const CellRange& range : ranges.range) {
      if (!met(range)) continue;
      LayerLight& doses = work.doses[signal];
      std::copy(s.narrow.begin() + range.begin, s.narrow.begin() + range.end,
                doses.narrow.line(line) + range.begin);
      std::copy(s.wide.begin() + range.begin, s.wide.begin() + range.end,
                doses.wide.line(line) + range.begin);
    }
  }
}

void RasterTube::State::pass_line(BeamTime end, int line, bool first, TubeScratch& s) {
  const LineRanges ranges = line_ranges(scan, now, end, line);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    TubeLayer& layer = layers[i];
    const LayerLight& doses = work.doses[layer.signal];
    float* const narrow = work.light[i].narrow.line(line);
    float* const wide = work.light[i].wide.line(line);
    if (first) {
      std::fill_n(narrow, cells(), 0.0f);
      std::fill_n(wide, cells(), 0.0f);
    }
    for (const CellRange& range : ranges.range) {
      layer.phosphor.pass(line, range, {doses.narrow.line(line), doses.wide.line(line)}, s.layer,
                          {narrow, wide});
    }
  }
}

void RasterTube::State::pass_window(BeamTime end, Workers& workers) {
  const bool first = std::exchange(fresh, false);
  for (TubeLayer& layer : layers) layer.phosphor.set_window(to_clocks(end - now));
  workers.run(tasks_of(lines()), [&](int task, int worker) {
    TubeScratch& s = work.scratch[static_cast<std::size_t>(worker)];
    const int stop = std::min(lines(), (task + 1) * kLinesATask);
    for (int line = task * kLinesATask; line < stop; ++line) pass_line(end, line, first, s);
  });
}

/// The light of every cell in [now, end).
void RasterTube::State::gather(FrameBuffer& buffer, Seconds end, Workers& workers) {
  const BeamTime until = scan.clock().at(end);
  assert(until >= now);
  prepare(workers);
  fresh = true;
  do {
    const BeamTime cut = std::min(until, now + scan.frame_clocks());
    read_buffer(buffer, cut, workers);
    pass_window(cut, workers);
    now = cut;
  } while (now < until);
}

RasterTube::RasterTube(const TubeSettings& settings, int width, int height)
    : state_(std::make_unique<State>(settings, width, height)) {}
RasterTube::RasterTube(const RasterTube& other) : state_(std::make_unique<State>(*other.state_)) {}
RasterTube& RasterTube::operator=(const RasterTube& other) {
  if (this != &other) *state_ = *other.state_;
  return *this;
}
RasterTube::RasterTube(RasterTube&&) noexcept = default;
RasterTube& RasterTube::operator=(RasterTube&&) noexcept = default;
RasterTube::~RasterTube() = default;

const RasterScan& RasterTube::scan() const { return state_->scan; }
const TubeSettings& RasterTube::settings() const { return state_->settings; }
Seconds RasterTube::now() const { return state_->scan.clock().seconds(state_->now); }

void RasterTube::reset() {
  state_->now = BeamTime();
  for (TubeLayer& layer : state_->layers) layer.phosphor.darken();
}

void RasterTube::resize(int width, int height) { state_->set_size(width, height); }

const Image<LinearRgb>& RasterTube::expose(FrameBuffer& buffer, Seconds end, Workers& workers) {
  State& s = *state_;
  s.gather(buffer, end, workers);
  s.screen->show(s.work.light, workers, false, s.work.picture);
  return s.work.picture;
}

void RasterTube::photograph(FrameBuffer& buffer, Seconds end, Workers& workers, float gain,
                            Image<Srgb8>& out, int left, int top) {
  State& s = *state_;
  assert(out.contains(left, top) && out.contains(left + s.width - 1, top + s.height - 1));
  s.gather(buffer, end, workers);
  s.screen->photograph(s.work.light, workers, gain, out, left, top);
}

}  // namespace kinescope
