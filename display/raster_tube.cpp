#include "display/raster_tube.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "display/beam_spot.h"
#include "display/gun_drive.h"
#include "display/phosphor_layer.h"
#include "display/tube_kernels.h"

namespace kinescope {
namespace {

constexpr int kLinesATask = 8;
constexpr int kRowsATask =
    64;  // of the output: many, for the lines at a task's edge are spread twice

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

}  // namespace

/// Work space of one worker.
struct TubeScratch {
  LayerScratch layer;
  std::vector<float> doses, mixed;
  std::vector<GunDrive> drives;
  std::vector<float> spread;  // a ring of lines spread over the output's columns, three channels
};

/// What an exposure works in; nothing of it outlives the exposure but the picture handed out, so a
/// copy of a tube starts with none of it.
struct TubeWork {
  std::vector<GunDrive> drives;           // of each cell's excitation in the window
  std::vector<std::vector<float>> light;  // a layer's light of the exposure, a cell each
  Image<LinearRgb> picture;
  std::vector<TubeScratch> scratch;

  TubeWork() = default;
  TubeWork(const TubeWork&) : TubeWork() {}
  TubeWork& operator=(const TubeWork&) { return *this = TubeWork(); }
  TubeWork(TubeWork&&) = default;
  TubeWork& operator=(TubeWork&&) = default;
  ~TubeWork() = default;
};

struct RasterTube::State {
  State(const TubeSettings& s, int new_width, int new_height);

  void set_size(int new_width, int new_height);
  void prepare(Workers& workers);
  void read_buffer(FrameBuffer& buffer, BeamTime end, Workers& workers);
  void read_lines(const FrameBuffer& buffer, BeamTime begin, BeamTime end, Workers& workers);
  void pass_window(BeamTime end, Workers& workers);
  void pass_line(BeamTime end, int line, bool first, TubeScratch& scratch);
  void spread_line(int line, TubeScratch& scratch, float* out);
  void spread_rows(int begin, int end, TubeScratch& scratch);
  void spread_picture(Workers& workers);

  int cells() const { return scan.mode().horizontal.active; }
  int lines() const { return scan.mode().vertical.active; }
  GunDrive* drive_row(int line) {
    return work.drives.data() + static_cast<std::ptrdiff_t>(line) * cells();
  }
  float* light_row(std::size_t layer, int line) {
    return work.light[layer].data() + static_cast<std::ptrdiff_t>(line) * cells();
  }
  std::ptrdiff_t spread_pitch() const { return 3 * width + 8; }

  TubeSettings settings;
  RasterScan scan;
  GunCurve curve;
  BeamTime now;
  bool fresh = true;  // no window of this exposure has passed yet
  std::vector<PhosphorLayer> layers;
  std::array<std::array<float, 3>, 3> colours{};
  bool three_guns = false;  // or one, for all layers
  AxisWeights across, down;
  int width = 0, height = 0;  // of the output
  TubeWork work;
};

RasterTube::State::State(const TubeSettings& s, int new_width, int new_height)
    : settings(s), scan(s.mode), curve(s.gamma) {
  const PhosphorType& type = find_phosphor(s.phosphor);
  three_guns = type.colour;
  colours = layer_colours(type);
  for (const Phosphor& phosphor : type.layers) {
    layers.emplace_back(phosphor, s.mode.pixel_clock_hz, to_clocks(scan.frame_clocks()), cells(),
                        lines());
  }
  set_size(new_width, new_height);
}

void RasterTube::State::set_size(int new_width, int new_height) {
  assert(new_width > 0 && new_height > 0);
  width = new_width;
  height = new_height;
  across = spot_weights(cells(), width, settings.spot_sigma_pixels, true);
  down = spot_weights(lines(), height, settings.spot_sigma_lines, false);
  work = TubeWork();
}

void RasterTube::State::prepare(Workers& workers) {
  const std::size_t n = static_cast<std::size_t>(cells());
  const std::size_t line_count = static_cast<std::size_t>(lines());
  work.drives.resize(n * line_count);
  work.light.resize(layers.size());
  for (auto& plane : work.light) plane.resize(n * line_count);
  if (work.picture.empty()) work.picture = Image<LinearRgb>(width, height);
  work.scratch.resize(static_cast<std::size_t>(workers.count()));
  for (TubeScratch& s : work.scratch) {
    s.layer.old_weight.resize(n);
    s.layer.new_weight.resize(n);
    s.doses.resize(n);
    s.drives.resize(n);
    s.mixed.resize(3 * n + 8);
    s.spread.resize(static_cast<std::size_t>(spread_pitch() * down.taps));
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
    std::vector<GunDrive>& row = work.scratch[static_cast<std::size_t>(worker)].drives;
    const int last = std::min(lines(), (task + 1) * kLinesATask);
    for (int line = task * kLinesATask; line < last; ++line) {
      const LineRanges ranges = line_ranges(scan, begin, end, line);
      bool read = false;
      for (const CellRange& range : ranges.range) {
        if (!range.excited || range.begin == range.end) continue;
        if (line >= buffer.height()) {
          std::fill(row.begin(), row.end(), GunDrive{});
        } else if (!std::exchange(read, true)) {
          buffer.read_line(line, row);
        }
        std::copy(row.begin() + range.begin, row.begin() + range.end,
                  drive_row(line) + range.begin);
      }
    }
  });
}

