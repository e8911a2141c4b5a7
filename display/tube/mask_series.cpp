#include "display/tube/mask_series.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kinescope {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr int kMostTerms = 32;   // along an axis
constexpr double kLeast = 1e-4;  // amplitude that counts

using Row = MaskSeries::Row;

/// What is left of a frequency, cycles a pixel: a triangle, whose transform is nowhere negative,
/// and so no series of openings becomes so.
double faded(double across, double down) {
  return std::max(0.0, 1 - 2 * std::abs(across)) * std::max(0.0, 1 - 2 * std::abs(down));
}

/// Periods from the last whole one.
float part_of_turn(double periods) { return static_cast<float>(periods - std::floor(periods)); }

/// exp(i n angle) of a row of angles, for n = 0, 1, ...: each from the last.
struct Powers {
  /// @param first, step of the angles, turns
  Powers(double first, double step) {
    const auto turn = static_cast<float>(kTwoPi);
    const float on = turn * static_cast<float>(step - std::round(step));
    const float on_cos = std::cos(on), on_sin = std::sin(on), at = turn * part_of_turn(first);
    float c = std::cos(at), s = std::sin(at);
    for (std::size_t i = 0; i < step_cos.size(); ++i) {
      step_cos[i] = c;
      step_sin[i] = s;
      c = step_cos[i] * on_cos - step_sin[i] * on_sin;
      s = step_sin[i] * on_cos + step_cos[i] * on_sin;
    }
    cosine.fill(1);
    sine.fill(0);
  }
  void next() {
    for (std::size_t i = 0; i < cosine.size(); ++i) {
      const float c = cosine[i] * step_cos[i] - sine[i] * step_sin[i];
      sine[i] = sine[i] * step_cos[i] + cosine[i] * step_sin[i];
      cosine[i] = c;
    }
  }
  Row cosine, sine, step_cos, step_sin;
};

}  // namespace

MaskSeries::MaskSeries(const MaskLattice& lattice)
    : period_x_(lattice.period_x()), period_y_(lattice.period_y()) {
  const int most_l = lattice.striped() ? 0 : kMostTerms;
  for (int k = 0; k <= kMostTerms; ++k) {
    for (int l = k == 0 ? 1 : -most_l; l <= most_l; ++l) {
      const double amplitude = 2 * lattice.amplitude(k, l);
      if (std::abs(amplitude) >= kLeast) terms_.push_back({k, l, static_cast<float>(amplitude)});
    }
    std::array<float, 3> cosine{}, sine{};
    for (int gun = 0; gun < 3; ++gun) {
      const double angle = kTwoPi * k * lattice.offset_mm(gun) / period_x_;
      cosine[static_cast<std::size_t>(gun)] = static_cast<float>(std::cos(angle));
      sine[static_cast<std::size_t>(gun)] = static_cast<float>(std::sin(angle));
    }
    gun_cos_.push_back(cosine);
    gun_sin_.push_back(sine);
  }
}

double MaskSeries::seen(const Term& term, const PixelStep& step) const {
  const double fx = term.k / period_x_, fy = term.l / period_y_;
  return faded(fx * step.right.x + fy * step.right.y, fx * step.down.x + fy * step.down.y);
}

void MaskSeries::drop_unresolved(std::span<const PixelStep> places) {
  constexpr double kBetween = 0.8;  // pixels between two of the places may be that much smaller
  std::erase_if(terms_, [&](const Term& term) {
    return std::all_of(places.begin(), places.end(), [&](const PixelStep& step) {
      const auto smaller = [](Place p) { return Place{p.x * kBetween, p.y * kBetween}; };
      return seen(term, {smaller(step.right), smaller(step.down)}) <= 0;
    });
  });
}

void MaskSeries::set_step(const PixelStep& step) {
  for (auto& pairs : pairs_) pairs.clear();
  most_l_ = 0;
  std::size_t count = 0;
  for (const Term& term : terms_) {
    const auto amplitude = static_cast<float>(term.amplitude * seen(term, step));
    if (amplitude == 0) continue;
    const auto k = static_cast<std::size_t>(term.k);
    count = k + 1;
    if (pairs_.size() < count) pairs_.resize(count);
    const int l = std::abs(term.l);
    most_l_ = std::max(most_l_, l);
    auto pair =
        std::find_if(pairs_[k].begin(), pairs_[k].end(), [&](const Pair& p) { return p.l == l; });
    if (pair == pairs_[k].end()) pair = pairs_[k].insert(pair, {l, 0, 0});
    pair->even += amplitude;
    pair->odd += term.l < 0 ? -amplitude : amplitude;
  }
  pairs_.resize(count);
}

std::array<Row, 3> MaskSeries::at(Place first, Place step) const {
  std::array<Row, 3> sum;
  for (Row& row : sum) row.fill(1);
  std::array<Row, kMostTerms + 1> cosine, sine;  // of each l
  Powers y(first.y / period_y_, step.y / period_y_);
  for (std::size_t l = 0; l <= static_cast<std::size_t>(most_l_); ++l, y.next()) {
    cosine[l] = y.cosine;
    sine[l] = y.sine;
  }
  Powers x(first.x / period_x_, step.x / period_x_);
  for (std::size_t k = 0; k < pairs_.size(); ++k, x.next()) {
    if (pairs_[k].empty()) continue;
    Row real{}, imaginary{};
    for (const Pair& pair : pairs_[k]) {
      const Row& c = cosine[static_cast<std::size_t>(pair.l)];
      const Row& s = sine[static_cast<std::size_t>(pair.l)];
      for (std::size_t i = 0; i < c.size(); ++i) {
        real[i] += pair.even * c[i];
        imaginary[i] += pair.odd * s[i];
      }
    }
    for (std::size_t i = 0; i < real.size(); ++i) {
      const float r = real[i] * x.cosine[i] - imaginary[i] * x.sine[i];
      const float j = real[i] * x.sine[i] + imaginary[i] * x.cosine[i];
      for (std::size_t gun = 0; gun < 3; ++gun) {
        sum[gun][i] += r * gun_cos_[k][gun] + j * gun_sin_[k][gun];
      }
    }
  }
  return sum;
}

}  // namespace kinescope
