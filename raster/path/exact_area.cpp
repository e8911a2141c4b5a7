#include "raster/path/exact_area.h"

#include <bit>

namespace kinescope {
namespace {

constexpr double kUnit = ExactArea::kWhole;

/// The nearest whole number, for values within +-2^50: what is added leaves it in the low bits.
/// Without it a call of lrint() would be most of an edge's cost.
std::int64_t nearest(double value) {
  constexpr double kRound = 0x1.8p52;
  return std::bit_cast<std::int64_t>(value + kRound) - std::bit_cast<std::int64_t>(kRound);
}

std::int32_t whole(double area) { return static_cast<std::int32_t>(nearest(area)); }

void add(const ExactArea::Row& row, int cell, std::int32_t area) {
  row.cells[cell] += static_cast<std::uint32_t>(area);
}

void mark(const ExactArea::Row& row, int first, int last) {
  for (int block = first / ExactArea::kBlock; block <= last / ExactArea::kBlock; ++block) {
    row.marks[block / 64] |= std::uint64_t{1} << (block % 64);
  }
}

}  // namespace

// Rows are left empty by whoever takes them, so only growth needs zeros.
void ExactArea::reset(int width, int height) {
  assert(width >= 0 && height >= 0);
  width_ = width;
  height_ = height;
  row_blocks_ = static_cast<std::size_t>(width) / kBlock + 1;
  row_words_ = (row_blocks_ + 63) / 64;
  const std::size_t cells = row_blocks_ * kBlock * static_cast<std::size_t>(height);
  const std::size_t words = row_words_ * static_cast<std::size_t>(height);
  if (cells_.size() < cells) cells_.resize(cells);
  if (marks_.size() < words) marks_.resize(words);
}

ExactArea::Row ExactArea::row(int y) {
  const auto r = static_cast<std::size_t>(y);
  return {cells_.data() + r * row_blocks_ * kBlock, marks_.data() + r * row_words_, row_words_};
}

void ExactArea::add_edge(glm::dvec2 from, glm::dvec2 to) {
  if (!std::isfinite(from.x + from.y + to.x + to.y) || from.y == to.y) return;
  // Above and below the box an edge covers nothing in it; heights are whole from here on, so that
  // those of a closed contour add up to nothing in each row.
  const auto row_units = [this](double y) {
    return nearest(std::clamp(y, 0.0, static_cast<double>(height_)) * kUnit);
  };
  const std::int64_t begin = row_units(std::min(from.y, to.y));
  const std::int64_t end = row_units(std::max(from.y, to.y));
  // Right of the box it covers nothing either; left of it, whole rows.
  if (begin == end || std::min(from.x, to.x) >= width_) return;
  const double slope = (to.x - from.x) / (to.y - from.y);
  const double low = std::min(from.x, to.x), high = std::max(from.x, to.x);
  const auto x_at = [&](std::int64_t y) {
    return std::clamp(from.x + slope * (static_cast<double>(y) / kUnit - from.y), low, high);
  };
  const int direction = from.y < to.y ? 1 : -1;
  double x = x_at(begin);
  for (std::int64_t y = begin; y < end;) {
    const std::int64_t index = y / kWhole;
    const std::int64_t next = std::min<std::int64_t>(end, (index + 1) * kWhole);
    const double next_x = x_at(next);
    add_in_row(std::min(x, next_x), std::max(x, next_x),
               direction * static_cast<std::int32_t>(next - y), row(static_cast<int>(index)));
    x = next_x;
    y = next;
  }
}

// An edge within one row, from x0 to x1 >= x0, over a height with its direction as sign: a pixel
// gains the part of that height that lies right of the edge, as the difference to the pixel before.
void ExactArea::add_in_row(double x0, double x1, std::int32_t height, const Row& row) {
  if (x0 >= width_) return;
  if (x1 <= 0) {
    add(row, 0, height);
    return mark(row, 0, 0);
  }
  const int first = static_cast<int>(std::max(x0, 0.0));
  if (x0 >= 0 && x1 <= first + 1) {
    const std::int32_t here = whole(height * (first + 1 - 0.5 * (x0 + x1)));
    add(row, first, here);
    add(row, first + 1, height - here);
    return mark(row, first, first + 1);
  }
  // Over several pixels, what is covered grows as a square, then in line, then as a square.
  const double per_pixel = height / (x1 - x0);
  const int last = static_cast<int>(std::min<double>(x1, width_ - 1));
  std::int32_t before = 0;
  for (int cell = first; cell <= last; ++cell) {
    const double enters = std::max(x0 - cell, 0.0), leaves = std::min(x1 - cell, 1.0);
    // The mean of (x - x0) over the part crossed, then of x1 - x0 over the rest.
    const double crossed = 0.5 * (leaves - enters) * (leaves + enters - 2 * (x0 - cell));
    const std::int32_t here = whole(per_pixel * crossed + height * (1 - leaves));
    add(row, cell, here - before);
    before = here;
  }
  add(row, last + 1, height - before);
  mark(row, first, last + 1);
}

void ExactArea::take_row(int y, FillRule rule, std::span<float> coverage) {
  const Row taken = row(y);
  std::uint32_t winding = 0;
  for (std::size_t x = 0; x < coverage.size(); ++x) {
    winding += taken.cells[x];
    coverage[x] = static_cast<float>(covered(winding, rule)) / kWhole;
  }
  std::fill(taken.cells, taken.cells + row_blocks_ * kBlock, 0u);
  std::fill(taken.marks, taken.marks + row_words_, std::uint64_t{0});
}

}  // namespace kinescope
