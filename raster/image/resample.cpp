#include "raster/image/resample.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "raster/colour/encode.h"

namespace kinescope {

double mitchell(double x) {
  x = std::abs(x);
  if (x < 1) return (7 * x * x * x - 12 * x * x + 16.0 / 3) / 6;
  if (x < 2) return (-7.0 / 3 * x * x * x + 12 * x * x - 20 * x + 32.0 / 3) / 6;
  return 0;
}

std::vector<Resampler::Taps> Resampler::taps(int from, int to) {
  std::vector<Taps> all;
  const double step = static_cast<double>(from) / to, widened = std::max(1.0, step);
  for (int i = 0; i < to; ++i) {
    if (from == to) {  // the cubic would blur even what is not scaled
      all.push_back({i, {1.0f}});
      continue;
    }
    const double centre = (i + 0.5) * step - 0.5;
    const int first = std::max(0, static_cast<int>(std::ceil(centre - 2 * widened)));
    const int last = std::min(from - 1, static_cast<int>(std::floor(centre + 2 * widened)));
    Taps t{first, {}};
    double sum = 0;
    for (int k = first; k <= last; ++k) sum += mitchell((k - centre) / widened);
    for (int k = first; k <= last; ++k) {
      t.weights.push_back(static_cast<float>(mitchell((k - centre) / widened) / sum));
    }
    all.push_back(std::move(t));
  }
  return all;
}

Image<Srgb8> darkest_of_blocks(const Image<Srgb8>& picture, int side) {
  Image<Srgb8> small(picture.width() / side, picture.height() / side);
  for (int y = 0; y < small.height(); ++y) {
    for (int x = 0; x < small.width(); ++x) {
      Srgb8 darkest = picture.at(side * x, side * y);
      for (int i = 1; i < side * side; ++i) {
        const Srgb8 p = picture.at(side * x + i % side, side * y + i / side);
        if (p.g < darkest.g) darkest = p;
      }
      small.at(x, y) = darkest;
    }
  }
  return small;
}

Resampler::Resampler(int from_width, int from_height, int to_width, int to_height)
    : from_width_(from_width),
      from_height_(from_height),
      across_(taps(from_width, to_width)),
      down_(taps(from_height, to_height)),
      narrowed_(to_width, from_height),
      out_(to_width, to_height) {}

void Resampler::scale_across(const Image<Srgb8>& picture, int y) {
  std::vector<LinearRgb> light;
  light.reserve(static_cast<std::size_t>(from_width_));
  const Srgb8* const row = picture.row(y);
  for (int x = 0; x < from_width_; ++x) {
    const LinearRgba c = decode(row[x]);
    light.push_back({c.r * c.a, c.g * c.a, c.b * c.a});
  }
  LinearRgb* to = narrowed_.row(y);
  for (const Taps& t : across_) {
    LinearRgb sum;
    const LinearRgb* from = light.data() + t.first;
    for (const float w : t.weights) {
      sum = {sum.r + w * from->r, sum.g + w * from->g, sum.b + w * from->b};
      ++from;
    }
    *to++ = sum;
  }
}

void Resampler::scale_down(int y) {
  const std::size_t width = static_cast<std::size_t>(out_.width());
  std::vector<LinearRgb> sums(width);
  const Taps& t = down_[static_cast<std::size_t>(y)];
  for (std::size_t k = 0; k < t.weights.size(); ++k) {
    const float w = t.weights[k];
    const LinearRgb* from = narrowed_.row(t.first + static_cast<int>(k));
    for (LinearRgb& sum : sums) {
      sum = {sum.r + w * from->r, sum.g + w * from->g, sum.b + w * from->b};
      ++from;
    }
  }
  encode_row(sums, {out_.row(y), width});
}

const Image<Srgb8>& Resampler::operator()(const Image<Srgb8>& picture, Workers& workers) {
  assert(picture.width() == from_width_ && picture.height() == from_height_);
  workers.run(from_height_, [&](int y, int) { scale_across(picture, y); });
  workers.run(out_.height(), [&](int y, int) { scale_down(y); });
  return out_;
}

}  // namespace kinescope
