#include "display/vector/beam_painter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "display/vector/stroke_law.h"

namespace kinescope {
namespace {

constexpr std::size_t kChunkStrokes = 4096;

float reach_of(const BeamStroke& s) {
  constexpr float kHalfPixel = 0.5f;
  const float sigma = stroke_law::drawn_sigma(s);
  return kSpotReach * std::sqrt(sigma * sigma + stroke_law::kPixelVariance) + kHalfPixel;
}

/// The pixels around a picture in which a stroke need not be clipped.
constexpr float kSurroundings = 256;

bool stays_near(const BeamStroke& s, float width, float height) {
  const auto near = [](float v, float size) {
    return v >= -kSurroundings && v <= size + kSurroundings;
  };
  return near(s.x0, width) && near(s.x1, width) && near(s.y0, height) && near(s.y1, height) &&
         s.sigma < kSurroundings / (2 * kSpotReach);
}

/// Liang and Barsky's: the share of the way within [low, high] on one axis.
void keep_between(double start, double way, double low, double high, double& from, double& to) {
  if (way == 0) {
    if (start < low || start > high) to = -1;
    return;
  }
  const double a = (low - start) / way, b = (high - start) / way;
  from = std::max(from, std::min(a, b));
  to = std::min(to, std::max(a, b));
}

/// Cuts a stroke to the picture and what its spot reaches. @return the share that is left
double clip_stroke(BeamStroke& s, float width, float height) {
  const double margin = 2.0 * static_cast<double>(reach_of(s)) + 8;
  const double x = s.x0, y = s.y0, dx = static_cast<double>(s.x1) - x,
               dy = static_cast<double>(s.y1) - y;
  double from = 0, to = 1;
  keep_between(x, dx, -margin, static_cast<double>(width) + margin, from, to);
  keep_between(y, dy, -margin, static_cast<double>(height) + margin, from, to);
  if (!(to >= from)) return 0;
  s.x0 = static_cast<float>(x + from * dx), s.y0 = static_cast<float>(y + from * dy);
  s.x1 = static_cast<float>(x + to * dx), s.y1 = static_cast<float>(y + to * dy);
  return dx == 0 && dy == 0 ? 1 : to - from;
}

/// Strokes that leave the surroundings are cut: single precision ends somewhere.
void keep_near(BeamMarks& marks, const TiledLight& light) {
  const auto width = static_cast<float>(light.width()), height = static_cast<float>(light.height());
  const auto planes = static_cast<std::size_t>(light.planes());
  for (std::size_t i = 0; i < marks.strokes.size(); ++i) {
    BeamStroke& s = marks.strokes[i];
    if (stays_near(s, width, height)) continue;
    const bool finite = std::isfinite(s.x0) && std::isfinite(s.y0) && std::isfinite(s.x1) &&
                        std::isfinite(s.y1) && std::isfinite(s.sigma);
    const double left = finite ? clip_stroke(s, width, height) : 0;
    if (!(left > 0)) s = {-1e4f, -1e4f, -1e4f, -1e4f, 1};  // where no tile is
    for (std::size_t p = 0; p < planes; ++p) {
      marks.stroke_weights[i * planes + p] *= static_cast<float>(left);
    }
  }
}

/// What a mark reaches, pixels; nothing of what is not finite.
struct Reach {
  float left, top, right, bottom;
};

Reach reach_of_stroke(const BeamStroke& s) {
  const float reach = reach_of(s);
  return {std::min(s.x0, s.x1) - reach, std::min(s.y0, s.y1) - reach, std::max(s.x0, s.x1) + reach,
          std::max(s.y0, s.y1) + reach};
}

Reach reach_of_spots(const BeamSpots& s) {
  float left = s.x[0], right = left, top = s.y[0], bottom = top, sigma = kLeastSigma, sum = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(s.count); ++i) {
    left = std::min(left, s.x[i]), right = std::max(right, s.x[i]);
    top = std::min(top, s.y[i]), bottom = std::max(bottom, s.y[i]);
    sigma = std::max(sigma, s.sigma[i]);
    sum += s.x[i] + s.y[i] + s.sigma[i];
  }
  const float reach = kSpotReach * sigma;
  return std::isfinite(sum) ? Reach{left - reach, top - reach, right + reach, bottom + reach}
                            : Reach{0, 0, -1e30f, -1e30f};
}

/// The tile that holds a place, of -1 before the first to `count` behind the last.
int tile_of(float v, int count) {
  const float at = (v + kBeamTile) * (1.0f / kBeamTile);
  return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(count + 1))) - 1;
}

}  // namespace