void RasterTube::State::pass_line(BeamTime end, int line, bool first, TubeScratch& s) {
  const LineRanges ranges = line_ranges(scan, now, end, line);
  const std::span<const GunDrive> row(drive_row(line), static_cast<std::size_t>(cells()));
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    float* const light_of_line = light_row(layer, line);
    if (first) std::fill_n(light_of_line, cells(), 0.0f);
    for (const CellRange& range : ranges.range) {
      if (range.begin == range.end) continue;
      if (range.excited) {
        const auto part = row.subspan(static_cast<std::size_t>(range.begin),
                                      static_cast<std::size_t>(range.end - range.begin));
        float* const doses = s.doses.data() + range.begin;
        if (three_guns) {
          curve.colour_doses(part, static_cast<int>(layer), doses);
        } else {
          curve.grey_doses(part, doses);
        }
      }
      layers[layer].pass(line, range, s.doses.data(), s.layer, light_of_line);
    }
  }
}

void RasterTube::State::spread_line(int line, TubeScratch& s, float* out) {
  const float* rows[3] = {};
  for (std::size_t layer = 0; layer < layers.size(); ++layer) rows[layer] = light_row(layer, line);
  float colour[3][3];
  for (std::size_t i = 0; i < 3; ++i) std::copy(colours[i].begin(), colours[i].end(), colour[i]);
  mix_layers(cells(), {rows, layers.size()}, colour, s.mixed.data());
  spread_across(width, across.taps, across.start.data(), across.weight.data(), s.mixed.data(), out);
}

void RasterTube::State::pass_window(BeamTime end, Workers& workers) {
  const bool first = std::exchange(fresh, false);
  for (PhosphorLayer& layer : layers) layer.set_window(to_clocks(end - now));
  workers.run(tasks_of(lines()), [&](int task, int worker) {
    TubeScratch& s = work.scratch[static_cast<std::size_t>(worker)];
    const int stop = std::min(lines(), (task + 1) * kLinesATask);
    for (int line = task * kLinesATask; line < stop; ++line) {
      pass_line(end, line, first, s);
    }
  });
}

/// Output rows [begin, end): each line they need is spread across once, into a ring of lines.
void RasterTube::State::spread_rows(int begin, int end, TubeScratch& s) {
  const auto ring_row = [&](int line) {
    return s.spread.data() + (line % down.taps) * spread_pitch();
  };
  const std::size_t taps = static_cast<std::size_t>(down.taps);
  std::vector<const float*> rows(taps);
  int next = down.start[static_cast<std::size_t>(begin)];
  for (int y = begin; y < end; ++y) {
    const std::size_t at = static_cast<std::size_t>(y);
    const int first = down.start[at];
    next = std::max(next, first);
    for (; next < first + down.taps; ++next) spread_line(next, s, ring_row(next));
    for (std::size_t t = 0; t < taps; ++t) rows[t] = ring_row(first + static_cast<int>(t));
    spread_down(3 * width, rows, down.weight.data() + at * taps, &work.picture.row(y)->r);
  }
}

void RasterTube::State::spread_picture(Workers& workers) {
  workers.run((height + kRowsATask - 1) / kRowsATask, [&](int task, int worker) {
    spread_rows(task * kRowsATask, std::min(height, (task + 1) * kRowsATask),
                work.scratch[static_cast<std::size_t>(worker)]);
  });
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
  for (PhosphorLayer& layer : state_->layers) layer.darken();
}

void RasterTube::resize(int width, int height) { state_->set_size(width, height); }

const Image<LinearRgb>& RasterTube::expose(FrameBuffer& buffer, Seconds end, Workers& workers) {
  State& s = *state_;
  const BeamTime until = s.scan.clock().at(end);
  assert(until >= s.now);
  s.prepare(workers);
  s.fresh = true;
  do {
    const BeamTime cut = std::min(until, s.now + s.scan.frame_clocks());
    s.read_buffer(buffer, cut, workers);
    s.pass_window(cut, workers);
    s.now = cut;
  } while (s.now < until);
  s.spread_picture(workers);
  return s.work.picture;
}

}  // namespace kinescope
