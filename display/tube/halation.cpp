#include "display/tube/halation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "display/tube/deflection.h"
#include "display/tube_kernels.h"

namespace kinescope {
namespace {

constexpr double kStepsASigma = 1.5;  // coarse pixels
constexpr int kLeastStep = 4, kMostStep = 32;

}  // namespace

Halation::Halation(const TubeSettings& s, int width, int height)
    : share_(static_cast<float>(s.glass.halation)),
      width_(width),
      height_(height),
      cells_(s.mode.horizontal.active),
      lines_(s.mode.vertical.active) {
  if (share_ <= 0) return;
  const double sigma_pixels = s.glass.halation_mm * pixels_a_mm(s.glass, width, height).down;
  step_ = std::clamp(static_cast<int>(sigma_pixels / kStepsASigma), kLeastStep, kMostStep);
  coarse_width_ = (width + step_ - 1) / step_ + 1;
  coarse_height_ = (height + step_ - 1) / step_ + 1;
  const double sigma = sigma_pixels / step_;
  double sum = 0;
  for (int i = 0; i <= std::ceil(3 * sigma); ++i) {
    kernel_.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
    sum += (i == 0 ? 1 : 2) * static_cast<double>(kernel_.back());
  }
  for (float& k : kernel_) k = static_cast<float>(static_cast<double>(k) / sum);

  block_cells_ = std::max(1, step_ * cells_ / width);
  block_lines_ = std::max(1, step_ * lines_ / height);
  blocks_across_ = (cells_ + block_cells_ - 1) / block_cells_ + 2;
  blocks_down_ = (lines_ + block_lines_ - 1) / block_lines_ + 2;
  const Deflection deflection(s.deflection, s.glass, 1);
  const GlassCamera camera(s.glass);
  for (int j = 0; j < coarse_height_; ++j) {
    for (int i = 0; i < coarse_width_; ++i) {
      const Place picture{2.0 * i * step_ / width - 1, 2.0 * j * step_ / height - 1};
      const Place sweep = deflection.sweep_of_glass(camera.glass_of_picture(picture));
      // Blocks' middles are at halves; block 0 is the dark one.
      const double x = 0.5 * (sweep.x + 1) * cells_ / block_cells_ + 0.5;
      const double y = 0.5 * (sweep.y + 1) * lines_ / block_lines_ + 0.5;
      const double left = std::clamp(std::floor(x), 0.0, blocks_across_ - 2.0);
      const double top = std::clamp(std::floor(y), 0.0, blocks_down_ - 2.0);
      samples_.push_back({static_cast<int>(top) * blocks_across_ + static_cast<int>(left),
                          static_cast<float>(std::clamp(x - left, 0.0, 1.0)),
                          static_cast<float>(std::clamp(y - top, 0.0, 1.0))});
    }
  }
}

/// Means of a row of blocks; `row` 0 is the first that holds light.
void Halation::pool(const LayerLight& light, int row, Plane& sums, Plane& blocks) const {
  const int first = row * block_lines_, last = std::min(lines_, first + block_lines_);
  sums.assign(static_cast<std::size_t>(cells_), 0.0f);
  for (int line = first; line < last; ++line) {
    add_rows(cells_, light.narrow.line(line), light.wide.line(line), sums.data());
  }
  float* out = blocks.data() + static_cast<std::ptrdiff_t>(row + 1) * blocks_across_ + 1;
  for (int begin = 0; begin < cells_; begin += block_cells_, ++out) {
    const int end = std::min(cells_, begin + block_cells_);
    const float sum = std::accumulate(sums.begin() + begin, sums.begin() + end, 0.0f);
    *out = sum / static_cast<float>((end - begin) * (last - first));
  }
}

void Halation::look_up(const Plane& blocks, Plane& coarse) const {
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& s = samples_[i];
    const float* above = blocks.data() + s.at;
    const float* below = above + blocks_across_;
    const float top = above[0] + s.right * (above[1] - above[0]);
    const float bottom = below[0] + s.right * (below[1] - below[0]);
    coarse[i] = top + s.down * (bottom - top);
  }
}

