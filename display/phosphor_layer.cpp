#include "display/phosphor_layer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "display/decay.h"

namespace kinescope {
namespace {

constexpr double kDwell = 1;            // clocks
constexpr double kLeastWeight = 1e-12;  // of white; what is less is left out
// Of a term that loses all but exp(-9) = 1e-4 in a frame only the last dose is kept: what is left
// of those before is carried over to a slower term. Without one, down to exp(-20.7) = 1e-9.
constexpr double kFadesInAFrame = 9, kFadesWholly = 20.7;
constexpr std::size_t kBases = 2;

float as_float(double v) { return static_cast<float>(v); }

}  // namespace

PhosphorLayer::PhosphorLayer(const Phosphor& phosphor, double clock_hz, double frame_clocks,
                             int width, int height)
    : width_(width), pitch_(whole_cache_lines<float>(width)), frame_clocks_(frame_clocks) {
  for (const DecayTerm& source : phosphor.terms) {
    Term term;
    term.share = source.share;
    term.tau = source.tau.count() * clock_hz;
    term.after_dwell = left_after_dwell(kDwell, term.tau);
    term.in_dwell = light_of_dose(0, kDwell, kDwell, term.tau);
    term.keep = std::exp(-frame_clocks / term.tau);
    term.gain = term.share * term.after_dwell * std::exp(-(frame_clocks - kDwell) / term.tau);
    fill_tables(term);
    terms_.push_back(std::move(term));
  }
  carry_over(frame_clocks);
  const std::size_t cells = offset(height);
  const int planes = static_cast<int>(
      std::count_if(terms_.begin(), terms_.end(), [](const Term& t) { return t.plane >= 0; }));
  for (std::size_t basis = 0; basis < kBases; ++basis) {
    doses_[basis].assign(cells, 0.0f);
    for (int i = 0; i < planes; ++i) states_[basis].emplace_back(cells, 0.0f);
  }
}

/// Gives slow terms their planes, and the slowest what outlives a frame of the others.
void PhosphorLayer::carry_over(double frame_clocks) {
  const auto slowest = std::max_element(terms_.begin(), terms_.end(),
                                        [](const Term& a, const Term& b) { return a.tau < b.tau; });
  int planes = 0;
  for (auto term = terms_.begin(); term != terms_.end(); ++term) {
    const double fades = term == slowest ? kFadesWholly : kFadesInAFrame;
    if (frame_clocks < fades * term->tau) {
      term->plane = planes++;
    } else if (term != slowest) {
      slowest->gain += term->gain;
    }
  }
}

void PhosphorLayer::fill_tables(Term& term) const {
  const std::size_t n = static_cast<std::size_t>(width_);
  term.reach = static_cast<int>(std::min<double>(width_, std::ceil(40 * term.tau) + 1));
  term.decay.resize(n);
  term.grown_back.resize(n);
  term.grown.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i);
    const Decayed after = decayed(t, term.tau);
    term.decay[n - 1 - i] = as_float(after.left);
    term.grown[i] = as_float(after.lost);
    term.grown_back[n - 1 - i] = term.grown[i];
  }
}

void PhosphorLayer::set_window(double length) {
  assert(length >= 0 && length <= frame_clocks_);
  window_ = length;
  for (Term& term : terms_) term.window_light = one_minus_exp(length / term.tau);
}

void PhosphorLayer::darken() {
  for (std::size_t basis = 0; basis < kBases; ++basis) {
    std::fill(doses_[basis].begin(), doses_[basis].end(), 0.0f);
    for (auto& plane : states_[basis]) std::fill(plane.begin(), plane.end(), 0.0f);
  }
}

void PhosphorLayer::pass(int line, const CellRange& range, DoseRows new_dose, LayerScratch& scratch,
                         LightRows light) {
  int count = range.end - range.begin;
  if (count <= 0) return;
  // Only the last cell can be one that the window's begin or end meets in its dwell.
  const double from_last = range.since - (count - 1);
  const double to_last = range.excited ? range.until - (count - 1) : kDwell;
  const bool dwells = std::min(from_last, to_last) < kDwell;
  if (dwells) --count;
  if (count > 0) {
    if (range.excited) {
      excite(line, range, count, new_dose, scratch, light);
    } else {
      emit(line, range, count, scratch, light);
    }
  }
  if (!dwells) return;
  for (std::size_t basis = 0; basis < kBases; ++basis) {
    pass_dwelling_cell(basis, line, range, new_dose[basis], light[basis]);
  }
}

void PhosphorLayer::leave(std::size_t which, int line, const CellRange& range, LightRows to_come) {
  const int count = range.end - range.begin;
  if (count <= 0) return;
  const Term& term = terms_[which];
  const double since_last = range.since - (count - 1);
  const float* decay = term.decay.data() + (width_ - count);
  // A cell that the beam is just leaving counts as left.
  const double of_dose =
      term.share * term.after_dwell * decayed(std::max(0.0, since_last - kDwell), term.tau).left;
  const double of_state = decayed(since_last, term.tau).left;
  for (std::size_t basis = 0; basis < kBases; ++basis) {
    float* const out = to_come[basis] + range.begin;
    std::fill_n(out, count, 0.0f);
    add_light(count, as_float(of_dose), decay, dose_row(basis, line) + range.begin, out);
    if (term.plane < 0) continue;
    add_light(count, as_float(of_state), decay, state_row(basis, term.plane, line) + range.begin,
              out);
  }
}

