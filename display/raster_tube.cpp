#include "display/raster_tube.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "display/layer_colours.h"
#include "display/phosphor_layer.h"
#include "display/tube/afterglow.h"
#include "display/tube/free_raster.h"
#include "display/tube/retrace_light.h"
#include "display/tube/screen.h"
#include "display/tube/signal_doses.h"

namespace kinescope {
namespace {

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
  SignalDoses doses;
  std::vector<LayerLight> light;  // of each layer, of the exposure
  LightOverlay overlay;           // light that does not lie on its cells
  Image<LinearRgb> picture;
  std::vector<LayerScratch> scratch;        // of each worker
  int steady_frames = 0;                    // whole ones that passed while no line changed
  std::pair<const void*, float> printed{};  // where photograph() last drew, and by what gain
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

std::vector<std::vector<Seconds>> taus_of(const PhosphorType& type) {
  std::vector<std::vector<Seconds>> taus;
  for (const Phosphor& layer : type.layers) {
    taus.emplace_back();
    for (const DecayTerm& term : layer.terms) taus.back().push_back(term.tau);
  }
  return taus;
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
  void reset();
  void leave_glow(Workers& workers);
  std::optional<FreeRaster> make_free() const;
  void build_front(const Screen* like);
  void prepare(Workers& workers);
  bool gather(FrameBuffer& buffer, Seconds end, Workers& workers);
  bool gather_locked(FrameBuffer& buffer, BeamTime until, Workers& workers);
  void gather_free(FrameBuffer& buffer, BeamTime until, Workers& workers);
  bool is_steady(BeamTime length);
  void set_up_screen(Workers& workers);
  void pass_window(BeamTime end, Workers& workers);
  void pass_line(BeamTime end, int line, bool first, LayerScratch& scratch);

  /// Of the cells, if the raster is locked.
  std::span<const LayerLight> lights() const {
    return free ? std::span<const LayerLight>() : std::span<const LayerLight>(work.light);
  }
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
  std::optional<FreeRaster> free;  // if sweeps may land elsewhere than the last one did
  Afterglow afterglow;             // of what the raster left behind
  // Where the raster lay when knobs moved it, until what glows there has been left behind.
  std::shared_ptr<Screen> moved_from;
  std::optional<FreeRaster> free_then;
  int settling_frames = 0;         // until the light of a still picture is steady
  int width = 0, height = 0;       // of the output
  std::shared_ptr<Screen> screen;  // follows from the settings and the size
  std::shared_ptr<RetraceLight> retrace_light;
  BeamTime begun;  // when the last exposure began
  TubeWork work;
};

RasterTube::State::State(const TubeSettings& s, int new_width, int new_height)
    : settings(s),
      scan(s.mode),
      gun(s.gun, SpotModel(s.spot), s.mode.pixel_clock_hz),
      afterglow(taus_of(find_phosphor(s.phosphor)), new_width, new_height) {
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
  free = make_free();
  set_size(new_width, new_height);
}

std::optional<FreeRaster> RasterTube::State::make_free() const {
  if (!is_free(settings)) return std::nullopt;
  return FreeRaster(settings, signals, screen_layers, find_phosphor(settings.phosphor).layers);
}

void RasterTube::State::reset() {
  now = BeamTime();
  work.steady_frames = 0;
  for (TubeLayer& layer : layers) layer.phosphor.darken();
  afterglow.darken();
  moved_from.reset();
  free = make_free();
}

void RasterTube::State::set_size(int new_width, int new_height) {
  assert(new_width > 0 && new_height > 0);
  width = new_width;
  height = new_height;
  afterglow.resize(width, height);
  moved_from.reset();
  build_front(nullptr);
}

void RasterTube::State::turn_knobs(const TubeSettings& turned) {
  const bool moves = settings.deflection != turned.deflection || settings.spot != turned.spot ||
                     settings.sweep != turned.sweep;
  if (moves && !moved_from && now != BeamTime()) {
    moved_from = screen;
    free_then = free;
  }
  const FreeSweep swept = free ? free->sweep() : FreeSweep({}, settings.mode);
  settings = turned;
  gun = Gun(settings.gun, SpotModel(settings.spot), settings.mode.pixel_clock_hz);
  if (moves) {
    free = make_free();
    if (free) free->take_over(swept, now);
  }
  if (free) free->turn_knobs(settings);
  build_front(screen.get());
}

/// The raster has moved: what glows stays where it was.
void RasterTube::State::leave_glow(Workers& workers) {
  const std::shared_ptr<Screen> there = std::exchange(moved_from, nullptr);
  if (!there) return;
  if (free_then) return std::exchange(free_then, std::nullopt)->leave(*there, afterglow, workers);
  LayerLight light{{cells(), lines()}, {cells(), lines()}};
  for (std::size_t i = 0; i < layers.size(); ++i) {
    PhosphorLayer& phosphor = layers[i].phosphor;
    for (std::size_t term = 0; term < phosphor.terms(); ++term) {
      workers.run(lines(), [&](int line, int) {
        for (const CellRange& range : line_ranges(scan, now, now, line)) {
          if (range.excited) continue;
          phosphor.leave(term, line, range, {light.narrow.line(line), light.wide.line(line)});
        }
      });
      there->spread(there->rasters(), i, light, workers, afterglow.open(i, term));
    }
    phosphor.darken();
  }
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
  work.doses.prepare(scan, gun, signals, workers);
  while (work.light.size() < layers.size()) {
    work.light.push_back({{cells(), lines()}, {cells(), lines()}});
  }
  work.scratch.resize(static_cast<std::size_t>(workers.count()));
  for (LayerScratch& s : work.scratch) {
    s.old_weight.resize(static_cast<std::size_t>(cells()));
    s.new_weight.resize(static_cast<std::size_t>(cells()));
  }
}

void RasterTube::State::pass_line(BeamTime end, int line, bool first, LayerScratch& scratch) {
  const LineRanges ranges = line_ranges(scan, now, end, line);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    TubeLayer& layer = layers[i];
    const LayerLight& doses = work.doses.of(layer.signal);
    float* const narrow = work.light[i].narrow.line(line);
    float* const wide = work.light[i].wide.line(line);
    if (first) {
      std::fill_n(narrow, cells(), 0.0f);
      std::fill_n(wide, cells(), 0.0f);
    }
    for (const CellRange& range : ranges) {
      layer.phosphor.pass(line, range, {doses.narrow.line(line), doses.wide.line(line)}, scratch,
                          {narrow, wide});
    }
  }
}

void RasterTube::State::pass_window(BeamTime end, Workers& workers) {
  const bool first = std::exchange(fresh, false);
  for (TubeLayer& layer : layers) layer.phosphor.set_window(to_clocks(end - now));
  workers.run(line_tasks(lines()), [&](int task, int worker) {
    LayerScratch& s = work.scratch[static_cast<std::size_t>(worker)];
    const int stop = std::min(lines(), (task + 1) * kLinesATask);
    for (int line = task * kLinesATask; line < stop; ++line) pass_line(end, line, first, s);
  });
}

/// Whether another frame of what was shown for so long that its light is steady has been read.
bool RasterTube::State::is_steady(BeamTime length) {
  const bool changed =
      work.doses.take_changed() || length != scan.frame_clocks() || !afterglow.empty();
  work.steady_frames = changed ? 0 : work.steady_frames + 1;
  return work.steady_frames > settling_frames;
}

/// The light of [now, end). @return whether it differs from the last exposure's
bool RasterTube::State::gather(FrameBuffer& buffer, Seconds end, Workers& workers) {
  const BeamTime until = scan.clock().at(end);
  assert(until >= now);
  work.times = {};
  begun = now;
  leave_glow(workers);
  work.overlay.resize(free || !afterglow.empty() ? layers.size() : 0);
  for (std::vector<float>& plane : work.overlay) {
    plane.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f);
  }
  if (!free) return gather_locked(buffer, until, workers);
  gather_free(buffer, until, workers);
  return true;
}

