#include "display/tube/afterglow.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "display/decay.h"
#include "display/tube_kernels.h"

namespace kinescope {
namespace {

constexpr double kLeast = 1e-7;      // of white; what is less is dropped
constexpr double kFaded = 1e-5;      // what has faded less is not looked at
constexpr double kLeastKept = 1e-2;  // of what is stored; sums would lose digits
constexpr int kFloatsATask = 1 << 13;

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

Afterglow::Opened Afterglow::open(std::size_t layer, std::size_t term) {
  auto found = std::find_if(planes_.begin(), planes_.end(),
                            [&](const Plane& p) { return p.layer == layer && p.term == term; });
  if (found == planes_.end()) {
    found = planes_.insert(found, {layer, term, 1, 0, 1, {}});
    found->to_come.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  }
  found->kept_when_opened = found->kept;
  // Light that comes only now must not be taken for what has faded since.
  return {found->to_come, static_cast<float>(1 / found->kept),
          static_cast<float>(-found->owed / found->kept)};
}

void Afterglow::pass(Seconds length, LightOverlay& sum, Workers& workers) {
  if (!(length.count() > 0)) return;
  std::vector<Plane*> faded;
  for (Plane& plane : planes_) {
    const Decayed d = decayed(length.count(), taus_[plane.layer][plane.term].count());
    plane.owed += plane.kept * d.lost;
    plane.kept *= d.left;
    if (plane.kept < kLeastKept) faded.push_back(&plane);
  }
  if (!faded.empty()) gather(faded, sum, workers);
}

void Afterglow::gather(LightOverlay& sum, Workers& workers) {
  std::vector<Plane*> all;
  for (Plane& plane : planes_) all.push_back(&plane);
  if (!all.empty()) gather(all, sum, workers);
}

/// Those that have faded are stored anew as what is left of them.
void Afterglow::gather(const std::vector<Plane*>& planes, LightOverlay& sum, Workers& workers) {
  const int floats = width_ * height_;
  workers.run((floats + kFloatsATask - 1) / kFloatsATask, [&](int task, int) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(task) * kFloatsATask;
    const int count = std::min(kFloatsATask, floats - static_cast<int>(at));
    for (Plane* plane : planes) {
      float* const light = plane->to_come.data() + at;
      add_scaled(count, static_cast<float>(plane->owed), light, sum[plane->layer].data() + at);
      if (plane->kept >= kLeastKept) continue;
      const float kept = static_cast<float>(plane->kept);
      for (int i = 0; i < count; ++i) light[i] *= kept;
    }
  });
  for (Plane* plane : planes) {
    plane->owed = 0;
    if (plane->kept < kLeastKept) plane->kept_when_opened /= std::exchange(plane->kept, 1);
  }
  planes_.remove_if([](const Plane& plane) {
    if (plane.kept > kFaded * plane.kept_when_opened) return false;
    const float largest = *std::max_element(plane.to_come.begin(), plane.to_come.end());
    return plane.kept * static_cast<double>(largest) < kLeast;
  });
}

}  // namespace kinescope
