#include "display/tube/afterglow.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "display/decay.h"
#include "display/tube_kernels.h"

namespace kinescope {
namespace {

constexpr double kLeast = 1e-7;  // of white; what is less is dropped
constexpr int kFloatsATask = 1 << 15;

/// A plane stretched to another size, each pixel keeping its brightness.
std::vector<float> stretched(const std::vector<float>& from, int width, int height, int new_width,
                             int new_height) {
  std::vector<float> to;
  to.reserve(static_cast<std::size_t>(new_width) * static_cast<std::size_t>(new_height));
  struct Sample {
    int first, second;
    float share;
  };
  const auto sample = [](int i, int count, int new_count) {
    const double at = std::clamp((i + 0.5) * count / new_count - 0.5, 0.0, count - 1.0);
    const int first = static_cast<int>(at);
    return Sample{first, std::min(first + 1, count - 1), static_cast<float>(at - first)};
  };
  for (int y = 0; y < new_height; ++y) {
    const Sample down = sample(y, height, new_height);
    const float* above = from.data() + static_cast<std::ptrdiff_t>(down.first) * width;
    const float* below = from.data() + static_cast<std::ptrdiff_t>(down.second) * width;
    for (int x = 0; x < new_width; ++x) {
      const Sample s = sample(x, width, new_width);
      const float top = above[s.first] + s.share * (above[s.second] - above[s.first]);
      const float bottom = below[s.first] + s.share * (below[s.second] - below[s.first]);
      to.push_back(top + down.share * (bottom - top));
    }
  }
  return to;
}

}  // namespace

Afterglow::Afterglow(std::vector<std::vector<Seconds>> taus, int width, int height)
    : taus_(std::move(taus)), width_(width), height_(height) {}

void Afterglow::resize(int width, int height) {
  for (Plane& plane : planes_) {
    plane.to_come = stretched(plane.to_come, width_, height_, width, height);
  }
  width_ = width;
  height_ = height;
}

std::vector<float>& Afterglow::open(std::size_t layer, std::size_t term) {
  const auto found = std::find_if(planes_.begin(), planes_.end(), [&](const Plane& p) {
    return p.layer == layer && p.term == term;
  });
  if (found == planes_.end()) {
    Plane plane{layer, term, 1, true, 0, {}};
    plane.to_come.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    planes_.push_back(std::move(plane));
    return planes_.back().to_come;
  }
  const float kept = static_cast<float>(std::exchange(found->kept, 1));
  for (float& light : found->to_come) light *= kept;
  found->opened = true;
  return found->to_come;
}

void Afterglow::close(Plane& plane) const {
  if (!std::exchange(plane.opened, false)) return;
  plane.largest = *std::max_element(plane.to_come.begin(), plane.to_come.end());
}

void Afterglow::pass(Seconds length, LightOverlay& sum, Workers& workers) {
  if (planes_.empty() || !(length.count() > 0)) return;
  std::vector<float> now;
  for (Plane& plane : planes_) {
    close(plane);
    const Decayed d = decayed(length.count(), taus_[plane.layer][plane.term].count());
    now.push_back(static_cast<float>(plane.kept * d.lost));
    plane.kept *= d.left;
  }
  const int floats = width_ * height_;
  workers.run((floats + kFloatsATask - 1) / kFloatsATask, [&](int task, int) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(task) * kFloatsATask;
    const int count = std::min(kFloatsATask, floats - static_cast<int>(at));
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const Plane& plane = planes_[i];
      add_scaled(count, now[i], plane.to_come.data() + at, sum[plane.layer].data() + at);
    }
  });
  std::erase_if(planes_, [](const Plane& plane) {
    return plane.kept * static_cast<double>(plane.largest) < kLeast;
  });
}

}  // namespace kinescope
