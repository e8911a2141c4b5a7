#include "raster/fill/scanline_fill.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr int kOne = 256, kHalf = kOne / 2;

/// The row (or column) of the first centre that is not before v, 1/256 pixel.
int first_centre(std::int32_t v) { return (v - kHalf + kOne - 1) >> 8; }

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  const std::int64_t q = a / b;
  return q - (a % b < 0);
}

void check(glm::dvec2 p) {
  constexpr double kMost = ScanlineFill::kLargestCoordinate;
  if (std::abs(p.x) <= kMost && std::abs(p.y) <= kMost) return;
  throw_bad_input(fmt::format("point ({}, {}) lies beyond {}", p.x, p.y, kMost));
}

std::int32_t snapped(double v) { return static_cast<std::int32_t>(std::floor(v * kOne + 0.5)); }

// Columns become positive, so that keys sort as numbers.
std::uint64_t key(int column, std::uint64_t place) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(column + (1 << 23))) << 32 | place;
}

}  // namespace

ScanlineFill::ScanlineFill(const PixelRect& window, FillRule rule) : window_(window), rule_(rule) {
  check({window.x0, window.y0});
  check({window.x1, window.y1});
}

void ScanlineFill::add_edge(glm::dvec2 from, glm::dvec2 to) {
  if (!std::isfinite(from.x + from.y + to.x + to.y)) return;
  check(from);
  check(to);
  Edge edge{snapped(from.x), snapped(from.y), snapped(to.x), snapped(to.y), 0, 1};
  if (edge.y1 < edge.y0) {
    edge = {edge.x1, edge.y1, edge.x0, edge.y0, 0, -1};
  }
  edge.row = std::max(first_centre(edge.y0), window_.y0);
  edges_.push_back(edge);
}

void ScanlineFill::add(const Polygon& polygon) {
  for (const Contour& contour : polygon) {
    contour_edges(contour, [this](glm::dvec2 a, glm::dvec2 b) { add_edge(a, b); });
  }
}

// Edges sorted by their first rows; those that cross none are left out.
void ScanlineFill::begin() {
  const auto rows = static_cast<std::size_t>(std::max(window_.y1 - window_.y0, 0));
  std::vector<std::uint32_t> starts(rows + 1);
  const auto crosses = [&](const Edge& e) {
    return e.row < std::min(first_centre(e.y1), window_.y1);
  };
  for (const Edge& e : edges_) {
    if (crosses(e)) ++starts[static_cast<std::size_t>(e.row - window_.y0) + 1];
  }
  for (std::size_t r = 0; r < rows; ++r) starts[r + 1] += starts[r];
  by_row_.resize(starts[rows]);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    if (crosses(edges_[i])) {
      by_row_[starts[static_cast<std::size_t>(edges_[i].row - window_.y0)]++] = i;
    }
  }
  begun_ = true;
}

void ScanlineFill::activate(std::uint32_t index) {
  const Edge& e = edges_[index];
  const std::int64_t dx = e.x1 - e.x0, dy = e.y1 - e.y0;
  ActiveEdge a;
  a.direction = e.direction;
  a.y_end = std::min(first_centre(e.y1), window_.y1);
  a.edge = index;
  // The crossing is x0 + (centre - y0) dx / dy; the column that of the first centre not before it.
  a.denominator = kOne * dy;
  const std::int64_t crossing =
      (std::int64_t{e.x0} - kHalf) * dy + (std::int64_t{y_} * kOne + kHalf - e.y0) * dx;
  const std::int64_t column = -floor_div(-crossing, a.denominator);
  a.column = static_cast<int>(column);
  a.remainder = column * a.denominator - crossing;
  const std::int64_t step = floor_div(dx, dy);
  a.step = static_cast<int>(step);
  a.step_rest = kOne * (dx - step * dy);
  active_.push_back(a);
}

// One row down: edges that end are replaced by the last, the others move aside.
void ScanlineFill::advance() {
  for (std::size_t i = 0; i < active_.size();) {
    ActiveEdge& a = active_[i];
    if (a.y_end <= y_) {
      a = active_.back();
      active_.pop_back();
      continue;
    }
    a.column += a.step;
    a.remainder -= a.step_rest;
    if (a.remainder < 0) {
      a.remainder += a.denominator;
      ++a.column;
    }
    ++i;
  }
}

void ScanlineFill::sort() {
  order_.resize(active_.size());
  for (std::size_t i = 0; i < active_.size(); ++i) order_[i] = key(active_[i].column, i);
  constexpr std::size_t kMany = 256;  // from where on counting digits costs less than comparing
  if (order_.size() < kMany) {
    std::sort(order_.begin(), order_.end());
  } else {
    sort_by_digits();
  }
}

// Columns within the limits and a step beyond have 24 bits: three digits of 8, the lowest first.
void ScanlineFill::sort_by_digits() {
  sorted_.resize(order_.size());
  for (int shift = 32; shift < 32 + 24; shift += 8) {
    const auto digit = [shift](std::uint64_t k) {
      return static_cast<std::size_t>(k >> shift & 255);
    };
    std::array<std::uint32_t, 257> starts{};
    for (const std::uint64_t k : order_) ++starts[digit(k) + 1];
    for (std::size_t d = 0; d < 256; ++d) starts[d + 1] += starts[d];
    for (const std::uint64_t k : order_) sorted_[starts[digit(k)]++] = k;
    order_.swap(sorted_);
  }
}

void ScanlineFill::find_spans() {
  spans_.clear();
  int winding = 0, begin = 0;
  bool inside = false;
  for (const std::uint64_t k : order_) {
    const ActiveEdge& a = active_[static_cast<std::uint32_t>(k)];
    winding += rule_ == FillRule::kEvenOdd ? 1 : a.direction;
    const bool now = rule_ == FillRule::kEvenOdd ? winding % 2 != 0 : winding != 0;
    if (now == inside) continue;
    const int x = std::clamp(a.column, window_.x0, window_.x1);
    inside = now;
    if (inside && !spans_.empty() && spans_.back().x_end == x) {  // goes on from the last
      begin = spans_.back().x_begin;
      spans_.pop_back();
    } else if (inside) {
      begin = x;
    } else if (begin < x) {
      spans_.push_back({y_, begin, x});
    }
  }
}

bool ScanlineFill::next() {
  if (!begun_) {
    begin();
    y_ = window_.y0 - 1;
  }
  ++y_;
  advance();
  const auto row_of = [this] { return edges_[by_row_[next_edge_]].row; };
  const bool waits = next_edge_ < by_row_.size();
  if (active_.empty()) {
    if (!waits) {
      order_.clear();
      spans_.clear();
      return false;
    }
    y_ = row_of();
  }
  for (; next_edge_ < by_row_.size() && row_of() == y_; ++next_edge_) activate(by_row_[next_edge_]);
  sort();
  find_spans();
  return true;
}

}  // namespace kinescope
