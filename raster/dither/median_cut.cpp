#include "raster/dither/median_cut.h"

#include <fmt/format.h>

#include <algorithm>

#include "raster/base/error.h"

namespace kinescope {
namespace {

std::size_t cell_at(int r, int g, int b) { return static_cast<std::size_t>((r * 32 + g) * 32 + b); }

}  // namespace

MedianCut::MedianCut(const Image<Srgb8>& image, int entries) : cells_(32 * 32 * 32) {
  if (entries < 1 || entries > 256) {
    throw Error(ErrorKind::kUsage, fmt::format("a palette has 1 to 256 entries, not {}", entries));
  }
  entries_ = static_cast<std::size_t>(entries);
  for (const Srgb8 p : image.pixels()) {
    Cell& cell = cells_[cell_at(p.r >> 3, p.g >> 3, p.b >> 3)];
    ++cell.pixels;
    cell.sums[0] += p.r;
    cell.sums[1] += p.g;
    cell.sums[2] += p.b;
  }
  if (image.empty()) return;
  boxes_.push_back({});
  shrink(boxes_.back());
}

template <typename Sink>
void MedianCut::for_each_cell(const Box& box, Sink&& sink) const {
  for (int r = box.low[0]; r <= box.high[0]; ++r) {
    for (int g = box.low[1]; g <= box.high[1]; ++g) {
      for (int b = box.low[2]; b <= box.high[2]; ++b) {
        const Cell& cell = cells_[cell_at(r, g, b)];
        if (cell.pixels) sink(std::array<int, 3>{r, g, b}, cell);
      }
    }
  }
}

void MedianCut::shrink(Box& box) const {
  Box tight{{31, 31, 31}, {0, 0, 0}, 0};
  for_each_cell(box, [&](const std::array<int, 3>& at, const Cell& cell) {
    for (std::size_t c = 0; c < 3; ++c) {
      tight.low[c] = std::min(tight.low[c], at[c]);
      tight.high[c] = std::max(tight.high[c], at[c]);
    }
    tight.pixels += cell.pixels;
  });
  box = tight;
}

bool MedianCut::next() {
  if (boxes_.size() >= entries_) return false;
  // The longest side of all boxes, of equals the one with the most pixels.
  std::size_t chosen = 0, axis = 0;
  int longest = 0;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int length = boxes_[i].high[c] - boxes_[i].low[c];
      if (length < longest ||
          (length == longest && (longest == 0 || boxes_[i].pixels <= boxes_[chosen].pixels))) {
        continue;
      }
      chosen = i;
      axis = c;
      longest = length;
    }
  }
  if (longest == 0) return false;
  std::array<std::int64_t, 32> slices{};
  for_each_cell(boxes_[chosen], [&](const std::array<int, 3>& at, const Cell& cell) {
    slices[static_cast<std::size_t>(at[axis])] += cell.pixels;
  });
  Box& low = boxes_[chosen];
  int cut = low.low[axis];
  std::int64_t below = slices[static_cast<std::size_t>(cut)];
  while (cut + 1 < low.high[axis] && 2 * below < low.pixels) {
    below += slices[static_cast<std::size_t>(++cut)];
  }
  Box high = low;
  low.high[axis] = cut;
  high.low[axis] = cut + 1;
  shrink(low);
  shrink(high);
  boxes_.push_back(high);
  return true;
}

Palette MedianCut::palette() const {
  Palette palette;
  for (const Box& box : boxes_) {
    std::array<std::int64_t, 3> sums{};
    for_each_cell(box, [&](const std::array<int, 3>&, const Cell& cell) {
      for (std::size_t c = 0; c < 3; ++c) sums[c] += cell.sums[c];
    });
    const auto mean = [&](std::size_t c) {
      return static_cast<std::uint8_t>((sums[c] + box.pixels / 2) / box.pixels);
    };
    palette.push_back({mean(0), mean(1), mean(2), 255});
  }
  return palette;
}

Palette median_cut(const Image<Srgb8>& image, int entries) {
  MedianCut cut(image, entries);
  while (cut.next()) {
  }
  return cut.palette();
}

}  // namespace kinescope
