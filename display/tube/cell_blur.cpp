#include "display/tube/cell_blur.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "display/tube/line_ranges.h"
#include "display/tube_kernels.h"

namespace kinescope {
namespace {

// Cells beside a line that may be lit; those beyond must stay dark for columns far outside.
constexpr int kLitBefore = kCellPad - 2, kLitAfter = kGroup - 2;

}  // namespace

CellBlur::CellBlur(const Variance& narrow, const Variance& wide)
    : axes_{Axes{weights(narrow.across), weights(narrow.down)},
            Axes{weights(wide.across), weights(wide.down)}} {}

CellBlur::Weights CellBlur::weights(double variance) {
  constexpr double kNone = 1e-6, kReach = 4;
  constexpr int kLeastReach = 6, kSteps = 512;
  if (!(variance > kNone)) return {1};
  const int reach =
      std::max(kLeastReach, static_cast<int>(std::ceil(kReach * std::sqrt(variance))));
  std::vector<double> exact;
  double sum = 0;
  for (int n = 0; n <= reach; ++n) {
    double weight = 0;
    for (int step = 0; step < kSteps; ++step) {
      const double frequency = std::numbers::pi * (step + 0.5) / kSteps;
      weight += std::exp(-0.5 * variance * frequency * frequency) * std::cos(n * frequency);
    }
    exact.push_back(weight);
    sum += n == 0 ? weight : 2 * weight;
  }
  Weights weights;
  for (const double w : exact) weights.push_back(static_cast<float>(w / sum));
  return weights;
}

bool CellBlur::empty() const {
  return std::all_of(axes_.begin(), axes_.end(),
                     [](const Axes& a) { return a.across.size() <= 1 && a.down.size() <= 1; });
}

int CellBlur::lines_beyond() const {
  return static_cast<int>(std::max(axes_[0].down.size(), axes_[1].down.size())) - 1;
}

void CellBlur::blur(const Axes& axes, const CellPlane& from, int cells, int lines, int beyond,
                    CellPlane& to, Workers& workers) {
  const int first = -kLitBefore, last = cells + kLitAfter;
  const auto each_line = [&](int begin, int end, const auto& body) {
    workers.run(line_tasks(end - begin), [&](int task, int) {
      const int stop = std::min(end, begin + (task + 1) * kLinesATask);
      for (int line = begin + task * kLinesATask; line < stop; ++line) body(line);
    });
  };
  CellPlane across(cells, lines);
  const int reach = static_cast<int>(axes.across.size());
  each_line(0, lines, [&](int line) {
    for (int n = 1 - reach; n < reach; ++n) {
      const int begin = std::max(n, first), end = std::min(cells + n, last);
      if (begin >= end) continue;
      add_scaled(end - begin, axes.across[static_cast<std::size_t>(std::abs(n))],
                 from.line(line) + begin - n, across.line(line) + begin);
    }
  });
  const int reach_down = static_cast<int>(axes.down.size());
  each_line(-beyond, lines + beyond, [&](int line) {
    float* const out = to.line(line + beyond) + first;
    std::fill_n(out, last - first, 0.0f);
    const int above = std::max(0, line - reach_down + 1);
    const int below = std::min(lines - 1, line + reach_down - 1);
    for (int l = above; l <= below; ++l) {
      add_scaled(last - first, axes.down[static_cast<std::size_t>(std::abs(l - line))],
                 across.line(l) + first, out);
    }
  });
}

void CellBlur::blur(const LayerLight& from, int cells, int lines, LayerLight& to,
                    Workers& workers) const {
  const int beyond = lines_beyond();
  if (to.narrow.pitch() == 0 || to.beyond != beyond) {
    const CellPlane dark(cells, lines + 2 * beyond);
    to = {dark, dark, beyond};
  }
  blur(axes_[0], from.narrow, cells, lines, beyond, to.narrow, workers);
  blur(axes_[1], from.wide, cells, lines, beyond, to.wide, workers);
}

}  // namespace kinescope
