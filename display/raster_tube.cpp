#include "display/raster_tube.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "display/layer_colours.h"
#include "display/phosphor_layer.h"
#include "display/tube/gun.h"
#include "display/tube/retrace_light.h"
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
  bool changed = false;  // a line was not what it was a frame ago
};

class Stopwatch {
 public:
  /// ms since the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double, std::milli>(now - std::exchange(began_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

/// What an exposure works in; nothing of it outlives the exposure but the picture handed out, so a
/// copy of a tube starts with none of it.
struct TubeWork {
  std::vector<std::vector<GunDrive>> drives;  // of each line, when it was last read whole
  std::vector<LayerLight> doses;  // of each signal, of each cell's excitation in the window
  std::vector<LayerLight> light;  // of each layer, of the exposure
  Image<LinearRgb> picture;
  std::vector<TubeScratch> scratch;
  int steady_frames = 0;  // whole ones that passed while no line changed
  const void* printed = nullptr;
  float printed_gain = 0;
  RasterTube::Times times;

  TubeWork() = default;
  TubeWork(const TubeWork&) : TubeWork() {}
  TubeWork& operator=(const TubeWork&) { return *this = TubeWork(); }
  TubeWork(TubeWork&&) = default;
  TubeWork& operator=(TubeWork&&) = default;
  ~TubeWork() = default;
};

/// Frames after which the light of a still picture changes by less than one part in 10^5.
int frames_to_settle(const Phosphor& phosphor, const RasterScan& scan) {
  double slowest_s = 0;
  for (const DecayTerm& term : phosphor.terms) slowest_s = std::max(slowest_s, term.tau.count());
  const double frames = 11.5 * slowest_s / scan.mode().frame_period().count();
  return static_cast<int>(std::min(std::ceil(frames) + 1, 1e9));
}

struct TubeLayer {
  PhosphorLayer phosphor;
  std::size_t signal;
};

}  // namespace

struct RasterTube::State {
  State(const TubeSettings& s, int new_width, int new_height);

  void set_size(int new_width, int new_height);
  void turn_knobs(const TubeSettings& turned);
  void build_front(const Screen* like);
  void prepare(Workers& workers);
  bool gather(FrameBuffer& buffer, Seconds end, Workers& workers);
  bool is_steady(BeamTime length);
  void set_up_screen(Workers& workers);
  bool reuses_line(const std::vector<GunDrive>& drives, const LineRanges& ranges, int line);
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
  int settling_frames = 0;         // until the light of a still picture is steady
  int width = 0, height = 0;       // of the output
  std::shared_ptr<Screen> screen;  // follows from the settings and the size
  std::shared_ptr<RetraceLight> retrace_light;
  BeamTime begun;  // when the last exposure began
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
    settling_frames = std::max(settling_frames, frames_to_settle(type.layers[i], scan));
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
  build_front(nullptr);
}

void RasterTube::State::turn_knobs(const TubeSettings& turned) {
  settings = turned;
  gun = Gun(settings.gun, SpotModel(settings.spot), settings.mode.pixel_clock_hz);
  build_front(screen.get());
}

/// What follows from the settings and the size.
/// @param like the screen until now, if the size is still the same
void RasterTube::State::build_front(const Screen* like) {
  screen = std::make_shared<Screen>(settings, screen_layers, width, height, like);
  retrace_light =
      std::make_shared<RetraceLight>(settings, gun.current(-settings.gun.blanking), screen_layers,
                                     find_phosphor(settings.phosphor).layers, width, height);
  work = TubeWork();
}