/// A counting sort by tile, the marks of each in their order.
void BeamPainter::sort(BeamMarks& marks, const TiledLight& light, Chunk& chunk) {
  keep_near(marks, light);
  const auto columns = static_cast<std::size_t>(light.columns());
  chunk.boxes.resize(marks.size());
  chunk.starts.assign(static_cast<std::size_t>(light.tiles()) + 2, 0);
  const auto for_tiles = [&](const Tiles& box, const auto& visit) {
    for (std::size_t y = box.top; y < box.bottom; ++y) {
      for (std::size_t x = box.left; x < box.right; ++x) visit(y * columns + x);
    }
  };
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Reach r = i < marks.strokes.size()
                        ? reach_of_stroke(marks.strokes[i])
                        : reach_of_spots(marks.spots[i - marks.strokes.size()]);
    chunk.boxes[i] = {
        static_cast<std::uint16_t>(std::max(0, tile_of(r.left, light.columns()))),
        static_cast<std::uint16_t>(std::max(0, tile_of(r.top, light.rows()))),
        static_cast<std::uint16_t>(
            std::min(tile_of(r.right, light.columns()) + 1, light.columns())),
        static_cast<std::uint16_t>(std::min(tile_of(r.bottom, light.rows()) + 1, light.rows()))};
    for_tiles(chunk.boxes[i], [&](std::size_t tile) { ++chunk.starts[tile + 2]; });
  }
  for (std::size_t i = 1; i < chunk.starts.size(); ++i) chunk.starts[i] += chunk.starts[i - 1];
  chunk.order.resize(chunk.starts.back());
  // Each tile's start becomes its end, which is the start of the next.
  for (std::size_t i = 0; i < marks.size(); ++i) {
    for_tiles(chunk.boxes[i], [&](std::size_t tile) {
      chunk.order[chunk.starts[tile + 1]++] = static_cast<std::uint32_t>(i);
    });
  }
}

void BeamPainter::draw(std::span<BeamMarks> chunks, TiledLight& light, Workers& workers) {
  assert(light.planes() <= kMostBeamPlanes);
  if (light.tiles() == 0) return;
  if (chunks_.size() < chunks.size()) chunks_.resize(chunks.size());
  workers.run(static_cast<int>(chunks.size()), [&](int number, int) {
    const auto i = static_cast<std::size_t>(number);
    sort(chunks[i], light, chunks_[i]);
  });
  const auto planes = static_cast<std::size_t>(light.planes());
  const auto order_of = [&](std::size_t chunk, int tile) {
    const Chunk& c = chunks_[chunk];
    const std::size_t begin = c.starts[static_cast<std::size_t>(tile)];
    return std::span(c.order).subspan(begin, c.starts[static_cast<std::size_t>(tile) + 1] - begin);
  };
  workers.run(light.tiles(), [&](int tile, int) {
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      if (i + 1 < chunks.size()) {
        const auto next = order_of(i + 1, tile);
        for (const auto mark : next.first(std::min(next.size(), kMarksAhead))) {
          prefetch_mark(chunks[i + 1], mark, planes);
        }
      }
      const auto order = order_of(i, tile);
      if (order.empty()) continue;
      light.set_lit(tile, true);
      draw_marks(chunks[i], order, light.tile(tile));
    }
  });
}

void BeamPainter::draw(std::span<const BeamStroke> strokes, std::span<const float> weights,
                       TiledLight& light, Workers& workers) {
  const auto planes = static_cast<std::size_t>(light.planes());
  assert(weights.size() == strokes.size() * planes);
  const std::size_t chunks = (strokes.size() + kChunkStrokes - 1) / kChunkStrokes;
  if (plain_.size() < chunks) plain_.resize(chunks);
  workers.run(static_cast<int>(chunks), [&](int number, int) {
    const std::size_t first = static_cast<std::size_t>(number) * kChunkStrokes;
    const std::size_t count = std::min(kChunkStrokes, strokes.size() - first);
    const auto some = strokes.subspan(first, count);
    const auto their_weights = weights.subspan(first * planes, count * planes);
    BeamMarks& marks = plain_[static_cast<std::size_t>(number)];
    marks.strokes.assign(some.begin(), some.end());
    marks.stroke_weights.assign(their_weights.begin(), their_weights.end());
  });
  draw(std::span(plain_).first(chunks), light, workers);
}

}  // namespace kinescope
