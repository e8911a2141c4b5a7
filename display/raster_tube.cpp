#include "display/raster_tube.h"

#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "display/layer_colours.h"
#include "display/tube/afterglow.h"
#include "display/tube/faceplate.h"
#include "display/tube/free_raster.h"
#include "display/tube/locked_raster.h"
#include "display/tube/retrace_light.h"
#include "display/tube/stage_timer.h"
#include "display/tube_kernels.h"

namespace kinescope {
namespace {

/// What an exposure works in; nothing of it outlives the exposure but the picture handed out, so a
/// copy of a tube starts with none of it.
struct TubeWork {
  LightOverlay overlay;  // light that does not lie on the raster's cells
  Image<LinearRgb> picture;
  std::pair<const void*, float> printed{};  // where photograph() last drew, and by what gain
  RasterTube::Times times;

  TubeWork() = default;
  TubeWork(const TubeWork&) : TubeWork() {}
  TubeWork& operator=(const TubeWork&) { return *this = TubeWork(); }
  TubeWork(TubeWork&&) = default;
  TubeWork& operator=(TubeWork&&) = default;
  ~TubeWork() = default;
};

std::vector<std::vector<Seconds>> taus_of(std::span<const Phosphor> laws) {
  std::vector<std::vector<Seconds>> taus;
  for (const Phosphor& layer : laws) {
    taus.emplace_back();
    for (const DecayTerm& term : layer.terms) taus.back().push_back(term.tau);
  }
  return taus;
}

/// The guns' signals, and each layer with its gun and its colour.
struct Beams {
  std::vector<Signal> signals;
  std::vector<FaceplateLayer> layers;
};
Beams beams_of(const PhosphorType& type) {
  const auto colours = layer_colours(type);
  Beams beams;
  beams.signals = type.colour ? std::vector{Signal::kRed, Signal::kGreen, Signal::kBlue}
                              : std::vector{Signal::kGrey};
  for (std::size_t i = 0; i < type.layers.size(); ++i) {
    beams.layers.push_back({type.colour ? static_cast<int>(i) : 0, colours[i]});
  }
  return beams;
}

}  // namespace

struct RasterTube::State {
  State(const TubeSettings& s, int new_width, int new_height);

  void set_size(int new_width, int new_height);
  void turn_knobs(const TubeSettings& turned);
  void reset();
  void leave_glow(Workers& workers);
  std::optional<FreeRaster> make_free() const;
  void build_front(const Faceplate* like);
  bool gather(FrameBuffer& buffer, Seconds end, Workers& workers);
  void set_up_screen(Workers& workers);

  /// Of the cells, if the raster is locked.
  std::span<const LayerLight> lights() const {
    return free ? std::span<const LayerLight>() : locked.light();
  }
  std::span<const Phosphor> laws() const { return find_phosphor(settings.phosphor).layers; }