void RasterTube::State::prepare(Workers& workers) {
  const auto resize = [&](std::vector<LayerLight>& planes, std::size_t count) {
    while (planes.size() < count) planes.push_back({{cells(), lines()}, {cells(), lines()}});
  };
  resize(work.doses, signals.size());
  resize(work.light, layers.size());
  work.drives.resize(static_cast<std::size_t>(lines()));
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
  if (reuses_line(s.drives, ranges, line)) return;
  s.changed = true;
  const bool whole =
      std::any_of(std::begin(ranges.range), std::end(ranges.range),
                  [&](const CellRange& r) { return met(r) && r.begin == 0 && r.end == cells(); });
  for (std::size_t signal = 0; signal < signals.size(); ++signal) {
    if (whole) {
      gun.doses(s.drives, signals[signal], s.voltage, work.doses[signal].narrow.line(line),
                work.doses[signal].wide.line(line));
      continue;
    }
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

/// Whether a line that the beam meets whole is what it was: then its doses are too.
bool RasterTube::State::reuses_line(const std::vector<GunDrive>& drives, const LineRanges& ranges,
                                    int line) {
  std::vector<GunDrive>& last = work.drives[static_cast<std::size_t>(line)];
  const auto whole = [&](const CellRange& r) {
    return r.excited && r.begin == 0 && r.end == cells();
  };
  if (std::none_of(std::begin(ranges.range), std::end(ranges.range), whole)) {
    last.clear();
    return false;
  }
  if (last == drives) return true;
  last = drives;
  return false;
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

/// Whether another frame of what was shown for so long that its light is steady has been read.
bool RasterTube::State::is_steady(BeamTime length) {
  bool changed = length != scan.frame_clocks();
  for (TubeScratch& s : work.scratch) changed |= std::exchange(s.changed, false);
  work.steady_frames = changed ? 0 : work.steady_frames + 1;
  return work.steady_frames > settling_frames;
}

/// The light of every cell in [now, end). @return whether it differs from the last exposure's
bool RasterTube::State::gather(FrameBuffer& buffer, Seconds end, Workers& workers) {
  const BeamTime until = scan.clock().at(end);
  assert(until >= now);
  prepare(workers);
  work.times = {};
  Stopwatch watch;
  fresh = true;
  begun = now;
  do {
    const BeamTime cut = std::min(until, now + scan.frame_clocks());
    read_buffer(buffer, cut, workers);
    work.times.guns += watch.lap();
    if (is_steady(until - now)) {
      now = cut;
      return false;
    }
    pass_window(cut, workers);
    now = cut;
    work.times.phosphor += watch.lap();
  } while (now < until);
  return true;
}

/// What the exposure from `begun` to now sees besides the raster.
void RasterTube::State::set_up_screen(Workers& workers) {
  screen->set_overlay(&retrace_light->light(begun, now, workers));
  screen->set_length(to_clocks(now - begun) / to_clocks(scan.frame_clocks()));
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
  state_->work.steady_frames = 0;
  for (TubeLayer& layer : state_->layers) layer.phosphor.darken();
}

void RasterTube::resize(int width, int height) { state_->set_size(width, height); }

bool RasterTube::adjust(const TubeSettings& settings) {
  const TubeSettings& now = state_->settings;
  const bool keeps = settings.mode == now.mode && settings.phosphor == now.phosphor;
  if (keeps) {
    state_->turn_knobs(settings);
  } else {
    state_ = std::make_unique<State>(settings, state_->width, state_->height);
  }
  return keeps;
}

const RasterTube::Times& RasterTube::times() const { return state_->work.times; }

const Image<LinearRgb>& RasterTube::expose(FrameBuffer& buffer, Seconds end, Workers& workers) {
  State& s = *state_;
  s.gather(buffer, end, workers);
  Stopwatch watch;
  s.set_up_screen(workers);
  s.work.times.glow = s.screen->show(s.work.light, workers, false, s.work.picture);
  s.work.times.glass = watch.lap() - s.work.times.glow;
  return s.work.picture;
}

bool RasterTube::photograph(FrameBuffer& buffer, Seconds end, Workers& workers,
                            const Print& print) {
  State& s = *state_;
  assert(print.out.contains(print.left, print.top) &&
         print.out.contains(print.left + s.width - 1, print.top + s.height - 1));
  const bool changed = s.gather(buffer, end, workers);
  const void* const place = print.out.row(print.top) + print.left;
  const bool same = std::exchange(s.work.printed, place) == place &&
                    std::exchange(s.work.printed_gain, print.gain) == print.gain;
  if (!changed && same && print.kept) return false;
  Stopwatch watch;
  s.set_up_screen(workers);
  s.work.times.glow =
      s.screen->photograph(s.work.light, workers, print.gain, print.out, print.left, print.top);
  s.work.times.glass = watch.lap() - s.work.times.glow;
  return true;
}

}  // namespace kinescope