/// Of the pixels around each coarse one; outside the picture it is dark.
void Halation::add_means(const Plane& pixels, Plane& coarse) const {
  const auto around = [&](int i, int count) {
    const int middle = i * step_;
    return std::pair(std::max(0, middle - step_ / 2), std::min(count, middle + (step_ + 1) / 2));
  };
  for (int j = 0; j < coarse_height_; ++j) {
    const auto [top, bottom] = around(j, height_);
    for (int i = 0; i < coarse_width_; ++i) {
      const auto [left, right] = around(i, width_);
      float sum = 0;
      for (int y = top; y < bottom; ++y) {
        const float* row = pixels.data() + static_cast<std::ptrdiff_t>(y) * width_;
        for (int x = left; x < right; ++x) sum += row[x];
      }
      coarse[static_cast<std::size_t>(j * coarse_width_ + i)] +=
          sum / static_cast<float>(step_ * step_);
    }
  }
}

/// One coarse row of the light spread, down and then across; outside the picture it is dark.
/// @param down work space
void Halation::blur(const Plane& coarse, int row, Plane& down, Plane& out) const {
  const int reach = static_cast<int>(kernel_.size()) - 1;
  down.assign(static_cast<std::size_t>(coarse_width_ + 2 * reach), 0.0f);
  const auto weight = [&](int k) { return kernel_[static_cast<std::size_t>(std::abs(k))]; };
  for (int k = std::max(-reach, -row); k <= std::min(reach, coarse_height_ - 1 - row); ++k) {
    add_scaled(coarse_width_, weight(k),
               coarse.data() + static_cast<std::ptrdiff_t>(row + k) * coarse_width_,
               down.data() + reach);
  }
  out.assign(static_cast<std::size_t>(coarse_width_), 0.0f);
  for (int k = -reach; k <= reach; ++k) {
    add_scaled(coarse_width_, weight(k), down.data() + reach + k, out.data());
  }
}

void Halation::widen(const Plane& coarse_row, float glow, float* out) const {
  const float* from = coarse_row.data();
  for (int i = 0; i + 1 < coarse_width_; ++i) {
    // Pixels' middles are half a pixel beyond their number.
    fill_ramp(std::min(step_, width_ - i * step_), glow * from[i],
              glow * (from[i + 1] - from[i]) / static_cast<float>(step_), out + i * step_);
  }
}

void Halation::gather(std::span<const LayerLight> light,
                      const std::vector<std::vector<float>>* overlay, float unit,
                      Workers& workers) {
  if (share_ <= 0) return;
  const std::size_t count = light.empty() && overlay ? overlay->size() : light.size();
  const int layers = static_cast<int>(count), rows = blocks_down_ - 2;
  for (std::size_t layer = 0; layer < count; ++layer) {
    blocks_[layer].resize(static_cast<std::size_t>(blocks_across_ * blocks_down_), 0.0f);
    coarse_[layer].assign(samples_.size(), 0.0f);
    fine_[layer].resize(static_cast<std::size_t>(fine_pitch() * coarse_height_));
  }
  sums_.resize(static_cast<std::size_t>(workers.count()));
  downs_.resize(sums_.size());
  if (!light.empty()) {
    workers.run(layers * rows, [&](int task, int worker) {
      const std::size_t layer = static_cast<std::size_t>(task % layers);
      pool(light[layer], task / layers, sums_[static_cast<std::size_t>(worker)], blocks_[layer]);
    });
  }
  workers.run(layers, [&](int task, int) {
    const std::size_t layer = static_cast<std::size_t>(task);
    if (!light.empty()) look_up(blocks_[layer], coarse_[layer]);
    if (overlay) add_means((*overlay)[layer], coarse_[layer]);
  });
  const float glow = unit * share_ / (1 - share_);
  workers.run(coarse_height_, [&](int row, int worker) {
    Plane& blurred = sums_[static_cast<std::size_t>(worker)];
    Plane& down = downs_[static_cast<std::size_t>(worker)];
    for (std::size_t layer = 0; layer < count; ++layer) {
      blur(coarse_[layer], row, down, blurred);
      widen(blurred, glow, fine_[layer].data() + row * fine_pitch());
    }
  });
}

float Halation::rows(std::size_t layer, int y, int x, const float*& above,
                     const float*& below) const {
  above = below = nullptr;
  if (share_ <= 0) return 0;
  const int row = y / step_;
  above = fine_[layer].data() + row * fine_pitch() + x;
  below = above + fine_pitch();
  return (static_cast<float>(y - row * step_) + 0.5f) / static_cast<float>(step_);
}

}  // namespace kinescope
