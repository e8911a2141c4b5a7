#include "raster/ordered/ordered_tile.h"

#include <algorithm>
#include <limits>
#include <new>

namespace kinescope {
namespace {

/// So many fragments are shaded at a time: they stay within a second-level cache.
constexpr int kAtATime = 1024;
/// Samples whose colours stay within a first-level cache, layer after layer.
constexpr int kBandSamples = 512;
/// About so many fragments are sorted by depth at a time, for the second-level cache.
constexpr int kFewByDepth = 4096;
/// More fragments of one tile than this are sorted by depth in parts of the tile, one after
/// another.
constexpr int kMostByDepth = 1 << 15;
/// Of the smallest part of a tile: more would need tens of gigabytes.
constexpr int kMostAtAll = 1 << 29;
/// Behind everything: what is stored where no depth was written.
constexpr float kBeyond = std::numeric_limits<float>::infinity();

int area(const PixelRect& r) { return (r.x1 - r.x0) * (r.y1 - r.y0); }

/// Two parts of a rectangle: of rows, or of columns of whole vectors. False if it is too small.
bool halve(const PixelRect& r, PixelRect& first, PixelRect& second) {
  first = second = r;
  if (r.y1 - r.y0 > 1) {
    first.y1 = second.y0 = (r.y0 + r.y1) / 2;
    return true;
  }
  const int middle = (r.x0 + (r.x1 - r.x0 + 1) / 2 + 7) & -8;
  first.x1 = second.x0 = middle;
  return middle < r.x1;
}

}  // namespace

void OrderedTile::begin() {
  submitted_lists_.clear();
  by_depth_lists_.clear();
}

void OrderedTile::add(const OrderedBins& bins, int tile) {
  const auto at = static_cast<std::size_t>(tile);
  if (bins.submitted[at].first != nullptr) submitted_lists_.push_back(&bins.submitted[at]);
  if (bins.by_depth[at].first != nullptr) by_depth_lists_.push_back(&bins.by_depth[at]);
}

void OrderedTile::begin_colours(const LinearRgba& clear, const TileBuffer& tile) {
  const auto pixels = static_cast<std::size_t>(tile.pixels);
  colours_.samples.assign(pixels * static_cast<std::size_t>(tile.samples), clear);
  colours_.touched.assign(pixels, 0);
}

/// Gives each sample its fragment's colour.
void OrderedTile::take(const VisibleFragments& visible, std::span<const LinearRgba> colours,
                       const TileBuffer& tile) {
  const auto samples = static_cast<std::size_t>(tile.samples);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const int x = static_cast<int>(visible.xy[i] & 0xffff) - tile.rect.x0;
    const int y = static_cast<int>(visible.xy[i] >> 16) - tile.rect.y0;
    const std::size_t first = static_cast<std::size_t>(y * tile.stride + x) * samples;
    for (std::size_t s = first; s < first + samples; ++s) {
      if (tile.id[s] == visible.id[i]) colours_.samples[s] = colours[i];
    }
  }
}

std::uint64_t OrderedTile::draw(const FrameCalls& frame, std::span<const SampleOffset> pattern,
                                const LinearRgba& clear, TileBuffer& tile) {
  shaded_count_ = 0;
  const std::size_t samples = tile.depth.size();
  for (std::size_t i = 0; i < samples; ++i) {
    if (tile.id[i] == TileBuffer::kNothing) tile.depth[i] = kBeyond;
  }
  if (!submitted_lists_.empty()) {
    records_.clear();
    merge_in_order(submitted_lists_, records_);
    draw_in_order(frame, pattern, clear, tile);
  }
  if (!by_depth_lists_.empty()) {
    records_.clear();
    merge_in_order(by_depth_lists_, records_);
    if (lie_apart(frame, tile)) {
      records_.swap(far_first_);
      draw_in_order(frame, pattern, clear, tile);
    } else {
      draw_by_depth(frame, pattern, clear, tile);
    }
  }
  for (std::size_t i = 0; i < samples; ++i) tile.depth[i] = std::min(tile.depth[i], 1.0f);
  return shaded_count_;
}

template <typename Each>
void OrderedTile::for_each_call(const FrameCalls& frame, Records records, const Each& each) {
  while (!records.empty()) {
    const int call = frame.call_of(records[0]->id);
    const std::uint32_t first = frame.first_id[static_cast<std::size_t>(call)];
    const std::uint32_t end = frame.first_id[static_cast<std::size_t>(call) + 1];
    std::size_t count = 1;
    while (count < records.size() && records[count]->id >= first && records[count]->id < end) {
      ++count;
    }
    each(call, records.first(count));
    records = records.subspan(count);
  }
}

/// Draws the records in their order.
void OrderedTile::draw_in_order(const FrameCalls& frame, std::span<const SampleOffset> pattern,
                                const LinearRgba& clear, TileBuffer& tile) {
  fragments_.reserve(kAtATime + area(tile.rect), 0);
  shaded_.resize(std::max<std::size_t>(shaded_.size(), 2 * Batch::kMaxSize));
  const int least_area = std::max(kBandSamples / tile.samples, tile.stride);
  const bool are_large = covered_area(tile) >= least_area * std::ssize(records_);
  set_bands(tile, are_large ? least_area / tile.stride : TileGrid::kMaxTile);
  for (const PixelRect& band : bands_) {
    for_each_call(frame, records_, [&](int index, Records records) {
      const DrawCall& call = frame.calls[static_cast<std::size_t>(index)];
      const bool write = call.depth_write && call.order == BlendOrder::kSubmitted;
      while (!records.empty()) {
        fragments_.size = 0;
        records = records.subspan(draw_ordered_records(records, {call.depth_test, write, false},
                                                       band, pattern, kAtATime, tile, fragments_));
        blend_batches(frame, index, clear, tile);
      }
    });
  }
}

