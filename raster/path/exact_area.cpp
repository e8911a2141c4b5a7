#include "raster/path/exact_area.h"

#include <algorithm>
#include <array>

namespace kinescope {
namespace {

float covered(float winding, FillRule rule) {
  const float area = std::abs(winding);
  if (rule == FillRule::kNonZero) return std::min(area, 1.0f);
  const float rest = area - 2 * std::floor(area / 2);
  return rest <= 1 ? rest : 2 - rest;
}

}  // namespace

ExactArea::ExactArea(int width, int height)
    : width_(width),
      height_(height),
      deltas_(static_cast<std::size_t>(width + 2) * static_cast<std::size_t>(height)) {
  assert(width >= 0 && height >= 0);
}

void ExactArea::add_edge(glm::vec2 from, glm::vec2 to) {
  double x0 = from.x, y0 = from.y, x1 = to.x, y1 = to.y;
  if (!std::isfinite(x0 + y0 + x1 + y1) || y0 == y1) return;
  // Above and below the box an edge covers nothing in it.
  const auto x_at = [=](double y) { return x0 + (x1 - x0) * ((y - y0) / (y1 - y0)); };
  const double top = std::clamp(y0, 0.0, static_cast<double>(height_));
  const double bottom = std::clamp(y1, 0.0, static_cast<double>(height_));
  if (top == bottom) return;
  const double left = top == y0 ? x0 : x_at(top), right = bottom == y1 ? x1 : x_at(bottom);
  // Left of the box it covers whole rows, as an edge along x = 0 does; right of it, none, as an
  // edge along x = width. So it is cut at both sides and the outer parts are moved there.
  const double w = width_;
  std::array<double, 4> cuts{0, 0, 0, 1};
  int count = 1;
  if (left != right) {
    std::array<double, 2> sides{(0 - left) / (right - left), (w - left) / (right - left)};
    if (sides[0] > sides[1]) std::swap(sides[0], sides[1]);
    for (const double t : sides) {
      if (t > 0 && t < 1) cuts[static_cast<std::size_t>(count++)] = t;
    }
  }
  cuts[static_cast<std::size_t>(count)] = 1;
  const auto x_of = [=](double t) { return std::clamp(left + (right - left) * t, 0.0, w); };
  const auto y_of = [=](double t) { return t == 1 ? bottom : top + (bottom - top) * t; };
  for (int i = 0; i < count; ++i) {
    const double a = cuts[static_cast<std::size_t>(i)], b = cuts[static_cast<std::size_t>(i + 1)];
    add_inside(x_of(a), y_of(a), x_of(b), y_of(b));
  }
}

void ExactArea::add_inside(double x0, double y0, double x1, double y1) {
  const double direction = y0 < y1 ? 1 : -1;
  if (y0 > y1) {
    std::swap(x0, x1);
    std::swap(y0, y1);
  }
  if (y0 == y1) return;
  const double slope = (x1 - x0) / (y1 - y0);
  const double low = std::min(x0, x1), high = std::max(x0, x1);
  double x = x0;
  const int last = std::min(height_ - 1, static_cast<int>(std::ceil(y1)) - 1);
  for (int y = static_cast<int>(y0); y <= last; ++y) {
    const double begin = std::max(y0, static_cast<double>(y));
    const double end = std::min(y1, static_cast<double>(y) + 1);
    const double next = end == y1 ? x1 : std::clamp(x0 + slope * (end - y0), low, high);
    float* row =
        deltas_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 2);
    add_in_row(std::min(x, next), std::max(x, next), direction * (end - begin), row);
    x = next;
  }
}

// An edge within one row, from x0 to x1 >= x0 over the height |dy|: pixel i gains the part of dy
// that is covered to the right of the edge, as the difference to the pixel before.
void ExactArea::add_in_row(double x0, double x1, double dy, float* row) {
  const int first = static_cast<int>(x0);
  const auto add = [row](int cell, double area) { row[cell] += static_cast<float>(area); };
  if (x1 <= first + 1) {
    const double mean = (x0 + x1) / 2 - first;
    add(first, dy * (1 - mean));
    add(first + 1, dy * mean);
    return;
  }
  // Over several pixels, the covered part of dy grows as a square, then in line, then as a square.
  const double per_pixel = dy / (x1 - x0);
  const auto sum_to = [=](double x) {  // the integral of what is covered, from x0 to x
    const double run = std::min(x, x1) - x0;
    return per_pixel * run * run / 2 + (x > x1 ? dy * (x - x1) : 0);
  };
  double before = 0, integral = 0;
  const int last = static_cast<int>(x1);
  for (int cell = first; cell <= last; ++cell) {
    const double next = sum_to(cell + 1);
    add(cell, next - integral - before);
    before = next - integral;
    integral = next;
  }
  add(last + 1, dy - before);
}

void ExactArea::take_row(int y, FillRule rule, std::span<float> coverage) {
  float* row = deltas_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 2);
  float winding = 0;
  for (std::size_t x = 0; x < coverage.size(); ++x) {
    winding += row[x];
    coverage[x] = covered(winding, rule);
  }
  std::fill(row, row + width_ + 2, 0.0f);
}

}  // namespace kinescope
