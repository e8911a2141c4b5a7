#include "raster/path/line_painter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kinescope {
namespace {

constexpr int kBandRows = 64;
constexpr std::size_t kChunkLines = 4096;

std::size_t chunks_of(std::size_t lines) { return (lines + kChunkLines - 1) / kChunkLines; }

}  // namespace

// A counting sort in two passes over chunks of lines: a chunk's lines have a place of their own in
// each band, so that the order is kept whoever does the work.
void LinePainter::sort_into_bands(std::span<const InkedLine> lines, const Stroke& stroke,
                                  int height) {
  const std::size_t chunks = chunks_of(lines.size());
  const auto bands = static_cast<std::size_t>((height + kBandRows - 1) / kBandRows);
  bands_.resize(lines.size());
  starts_.assign(bands * chunks + 1, 0);
  const float reach = 0.75f * stroke.width_px + 1;  // a square cap's corner lies 0.71 widths off
  const auto for_chunk = [&](int chunk, const auto& visit) {
    const std::size_t begin = static_cast<std::size_t>(chunk) * kChunkLines;
    for (std::size_t i = begin; i < std::min(begin + kChunkLines, lines.size()); ++i) visit(i);
  };
  const auto cell = [&](std::size_t band, int chunk) -> std::uint32_t& {
    return starts_[band * chunks + static_cast<std::size_t>(chunk) + 1];
  };
  workers_.run(static_cast<int>(chunks), [&](int chunk, int) {
    for_chunk(chunk, [&](std::size_t i) {
      const Segment& s = lines[i].segment;
      const float top = std::min(s.from.y, s.to.y) - reach;
      const float bottom = std::max(s.from.y, s.to.y) + reach;
      bands_[i] = {0, 0};
      // Written so that what is not a number is left out.
      if (!(bottom > 0 && top < static_cast<float>(height))) return;
      const int first = std::max(static_cast<int>(std::max(top, 0.0f)) / kBandRows, 0);
      const float last_row = std::min(bottom, static_cast<float>(height - 1));
      const int last = static_cast<int>(last_row) / kBandRows + 1;
      bands_[i] = {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(last)};
      for (int band = first; band < last; ++band) ++cell(static_cast<std::size_t>(band), chunk);
    });
  });
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  order_.resize(starts_.back());
  workers_.run(static_cast<int>(chunks), [&](int chunk, int) {
    std::vector<std::uint32_t> next(bands);
    for (std::size_t band = 0; band < bands; ++band) {
      next[band] = starts_[band * chunks + static_cast<std::size_t>(chunk)];
    }
    for_chunk(chunk, [&](std::size_t i) {
      for (std::size_t band = bands_[i].first; band < bands_[i].last; ++band) {
        order_[next[band]++] = static_cast<std::uint32_t>(i);
      }
    });
  });
}

template <typename Pixel>
void LinePainter::draw_any(std::span<const InkedLine> lines, const Stroke& stroke, Mixing mixing,
                           Image<Pixel>& picture) {
  if (lines.empty() || picture.empty()) return;
  sort_into_bands(lines, stroke, picture.height());
  const std::size_t chunks = chunks_of(lines.size());
  const int bands = (picture.height() + kBandRows - 1) / kBandRows;
  workers_.run(bands, [&](int band, int) {
    const std::size_t begin = starts_[static_cast<std::size_t>(band) * chunks];
    const std::size_t end = starts_[static_cast<std::size_t>(band + 1) * chunks];
    const std::span<const std::uint32_t> order(order_.data() + begin, end - begin);
    const int top = band * kBandRows;
    draw_lines(lines, order, stroke, mixing, top, std::min(top + kBandRows, picture.height()),
               picture);
  });
}

void LinePainter::draw(std::span<const InkedLine> lines, const Stroke& stroke, Mixing mixing,
                       Image<Linear8>& picture) {
  draw_any(lines, stroke, mixing, picture);
}

void LinePainter::draw(std::span<const InkedLine> lines, const Stroke& stroke, Mixing mixing,
                       Image<LinearRgba>& picture) {
  draw_any(lines, stroke, mixing, picture);
}

}  // namespace kinescope
