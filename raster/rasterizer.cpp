#include "raster/rasterizer.h"

#include <algorithm>
#include <bit>
#include <new>
#include <string>
#include <vector>

#include "raster/base/error.h"
#include "raster/binning.h"
#include "raster/block_batches.h"
#include "raster/fragment_batches.h"
#include "raster/kernels/bin_triangles.h"
#include "raster/kernels/cull.h"
#include "raster/kernels/gather.h"
#include "raster/kernels/large_triangles.h"
#include "raster/kernels/medium_triangles.h"
#include "raster/kernels/pixel_triangles.h"
#include "raster/kernels/small_triangles.h"
#include "raster/ordered/ordered_bins.h"
#include "raster/ordered/ordered_tile.h"
#include "raster/resolve.h"
#include "raster/scissor.h"
#include "raster/tile.h"
#include "raster/visibility_hash.h"
#include "raster/visible_fragments.h"

namespace kinescope {
namespace {

/// What one worker owns for the whole frame. Cache lines are not shared between workers.
struct alignas(64) WorkerState {
  CulledTriangles culled;
  Bins bins;
  OrderedBins ordered_bins;
  TileBuffer tile;
  FragmentBuffer buffer;
  std::vector<const TriangleRecord*> records;  ///< of the tile
  VisibleFragments visible;
  FragmentShader shader;
  BlockShader block_shader;
  OrderedTile ordered;
  RasterStats stats;
};

int checked_tile_side(int side, int chosen) {
  if (side == 0) return chosen;
  if (side < 8 || side > TileGrid::kMaxTile || side % 8 != 0) {
    throw Error(ErrorKind::kUsage,
                "a tile's sides are multiples of 8 from 8 to 64, not " + std::to_string(side));
  }
  return side;
}

/// Depth and triangle of a tile's samples take 16 to 64 KB: most blocks are known by a triangle
/// alone or drawn at once, so that a first-level cache need not hold them all. Colours that are
/// blended lie beside them, 16 bytes a sample.
int chosen_tile_width(int samples, bool has_order) {
  return samples == 8 || (samples == 4 && has_order) ? 32 : 64;
}

/// Of a call's triangles: whole vectors of them, and enough ranges for all workers, since a few
/// large triangles may touch every tile.
std::uint64_t range_size(std::uint64_t triangles) {
  constexpr std::uint64_t kRanges = 16, kVector = 8;
  const std::uint64_t share = (triangles / kRanges + kVector - 1) / kVector * kVector;
  return std::clamp<std::uint64_t>(share, kVector, TriangleRange::kMaxCount);
}

}  // namespace

struct Rasterizer::Frame {
  Frame(Workers& w, RasterizerOptions o)
      : workers(w), options(o), states(static_cast<std::size_t>(w.count())) {}

  void begin(RenderTarget& target, std::span<const DrawCall> calls);
  void bin_range(const TriangleRange& range, WorkerState& state) const;
  bool begin_ordered(int tile, WorkerState& state) const;
  void draw_tile(int tile, RenderTarget& target, bool want_hash, WorkerState& state) const;