void PhosphorLayer::emit(int line, const CellRange& range, int count, LayerScratch& scratch,
                         LightRows light) {
  const double since_last = range.since - (count - 1);
  float* weight = scratch.old_weight.data();
  std::fill_n(weight, count, 0.0f);
  bool any = false;
  for (const Term& term : terms_) {
    const float* decay = term.decay.data() + (width_ - count);
    const double of_dose = term.share * term.after_dwell * term.window_light *
                           decayed(since_last - kDwell, term.tau).left;
    if (of_dose > kLeastWeight * term.window_light) {
      const int skip = std::max(0, count - term.reach);
      add_scaled(count - skip, as_float(of_dose), decay + skip, weight + skip);
      any = true;
    }
    if (term.plane >= 0) {
      const double of_state = term.window_light * decayed(since_last, term.tau).left;
      for (std::size_t basis = 0; basis < kBases; ++basis) {
        add_light(count, as_float(of_state), decay,
                  state_row(basis, term.plane, line) + range.begin, light[basis] + range.begin);
      }
    }
  }
  for (std::size_t basis = 0; any && basis < kBases; ++basis) {
    add_light(count, 1.0f, weight, dose_row(basis, line) + range.begin, light[basis] + range.begin);
  }
}

void PhosphorLayer::excite_slow(const Term& term, int line, const CellRange& range, int count,
                                LightRows light) {
  SlowTermStep step{};
  step.keep = as_float(term.keep);
  step.gain = as_float(term.gain);
  step.old_scale = as_float(decayed(range.since - (count - 1), term.tau).left);
  const Decayed before = decayed(frame_clocks_ - range.since, term.tau);
  step.old_constant = as_float(before.lost);
  step.old_slope = as_float(before.left);
  const Decayed after = decayed(range.until - (count - 1), term.tau);
  step.new_constant = as_float(after.lost);
  step.new_slope = as_float(after.left);
  step.old_decay = term.decay.data() + (width_ - count);
  step.old_grown = term.grown.data();
  step.new_grown = term.grown_back.data() + (width_ - count);
  excite_slow_term(
      count, step, dose_rows(line, range.begin),
      {state_row(0, term.plane, line) + range.begin, state_row(1, term.plane, line) + range.begin},
      {light[0] + range.begin, light[1] + range.begin});
}

void PhosphorLayer::excite(int line, const CellRange& range, int count, DoseRows new_dose,
                           LayerScratch& scratch, LightRows light) {
  const double since_last = range.since - (count - 1);
  const double before_first = frame_clocks_ - range.since;
  const double until_last = range.until - (count - 1);
  float* old_weight = scratch.old_weight.data();
  float* new_weight = scratch.new_weight.data();
  std::fill_n(old_weight, count, 0.0f);
  std::fill_n(new_weight, count, 0.0f);
  double even = 0;  // the new doses' light that all cells of the range share
  for (const Term& term : terms_) {
    if (term.plane >= 0) excite_slow(term, line, range, count, light);
    const double old_left =
        term.share * term.after_dwell * decayed(since_last - kDwell, term.tau).left;
    if (old_left > kLeastWeight) {
      const int skip = std::max(0, count - term.reach);
      const Decayed before = decayed(before_first, term.tau);
      add_scaled_product(count - skip, as_float(old_left),
                         term.decay.data() + (width_ - count + skip), as_float(before.lost),
                         as_float(before.left), term.grown.data() + skip, old_weight + skip);
    }
    const Decayed since_dwell = decayed(until_last - kDwell, term.tau);
    const double new_left = term.share * term.after_dwell * since_dwell.left;
    even += term.share * (term.in_dwell + term.after_dwell * since_dwell.lost);
    if (new_left > kLeastWeight) {
      add_scaled(count, as_float(new_left), term.grown_back.data() + (width_ - count), new_weight);
    }
  }
  excite_dose(count, old_weight, as_float(even), new_weight,
              {new_dose[0] + range.begin, new_dose[1] + range.begin}, dose_rows(line, range.begin),
              {light[0] + range.begin, light[1] + range.begin});
}

void PhosphorLayer::pass_dwelling_cell(std::size_t basis, int line, const CellRange& range,
                                       const float* new_dose, float* light) {
  const int cell = range.end - 1;
  const double since = range.since - (cell - range.begin);
  const double old_span = range.excited ? frame_clocks_ - since : window_;
  const double until = range.until - (cell - range.begin);
  const double dose = dose_row(basis, line)[cell];
  double sum = 0;
  for (const Term& term : terms_) {
    sum += dose * term.share * light_of_dose(since, since + old_span, kDwell, term.tau);
    if (range.excited) {
      sum += new_dose[cell] * term.share * light_of_dose(0, until, kDwell, term.tau);
    }
    if (term.plane < 0) continue;
    float& state = state_row(basis, term.plane, line)[cell];
    sum += state * decayed(since, term.tau).left * one_minus_exp(old_span / term.tau);
    if (range.excited) {
      state = as_float(term.keep * state + term.gain * dose);
      sum += state * one_minus_exp(until / term.tau);
    }
  }
  if (range.excited) dose_row(basis, line)[cell] = new_dose[cell];
  light[cell] += as_float(sum);
}

}  // namespace kinescope
