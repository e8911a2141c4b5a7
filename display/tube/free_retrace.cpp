#include "display/tube/free_retrace.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "display/decay.h"
#include "display/tube/video_signal.h"

namespace kinescope {
namespace {

constexpr double kLeastLight = 1e-7;  // of a piece's whole light; less is not left behind
constexpr std::size_t kLightsAtOnce = 4;

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

/// Terms that leave light behind, the slowest first, so that those drawn together need much the
/// same strokes.
std::vector<FreeRetrace::TermPlace> FreeRetrace::terms_by_time() const {
  std::vector<TermPlace> terms;
  for (std::size_t layer = 0; layer < laws_.size(); ++layer) {
    for (std::size_t term = 0; term < laws_[layer].terms.size(); ++term) {
      terms.push_back({layer, term, laws_[layer].terms[term]});
    }
  }
  std::sort(terms.begin(), terms.end(), [](const TermPlace& a, const TermPlace& b) {
    return std::tuple(b.law.tau, a.layer, a.term) < std::tuple(a.law.tau, b.layer, b.term);
  });
  return terms;
}

/// What each piece has left of each term, and what it has given.
void FreeRetrace::weigh(const std::vector<TermPlace>& terms) {
  left_.resize(strokes_.size() * terms.size());
  given_.assign(strokes_.size() * laws_.size(), 0.0f);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const double tau_s = terms[t].law.tau.count();
    double dwell_s = 0, after_dwell = 1;
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
      const Laid& laid = laid_[i];
      if (laid.dwell_s != dwell_s) {
        dwell_s = laid.dwell_s;
        after_dwell = left_after_dwell(dwell_s, tau_s);
      }
      const double left = after_dwell * decayed(laid.since_s - dwell_s, tau_s).left;
      const double share = laid.dose * terms[t].law.share;
      left_[i * terms.size() + t] = static_cast<float>(share * left);
      given_[i * laws_.size() + terms[t].layer] += static_cast<float>(share * (1 - left));
    }
  }
}

/// What is left of terms from `first` on, as many as are drawn at once.
void FreeRetrace::leave_terms(const std::vector<TermPlace>& terms, std::size_t first,
                              Afterglow& afterglow, LightOverlay& sum, Workers& workers) {
  const std::size_t count = std::min(kLightsAtOnce, terms.size() - first);
  std::vector<BeamStroke> strokes;
  std::vector<float> weights;
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const auto left = left_.begin() + static_cast<std::ptrdiff_t>(i * terms.size() + first);
    const auto end = left + static_cast<std::ptrdiff_t>(count);
    if (static_cast<double>(*std::max_element(left, end)) < kLeastLight * laid_[i].dose) continue;
    strokes.push_back(strokes_[i]);
    weights.insert(weights.end(), left, end);
  }
  if (strokes.empty()) return;
  std::vector<FlightLight> lights;
  for (std::size_t t = first; t < first + count; ++t) {
    const TermPlace& term = terms[t];
    const Afterglow::Opened opened = afterglow.open(term.layer, term.term);
    lights.push_back({{{{&opened.to_come, opened.scale}, {&sum[term.layer], opened.seen}}}});
  }
  painter_.add(strokes, weights, lights, workers);
}

void FreeRetrace::add_light(Afterglow& afterglow, LightOverlay& sum, Workers& workers) {
  const std::vector<TermPlace> terms = terms_by_time();
  weigh(terms);
  std::vector<FlightLight> lights;
  for (std::vector<float>& plane : sum) lights.push_back({{{{&plane, 1}}}});
  painter_.add(strokes_, given_, lights, workers);
  for (std::size_t i = 0; i < terms.size(); i += kLightsAtOnce) {
    leave_terms(terms, i, afterglow, sum, workers);
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