void RasterTube::State::gather_free(FrameBuffer& buffer, BeamTime until, Workers& workers) {
  Stopwatch watch;
  free->pass(scan, buffer, now, until, *screen, afterglow, work.overlay, workers);
  now = until;
  work.times.phosphor = watch.lap();
}

bool RasterTube::State::gather_locked(FrameBuffer& buffer, BeamTime until, Workers& workers) {
  prepare(workers);
  Stopwatch watch;
  fresh = true;
  afterglow.pass(scan.clock().seconds(until - now), work.overlay, workers);
  do {
    const BeamTime cut = std::min(until, now + scan.frame_clocks());
    work.doses.read(scan, gun, signals, buffer, now, cut, workers);
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
  const LightOverlay& retrace = retrace_light->light(begun, now, workers);
  if (!work.overlay.empty() && !retrace.empty()) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
      add_scaled(width * height, 1, retrace[i].data(), work.overlay[i].data());
    }
  }
  screen->set_overlay(work.overlay.empty() ? &retrace : &work.overlay);
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

void RasterTube::reset() { state_->reset(); }

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
  s.work.times.glow = s.screen->show(s.lights(), workers, s.work.picture);
  s.work.times.glass = watch.lap() - s.work.times.glow;
  return s.work.picture;
}

bool RasterTube::photograph(FrameBuffer& buffer, Seconds end, Workers& workers,
                            const Print& print) {
  State& s = *state_;
  assert(print.out.contains(print.left, print.top) &&
         print.out.contains(print.left + s.width - 1, print.top + s.height - 1));
  const bool changed = s.gather(buffer, end, workers);
  const std::pair<const void*, float> printed(print.out.row(print.top) + print.left, print.gain);
  const bool same = std::exchange(s.work.printed, printed) == printed;
  if (!changed && same && print.kept) return false;
  Stopwatch watch;
  s.set_up_screen(workers);
  s.work.times.glow =
      s.screen->photograph(s.lights(), workers, print.gain, print.out, print.left, print.top);
  s.work.times.glass = watch.lap() - s.work.times.glow;
  return true;
}

}  // namespace kinescope