  Workers& workers;
  RasterizerOptions options;
  std::vector<WorkerState> states;
  TileGrid grid;
  std::span<const SampleOffset> pattern;
  FrameCalls calls;
  std::vector<DrawPhase> phases;  ///< of the calls
  bool has_order = false;         ///< whether any phase but the first has calls
  std::vector<TriangleRange> ranges;
};

void Rasterizer::Frame::begin(RenderTarget& target, std::span<const DrawCall> draw_calls) {
  pattern = sample_pattern(target.samples);
  phases = phases_of(draw_calls);
  has_order = std::any_of(phases.begin(), phases.end(),
                          [](DrawPhase phase) { return phase != DrawPhase::kVisibility; });
  grid =
      TileGrid(target.width, target.height,
               checked_tile_side(options.tile_width, chosen_tile_width(target.samples, has_order)),
               checked_tile_side(options.tile_height, 32));
  if (target.keep_depth &&
      (target.depth.width() != target.width || target.depth.height() != target.height)) {
    target.depth = Image<float>(target.width, target.height);
  }
  for (WorkerState& state : states) {
    state.bins.clear(grid.count());
    state.ordered_bins.clear(has_order ? grid.count() : 0);
    state.stats = {};
  }
  calls.calls = draw_calls;
  calls.first_id.clear();
  ranges.clear();
  std::uint64_t id = 0;
  for (std::uint32_t call = 0; call < draw_calls.size(); ++call) {
    calls.first_id.push_back(static_cast<std::uint32_t>(id));
    const std::uint64_t count = draw_calls[call].indices.size() / 3;
    id += count;
    if (id >= TileBuffer::kNothing) {
      throw Error(ErrorKind::kBadInput, "more than 4294967294 triangles in one frame");
    }
    const std::uint64_t most = range_size(count);
    for (std::uint64_t first = 0; first < count; first += most) {
      const std::uint64_t size = std::min(count - first, most);
      ranges.push_back({call, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(size)});
    }
  }
  calls.first_id.push_back(static_cast<std::uint32_t>(id));
}

void Rasterizer::Frame::bin_range(const TriangleRange& range, WorkerState& state) const {
  const DrawCall& call = calls.calls[range.call];
  const std::uint32_t first_id = calls.first_id[range.call];
  const PixelRect clip = clip_of(call, grid);
  if (clip.empty()) return;
  CulledTriangles& culled = state.culled;
  const DrawPhase phase = phases[range.call];
  const bool finish_pixels = phase == DrawPhase::kVisibility && !call.scissor;
  cull_triangles(call, range.first, range.count, pattern, grid, finish_pixels, culled);
  if (phase != DrawPhase::kVisibility) {
    OrderedBins& bins = state.ordered_bins;
    state.stats.drawn +=
        bin_in_order(culled, call, first_id, clip, pattern, grid, bins.of(phase), bins.pool);
    return;
  }
  if (call.scissor) apply_scissor(clip, pattern, culled);
  bin_pixels(culled.pixels, first_id, grid, state.bins);
  const SampleLimits limits = sample_limits(pattern);
  bin_small_triangles(culled.small, first_id, limits, grid, state.bins);
  bin_medium_triangles(culled.medium, first_id, limits, grid, state.bins);
  state.stats.drawn +=
      static_cast<std::uint64_t>(culled.pixels.size + culled.small.size + culled.medium.size);
  SnappedTriangle triangle;
  for (int i = 0; i < culled.large_size; ++i) {
    const std::uint32_t index = culled.large_triangle[static_cast<std::size_t>(i)];
    if (!set_up_triangle(call, index, triangle)) continue;
    if (bin_triangle(triangle, first_id + index, pattern, clip, grid, state.bins.records,
                     state.bins.record_pool)) {
      ++state.stats.drawn;
    }
  }
}

/// Whether a tile has anything to blend.
bool Rasterizer::Frame::begin_ordered(int tile, WorkerState& state) const {
  if (!has_order) return false;
  state.ordered.begin();
  for (const WorkerState& from : states) state.ordered.add(from.ordered_bins, tile);
  return !state.ordered.empty();
}

void Rasterizer::Frame::draw_tile(int tile, RenderTarget& target, bool want_hash,
                                  WorkerState& state) const {
  state.tile.begin(grid, tile, target.samples);
  const auto at = static_cast<std::size_t>(tile);
  state.records.clear();
  for (const WorkerState& from : states) {
    for (const RecordChunk* c = from.bins.records[at].first; c != nullptr; c = c->next) {
      for (int i = 0; i < c->size; ++i) {
        state.records.push_back(&c->records[static_cast<std::size_t>(i)]);
      }
    }
  }
  std::sort(state.records.begin(), state.records.end(),
            [](const auto* a, const auto* b) { return a->nearest < b->nearest; });
  draw_large_triangles(state.records, pattern, state.tile);
  for (const WorkerState& from : states) {
    draw_medium_triangles(from.bins.medium[at], pattern, state.tile);
    draw_pixels(from.bins.pixels[at], pattern, state.tile);
    draw_small_triangles(from.bins.small[at], false, pattern, state.tile, state.buffer);
    draw_small_triangles(from.bins.small_across[at], true, pattern, state.tile, state.buffer);
  }
  const bool is_ordered = begin_ordered(tile, state);
  if (is_ordered || want_hash || target.keep_depth) store_all_blocks(pattern, state.tile);
  if (is_ordered) state.ordered.begin_colours(target.clear, state.tile);
  const int block_count = state.tile.block_columns * state.tile.block_rows;
  std::uint64_t blocks = ~std::uint64_t{0} >> (TileBuffer::kMaxBlocks - block_count);
  if (!is_ordered) {
    const std::uint64_t left = state.block_shader.shade(calls, state.tile, target);
    state.stats.fragments +=
        static_cast<std::uint64_t>(std::popcount(blocks & ~left) * TileBuffer::kBlockPixels);
    blocks = left;
  }
  // A few blocks at a time, so that fragments and colours stay in a first-level cache.
  while (blocks != 0) {
    blocks = gather_visible(state.tile, blocks, state.visible);
    const auto colours = state.shader.shade(calls, state.visible, target.clear);
    resolve_blocks(state.tile, state.visible, colours, target);
    if (is_ordered) state.ordered.take(state.visible, colours, state.tile);
    state.stats.fragments += static_cast<std::uint64_t>(state.visible.size);
  }
  if (is_ordered) {
    state.stats.fragments += state.ordered.draw(calls, pattern, target.clear, state.tile);
    state.ordered.resolve(state.tile, target);
  }
  if (want_hash) state.stats.visibility_hash += tile_hash(state.tile, target.width);
  if (target.keep_depth) keep_depth(state.tile, target.depth);
}

Rasterizer::Rasterizer(Workers& workers, RasterizerOptions options)
    : frame_(std::make_unique<Frame>(workers, options)) {}

Rasterizer::~Rasterizer() = default;

RasterStats Rasterizer::draw(RenderTarget& target, std::span<const DrawCall> calls,
                             bool want_visibility_hash) {
  Frame& frame = *frame_;
  try {
    frame.begin(target, calls);
    frame.workers.run(static_cast<int>(frame.ranges.size()), [&](int task, int worker) {
      frame.bin_range(frame.ranges[static_cast<std::size_t>(task)],
                      frame.states[static_cast<std::size_t>(worker)]);
    });
    frame.workers.run(frame.grid.count(), [&](int tile, int worker) {
      frame.draw_tile(tile, target, want_visibility_hash,
                      frame.states[static_cast<std::size_t>(worker)]);
    });
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::kBadInput, "no memory to draw this frame; fewer samples need less");
  }
  RasterStats stats;
  stats.triangles = frame.calls.first_id.back();
  for (const auto& state : frame.states) {
    stats.drawn += state.stats.drawn;
    stats.fragments += state.stats.fragments;
    stats.visibility_hash += state.stats.visibility_hash;
  }
  return stats;
}

}  // namespace kinescope