  TubeSettings settings;
  RasterScan scan;
  Gun gun;
  BeamTime now;
  Beams beams;
  LockedRaster locked;
  std::optional<FreeRaster> free;  // instead, if sweeps may land elsewhere than the last one did
  Afterglow afterglow;             // of what the raster left behind
  // Where the raster lay when knobs moved it, until what glows there has been left behind.
  std::shared_ptr<Faceplate> moved_from;
  std::optional<FreeRaster> free_then;
  int width = 0, height = 0;                    // of the output
  std::shared_ptr<Faceplate> faceplate;         // follows from the settings and the size
  std::shared_ptr<RetraceLight> retrace_light;  // of a locked raster
  std::shared_ptr<FreeRetrace> free_retrace;    // of a free one
  BeamTime begun;                               // when the last exposure began
  TubeWork work;
};

RasterTube::State::State(const TubeSettings& s, int new_width, int new_height)
    : settings(s),
      scan(s.mode),
      gun(s.gun, SpotModel(s.spot), s.mode.pixel_clock_hz),
      beams(beams_of(find_phosphor(s.phosphor))),
      locked(s.mode, beams.signals, beams.layers, laws()),
      free(make_free()),
      afterglow(taus_of(laws()), new_width, new_height) {
  set_size(new_width, new_height);
}

std::optional<FreeRaster> RasterTube::State::make_free() const {
  if (!is_free(settings)) return std::nullopt;
  return FreeRaster(settings, beams.signals, beams.layers, laws());
}

void RasterTube::State::reset() {
  now = BeamTime();
  locked.darken();
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
    moved_from = faceplate;
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
  build_front(faceplate.get());
}

/// The raster has moved: what glows stays where it was.
void RasterTube::State::leave_glow(Workers& workers) {
  const std::shared_ptr<Faceplate> there = std::exchange(moved_from, nullptr);
  if (!there) return;
  if (free_then) return std::exchange(free_then, std::nullopt)->leave(*there, afterglow, workers);
  locked.leave(scan, now, *there, afterglow, workers);
}

/// What follows from the settings and the size.
/// @param like the faceplate until now, if the size is still the same
void RasterTube::State::build_front(const Faceplate* like) {
  faceplate = std::make_shared<Faceplate>(settings, beams.layers, width, height, like);
  retrace_light.reset();
  free_retrace.reset();
  if (free) {
    free_retrace = std::make_shared<FreeRetrace>(settings, gun, laws(), width, height);
  } else {
    retrace_light = std::make_shared<RetraceLight>(settings, gun, laws(), width, height);
  }
  work = TubeWork();
  locked.forget();
}

/// The light of [now, end). @return whether it differs from the last exposure's
bool RasterTube::State::gather(FrameBuffer& buffer, Seconds end, Workers& workers) {
  const BeamTime until = scan.clock().at(end);
  assert(until >= now);
  leave_glow(workers);
  begun = std::exchange(now, until);
  work.times = {};
  const bool still = afterglow.empty();
  work.overlay.resize(free || !still ? beams.layers.size() : 0);
  for (std::vector<float>& plane : work.overlay) {
    plane.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    workers.run(height, [&](int y, int) {
      std::fill_n(plane.begin() + static_cast<std::ptrdiff_t>(y) * width, width, 0.0f);
    });
  }
  if (!free) {
    afterglow.pass(scan.clock().seconds(until - begun), work.overlay, workers);
    afterglow.gather(work.overlay, workers);
    LockedRaster::Times times;
    const bool differs = locked.pass(scan, gun, buffer, begun, until, still, workers, times);
    work.times.guns = times.guns;
    work.times.phosphor = times.phosphor;
    return differs;
  }
  StageTimer watch;
  free->pass(scan, buffer, begun, until, *faceplate, *free_retrace, afterglow, work.overlay,
             workers);
  work.times.phosphor = watch.lap();
  return true;
}

/// What the exposure from `begun` to now sees besides the raster.
void RasterTube::State::set_up_screen(Workers& workers) {
  const LightOverlay* retrace = free ? nullptr : &retrace_light->light(begun, now, workers);
  if (retrace && !work.overlay.empty()) {
    for (std::size_t i = 0; i < retrace->size(); ++i) {
      add_scaled(width * height, 1, (*retrace)[i].data(), work.overlay[i].data());
    }
  }
  faceplate->set_overlay(work.overlay.empty() ? retrace : &work.overlay);
  faceplate->set_length(to_clocks(now - begun) / to_clocks(scan.frame_clocks()));
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
const FreeSweep* RasterTube::free_sweep() const {
  return state_->free ? &state_->free->sweep() : nullptr;
}
Seconds RasterTube::now() const { return state_->scan.clock().seconds(state_->now); }

void RasterTube::reset() { state_->reset(); }

void RasterTube::resize(int width, int height) { state_->set_size(width, height); }

bool RasterTube::adjust(const TubeSettings& settings) {
  const TubeSettings& now = state_->settings;
  if (settings == now) return true;
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
  StageTimer watch;
  s.set_up_screen(workers);
  s.work.times.glow = s.faceplate->show(s.lights(), workers, s.work.picture);
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
  StageTimer watch;
  s.set_up_screen(workers);
  s.work.times.glow =
      s.faceplate->photograph(s.lights(), workers, print.gain, print.out, print.left, print.top);
  s.work.times.glass = watch.lap() - s.work.times.glow;
  return true;
}

}  // namespace kinescope
