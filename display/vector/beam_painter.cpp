#include "display/vector/beam_painter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "display/vector/stroke_law.h"

namespace kinescope {
namespace {

constexpr std::size_t kChunkStrokes = 4096;

std::size_t chunks_of(std::size_t strokes) { return (strokes + kChunkStrokes - 1) / kChunkStrokes; }

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

}  // namespace

/// Strokes that leave the surroundings are cut, in copies: single precision ends somewhere.
void BeamPainter::clip(std::span<const BeamStroke> strokes, std::span<const float> weights,
                       const TiledLight& light) {
  const auto width = static_cast<float>(light.width()), height = static_cast<float>(light.height());
  strokes_ = strokes;
  weights_ = weights;
  far_.clear();
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (!stays_near(strokes[i], width, height)) far_.push_back(static_cast<std::uint32_t>(i));
  }
  if (far_.empty()) return;
  clipped_.assign(strokes.begin(), strokes.end());
  clipped_weights_.assign(weights.begin(), weights.end());
  const auto planes = static_cast<std::size_t>(light.planes());
  for (const std::uint32_t i : far_) {
    BeamStroke& s = clipped_[i];
    const bool finite = std::isfinite(s.x0) && std::isfinite(s.y0) && std::isfinite(s.x1) &&
                        std::isfinite(s.y1) && std::isfinite(s.sigma);
    const double left = finite ? clip_stroke(s, width, height) : 0;
    if (!(left > 0)) s = {-1e4f, -1e4f, -1e4f, -1e4f, 1};  // where no tile is
    for (std::size_t p = 0; p < planes; ++p) {
      clipped_weights_[i * planes + p] *= static_cast<float>(left);
    }
  }
  strokes_ = clipped_;
  weights_ = clipped_weights_;
}

// A counting sort in two passes over chunks of strokes: a chunk's strokes have a place of their own
// in each tile, so that the order is kept whoever does the work.
void BeamPainter::sort(const TiledLight& light, Workers& workers) {
  const std::size_t chunks = chunks_of(strokes_.size());
  const auto tiles = static_cast<std::size_t>(light.tiles());
  const auto columns = static_cast<std::size_t>(light.columns());
  boxes_.resize(strokes_.size());
  starts_.assign(tiles * chunks + 1, 0);
  const auto for_chunk = [&](int chunk, const auto& visit) {
    const std::size_t begin = static_cast<std::size_t>(chunk) * kChunkStrokes;
    for (std::size_t i = begin; i < std::min(begin + kChunkStrokes, strokes_.size()); ++i) visit(i);
  };
  const auto for_tiles = [&](std::size_t stroke, const auto& visit) {
    const Tiles& box = boxes_[stroke];
    for (std::size_t y = box.top; y < box.bottom; ++y) {
      for (std::size_t x = box.left; x < box.right; ++x) visit(y * columns + x);
    }
  };
  const auto begin_tile = [](float v, int count) {
    return static_cast<std::uint16_t>(
        std::clamp(std::floor(v / kBeamTile), 0.0f, static_cast<float>(count)));
  };
  const auto end_tile = [](float v, int count) {
    return static_cast<std::uint16_t>(
        std::clamp(std::floor(v / kBeamTile) + 1, 0.0f, static_cast<float>(count)));
  };
  workers.run(static_cast<int>(chunks), [&](int chunk, int) {
    for_chunk(chunk, [&](std::size_t i) {
      const BeamStroke& s = strokes_[i];
      const float reach = reach_of(s);
      boxes_[i] = {begin_tile(std::min(s.x0, s.x1) - reach, light.columns()),
                   begin_tile(std::min(s.y0, s.y1) - reach, light.rows()),
                   end_tile(std::max(s.x0, s.x1) + reach, light.columns()),
                   end_tile(std::max(s.y0, s.y1) + reach, light.rows())};
      for_tiles(i, [&](std::size_t tile) {
        ++starts_[tile * chunks + static_cast<std::size_t>(chunk) + 1];
      });
    });
  });
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  order_.resize(starts_.back());
  workers.run(static_cast<int>(chunks), [&](int chunk, int) {
    std::vector<std::uint32_t> next(tiles);
    for (std::size_t tile = 0; tile < tiles; ++tile) {
      next[tile] = starts_[tile * chunks + static_cast<std::size_t>(chunk)];
    }
    for_chunk(chunk, [&](std::size_t i) {
      for_tiles(i, [&](std::size_t tile) { order_[next[tile]++] = static_cast<std::uint32_t>(i); });
    });
  });
}

void BeamPainter::draw(std::span<const BeamStroke> strokes, std::span<const float> weights,
                       TiledLight& light, Workers& workers) {
  assert(weights.size() == strokes.size() * static_cast<std::size_t>(light.planes()));
  if (strokes.empty() || light.tiles() == 0) return;
  clip(strokes, weights, light);
  sort(light, workers);
  const std::size_t chunks = chunks_of(strokes.size());
  workers.run(light.tiles(), [&](int tile, int) {
    const std::size_t begin = starts_[static_cast<std::size_t>(tile) * chunks];
    const std::size_t end = starts_[static_cast<std::size_t>(tile + 1) * chunks];
    if (begin == end) return;
    light.set_lit(tile, true);
    draw_strokes(strokes_, weights_.data(), {order_.data() + begin, end - begin}, light.tile(tile));
  });
}

}  // namespace kinescope
