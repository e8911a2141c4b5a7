#include "display/tube/free_retrace.h"

#include <algorithm>
#include <cmath>

#include "display/decay.h"
#include "display/tube/video_signal.h"

namespace kinescope {
namespace {

constexpr double kLeastLight = 1e-7;  // of a piece's whole light; less is not left behind

}  // namespace

/// A part of a field; times are clocks from the field's beginning.
struct FreeRetrace::Window {
  const FreeSweep& sweep;
  const SweptField& field;
  const SweepWarp& warp;
  double begin, end;
  double line, first_line;  // clocks a line; to the first
  double top;               // where the field begins, in its own lines from the raster's top
};

FreeRetrace::FreeRetrace(const TubeSettings& settings, const Gun& gun,
                         std::span<const Phosphor> laws, int width, int height)
    : settings_(settings),
      laws_(laws.begin(), laws.end()),
      path_(settings, width, height),
      painter_(width, height),
      current_{gun.blanked_current(false), gun.blanked_current(true)} {}

/// Where the sweep is, bent as it is then.
Place FreeRetrace::sweep_at(const Window& w, double clock) const {
  const SyncTiming& h = settings_.mode.horizontal;
  const double from_line = clock - w.first_line;
  const double number = std::floor(from_line / w.line), pixel = from_line - number * w.line;
  const double ends = h.active + h.front_porch;
  const double x = pixel < ends ? pixel : fly_back(ends, 0, (pixel - ends) / (h.total() - ends));
  const double lines = clock / w.line, turn = w.field.fly_back;
  const double all = to_clocks(w.field.end - w.field.begin) / w.line;
  const double y =
      w.top + (lines < turn ? lines : fly_back(turn, 0, (lines - turn) / (all - turn)));
  const auto last = static_cast<double>(w.warp.scale.size() - 1);
  const auto near = static_cast<std::size_t>(std::clamp(number, 0.0, last));
  const double seconds = (to_clocks(w.field.begin) + clock) / w.sweep.clock_hz();
  const SweepBend bend = sweep_bend(settings_.sweep, seconds, 0);
  const double scale = static_cast<double>(w.warp.scale[near]);
  return {(2 * x / h.active - 1) * scale + bend.shift_x,
          (2 * y / (last + 1) - 1) * scale + bend.shift_y};
}

/// @param drawn whether it is a part of the picture, and not blanked
void FreeRetrace::follow(const Window& w, double begin, double length, bool drawn) {
  if (drawn || begin + length <= w.begin || begin >= w.end) return;
  const double frame =
      static_cast<double>(settings_.mode.horizontal.total()) * settings_.mode.vertical.total();
  const int pieces = flight_pieces(length);
  const double step = length / pieces, video = w.sweep.video_clocks();
  const double whole_field = to_clocks(w.field.end - w.field.begin), hz = w.sweep.clock_hz();
  for (int i = 0; i < pieces; ++i) {
    const double clock = begin + i * step, middle = clock + 0.5 * step;
    const double from = std::max(clock, w.begin), to = std::min(clock + step, w.end);
    if (from >= to) continue;
    const double in_frame = std::fmod((to_clocks(w.field.begin) + middle) * video, frame);
    const double current = current_[in_sync_tip(settings_.mode, in_frame) ? 1 : 0];
    if (!(current > 0)) continue;
    // So that it lies in one phase and in its field, whatever the window.
    const double inset = 1e-3 * step, first = std::max(clock, 0.0) + inset;
    const double last = std::max(first, std::min(clock + step, whole_field) - inset);
    strokes_.push_back(path_.stroke(sweep_at(w, first), sweep_at(w, last), current));
    laid_.push_back({current * path_.cell_pixels() * (to - from) * video, (to - from) / hz,
                     (w.end - from) / hz});
  }
}

void FreeRetrace::follow_fields_lines(const Window& w) {
  const SyncTiming& h = settings_.mode.horizontal;
  const int first = static_cast<int>(std::floor((w.begin - w.first_line) / w.line));
  for (int line = std::max(first, -1); w.first_line + line * w.line < w.end; ++line) {
    const double start = w.first_line + line * w.line, back = start + h.active + h.front_porch;
    follow(w, start, h.active, line >= 0 && line < w.field.lines);
    if (h.front_porch > 0) follow(w, start + h.active, h.front_porch, false);
    follow(w, back, h.sync + h.back_porch, false);
  }
}

void FreeRetrace::leave_term(std::size_t layer, std::size_t term, Afterglow& afterglow,
                             std::vector<float>& sum, Workers& workers) {
  const DecayTerm& law = laws_[layer].terms[term];
  std::vector<BeamStroke> strokes;
  std::vector<double> lefts;
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const Laid& laid = laid_[i];
    const double left = law.share * left_of_dose(laid.since_s, laid.dwell_s, law.tau.count());
    if (left < kLeastLight) continue;
    strokes.push_back(strokes_[i]);
    lefts.push_back(left * laid.dose);
  }
  if (strokes.empty()) return;
  const Afterglow::Opened opened = afterglow.open(layer, term);
  std::vector<float> weights;
  for (const double left : lefts) {
    weights.push_back(static_cast<float>(left) * opened.scale);
    weights.push_back(static_cast<float>(left) * opened.seen);
  }
  const std::array<std::vector<float>*, 2> planes{&opened.to_come, &sum};
  painter_.add(strokes, weights, planes, workers);
}

void FreeRetrace::add_light(Afterglow& afterglow, LightOverlay& sum, Workers& workers) {
  std::vector<float> weights;
  for (const Laid& laid : laid_) {
    for (const Phosphor& law : laws_) {
      double light = 0;
      for (const DecayTerm& term : law.terms) {
        light += term.share * light_of_dose(0, laid.since_s, laid.dwell_s, term.tau.count());
      }
      weights.push_back(static_cast<float>(light * laid.dose));
    }
  }
  std::vector<std::vector<float>*> planes;
  for (std::vector<float>& plane : sum) planes.push_back(&plane);
  painter_.add(strokes_, weights, planes, workers);
  for (std::size_t layer = 0; layer < laws_.size(); ++layer) {
    for (std::size_t term = 0; term < laws_[layer].terms.size(); ++term) {
      leave_term(layer, term, afterglow, sum[layer], workers);
    }
  }
}

void FreeRetrace::pass(const FreeSweep& sweep, const SweptField& field, const SweepWarp& warp,
                       BeamTime begin, BeamTime end, Afterglow& afterglow, LightOverlay& sum,
                       Workers& workers) {
  if (!(current_[0] > 0)) return;
  const double line = to_clocks(sweep.line_period());
  const double first_line = to_clocks(field.first_line - field.begin);
  strokes_.clear();
  laid_.clear();
  follow_fields_lines({sweep, field, warp, to_clocks(begin - field.begin),
                       to_clocks(end - field.begin), line, first_line,
                       field.first_place - first_line / line});
  if (!strokes_.empty()) add_light(afterglow, sum, workers);
}

}  // namespace kinescope