/// Shades and blends a batch at a time, while its colours are in a first-level cache.
void OrderedTile::blend_batches(const FrameCalls& frame, int call, const LinearRgba& clear,
                                const TileBuffer& tile) {
  const BlendMode mode = frame.calls[static_cast<std::size_t>(call)].blend;
  for (int first = 0; first < fragments_.size; first += Batch::kMaxSize) {
    const int size = std::min(fragments_.size - first, Batch::kMaxSize);
    const FragmentView view = {fragments_.id.data() + first, fragments_.xy.data() + first, size};
    shader_.shade_call(frame, call, view, clear, shaded_.data());
    blend_in_order(mode, fragments_, first,
                   std::span(shaded_).first(static_cast<std::size_t>(size)), tile, colours_);
  }
  shaded_count_ += static_cast<std::uint64_t>(fragments_.size);
}

/// The boxes of the records, within the tile.
std::int64_t OrderedTile::covered_area(const TileBuffer& tile) const {
  std::int64_t covered = 0;
  for (const TriangleRecord* t : records_) {
    covered += area(intersection({t->x0, t->y0, t->x1, t->y1}, tile.rect));
  }
  return covered;
}

/// Cuts the tile into parts of so many rows.
void OrderedTile::set_bands(const TileBuffer& tile, int rows) {
  bands_.clear();
  for (int y = tile.rect.y0; y < tile.rect.y1; y += rows) {
    bands_.push_back({tile.rect.x0, y, tile.rect.x1, std::min(y + rows, tile.rect.y1)});
  }
}

/// Whether no two triangles share a depth, as sprites and layers that face the eye: then far_first_
/// is an order of triangles that is right at every sample (M. Newell et al., "A solution to the
/// hidden surface problem", 1972, whose first test this is).
bool OrderedTile::lie_apart(const FrameCalls& frame, const TileBuffer& tile) {
  far_first_ = records_;
  std::sort(far_first_.begin(), far_first_.end(), [](const auto* a, const auto* b) {
    return a->farthest != b->farthest ? a->farthest > b->farthest : a->id < b->id;
  });
  for (std::size_t i = 1; i < far_first_.size(); ++i) {
    const TriangleRecord& far = *far_first_[i - 1];
    const TriangleRecord& near = *far_first_[i];
    if (far.nearest < near.farthest || (far.nearest == near.farthest && far.id > near.id)) {
      return false;
    }
  }
  // Batches hold fragments of one call: where calls alternate, sorting fragments is cheaper.
  std::int64_t runs = 0;
  for_each_call(frame, far_first_, [&](int, Records) { ++runs; });
  return covered_area(tile) >= runs * Batch::kMaxSize / 2;
}

/// All fragments of a part of the tile. False if there are too many, and the part can be smaller.
bool OrderedTile::gather(const FrameCalls& frame, std::span<const SampleOffset> pattern,
                         const PixelRect& band, TileBuffer& tile) {
  fragments_.size = 0;
  modes_.clear();
  call_ends_.clear();
  PixelRect unused;
  const bool can_be_smaller = halve(band, unused, unused);
  int limit = kMostByDepth;
  bool fits = true;
  for_each_call(frame, records_, [&](int index, Records records) {
    const DrawCall& call = frame.calls[static_cast<std::size_t>(index)];
    while (fits && !records.empty()) {
      fragments_.reserve(limit + area(band), tile.samples);
      records = records.subspan(draw_ordered_records(records, {call.depth_test, false, true}, band,
                                                     pattern, limit, tile, fragments_));
      if (fragments_.size < limit) continue;
      if (limit >= kMostAtAll) throw std::bad_alloc();
      fits = !can_be_smaller;
      limit *= 2;
    }
    modes_.resize(static_cast<std::size_t>(fragments_.size), call.blend);
    call_ends_.push_back({index, fragments_.size});
  });
  return fits;
}

void OrderedTile::draw_by_depth(const FrameCalls& frame, std::span<const SampleOffset> pattern,
                                const LinearRgba& clear, TileBuffer& tile) {
  // About half of a triangle's box is covered.
  const int height = tile.rect.y1 - tile.rect.y0;
  const std::int64_t fragments = covered_area(tile) / 2 + 1;
  const std::int64_t rows = std::int64_t{kFewByDepth} * height / fragments;
  set_bands(tile, static_cast<int>(std::clamp<std::int64_t>(rows, 1, height)));
  while (!bands_.empty()) {
    const PixelRect band = bands_.back();
    bands_.pop_back();
    if (gather(frame, pattern, band, tile)) {
      blend_band(frame, band, clear, tile);
      continue;
    }
    PixelRect first, second;
    halve(band, first, second);
    bands_.insert(bands_.end(), {second, first});
  }
}

/// Shades and blends the fragments gathered.
void OrderedTile::blend_band(const FrameCalls& frame, const PixelRect& band,
                             const LinearRgba& clear, const TileBuffer& tile) {
  const auto size = static_cast<std::size_t>(fragments_.size);
  shaded_.resize(std::max(shaded_.size(), size + Batch::kMaxSize));
  int first = 0;
  for (const CallEnd& end : call_ends_) {
    const FragmentView view = {fragments_.id.data() + first, fragments_.xy.data() + first,
                               end.fragment - first};
    shader_.shade_call(frame, end.call, view, clear, shaded_.data() + first);
    first = end.fragment;
  }
  blend_by_depth(modes_, fragments_, std::span(shaded_).first(size), band, tile, order_, colours_);
  shaded_count_ += size;
}

}  // namespace kinescope
