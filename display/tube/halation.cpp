#include "display/tube/halation.h"

#include <algorithm>
#include <cmath>

#include "display/tube/deflection.h"

namespace kinescope {
namespace {

constexpr double kStepsASigma = 1.5;  // coarse pixels
constexpr int kLeastStep = 4, kMostStep = 32;

}  // namespace

Halation::Halation(const TubeSettings& s, int width, int height)
    : share_(static_cast<float>(s.glass.halation)), width_(width) {
  if (share_ <= 0) return;
  const double height_mm = s.glass.diagonal_mm / std::hypot(s.glass.aspect, 1.0);
  const double sigma_pixels = s.glass.halation_mm * height / height_mm;
  step_ = std::clamp(static_cast<int>(sigma_pixels / kStepsASigma), kLeastStep, kMostStep);
  coarse_width_ = (width + step_ - 1) / step_ + 1;
  coarse_height_ = (height + step_ - 1) / step_ + 1;
  const double sigma = sigma_pixels / step_;
  double sum = 0;
  for (int i = 0; i <= std::ceil(3 * sigma); ++i) {
    kernel_.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
    sum += (i == 0 ? 1 : 2) * static_cast<double>(kernel_.back());
  }
  for (float& k : kernel_) k = static_cast<float>(k / sum);

  const Deflection deflection(s.deflection, s.glass, 1);
  const Camera camera(s.glass);
  const int cells = s.mode.horizontal.active, lines = s.mode.vertical.active;
  const auto sweep_at = [&](double x, double y) {
    return deflection.sweep_of_glass(
        camera.glass_of_picture({2 * x / width - 1, 2 * y / height - 1}));
  };
  const auto range = [](double from, double to, int count) {
    const int begin = static_cast<int>(std::lround(0.5 * (from + 1) * count));
    const int end = std::max(begin + 1, static_cast<int>(std::lround(0.5 * (to + 1) * count)));
    if (end <= 0 || begin >= count) return Range{};
    return Range{std::max(begin, 0), std::min(end, count)};
  };
  for (int j = 0; j < coarse_height_; ++j) {
    for (int i = 0; i < coarse_width_; ++i) {
      const double x = i * step_, y = j * step_, half = 0.5 * step_;
      patches_.push_back({range(sweep_at(x - half, y).x, sweep_at(x + half, y).x, cells),
                          range(sweep_at(x, y - half).y, sweep_at(x, y + half).y, lines)});
    }
  }
}

void Halation::pool(const LayerLight& light, int row, float* out) const {
  const Patch* patch = patches_.data() + static_cast<std::ptrdiff_t>(row) * coarse_width_;
  for (int i = 0; i < coarse_width_; ++i, ++patch) {
    float sum = 0;
    for (int line = patch->lines.begin; line < patch->lines.end; ++line) {
      const float* narrow = light.narrow.line(line);
      const float* wide = light.wide.line(line);
      for (int c = patch->cells.begin; c < patch->cells.end; ++c) sum += narrow[c] + wide[c];
    }
    const int count =
        (patch->lines.end - patch->lines.begin) * (patch->cells.end - patch->cells.begin);
    out[i] = count > 0 ? sum / static_cast<float>(count) : 0;
  }
}

void Halation::blur(std::vector<float>& coarse) const {
  const int reach = static_cast<int>(kernel_.size()) - 1;
  std::vector<float> line;
  const auto along = [&](float* at, std::ptrdiff_t stride, int count) {
    line.assign(static_cast<std::size_t>(count + 2 * reach), 0.0f);
    for (int i = 0; i < count; ++i) line[static_cast<std::size_t>(i + reach)] = at[i * stride];
    for (int i = 0; i < count; ++i) {
      const float* middle = line.data() + i + reach;
      float sum = kernel_[0] * middle[0];
      for (int k = 1; k <= reach; ++k) {
        sum += kernel_[static_cast<std::size_t>(k)] * (middle[k] + middle[-k]);
      }
      at[i * stride] = sum;
    }
  };
  for (int j = 0; j < coarse_height_; ++j) {
    along(coarse.data() + static_cast<std::ptrdiff_t>(j) * coarse_width_, 1, coarse_width_);
  }
  for (int i = 0; i < coarse_width_; ++i) along(coarse.data() + i, coarse_width_, coarse_height_);
}

void Halation::widen(const std::vector<float>& coarse, int row, float* out) const {
  const float* from = coarse.data() + static_cast<std::ptrdiff_t>(row) * coarse_width_;
  const float glow = share_ / (1 - share_), step = 1.0f / static_cast<float>(step_);
  for (int i = 0; i + 1 < coarse_width_; ++i) {
    const float a = glow * from[i], slope = glow * (from[i + 1] - from[i]) * step;
    for (int x = 0; x < step_ && i * step_ + x < width_; ++x) {
      // Pixels' middles are half a pixel beyond their number.
      out[i * step_ + x] = a + slope * (static_cast<float>(x) + 0.5f);
    }
  }
}

void Halation::gather(std::span<const LayerLight> light, Workers& workers) {
  if (share_ <= 0) return;
  const std::size_t count = static_cast<std::size_t>(coarse_width_ * coarse_height_);
  for (std::size_t layer = 0; layer < light.size(); ++layer) {
    coarse_[layer].resize(count);
    fine_[layer].resize(static_cast<std::size_t>(fine_pitch() * coarse_height_));
  }
  const int layers = static_cast<int>(light.size());
  workers.run(layers * coarse_height_, [&](int task, int) {
    const std::size_t layer = static_cast<std::size_t>(task % layers);
    const int row = task / layers;
    pool(light[layer], row,
         coarse_[layer].data() + static_cast<std::ptrdiff_t>(row) * coarse_width_);
  });
  workers.run(layers, [&](int layer, int) { blur(coarse_[static_cast<std::size_t>(layer)]); });
  workers.run(layers * coarse_height_, [&](int task, int) {
    const std::size_t layer = static_cast<std::size_t>(task % layers);
    const int row = task / layers;
    widen(coarse_[layer], row, fine_[layer].data() + row * fine_pitch());
  });
}

void Halation::rows(std::size_t layer, int y, int x, const float*& above, const float*& below,
                    float& below_share) const {
  if (share_ <= 0) {
    above = below = nullptr;
    return;
  }
  const int row = y / step_;
  below_share = (static_cast<float>(y - row * step_) + 0.5f) / static_cast<float>(step_);
  above = fine_[layer].data() + row * fine_pitch() + x;
  below = above + fine_pitch();
}

}  // namespace kinescope
