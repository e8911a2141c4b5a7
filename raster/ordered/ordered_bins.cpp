#include "raster/ordered/ordered_bins.h"

#include <algorithm>
#include <limits>

#include "raster/binning.h"

namespace kinescope {
namespace {

constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();

/// Walks through a list of records.
struct Reader {
  const RecordChunk* chunk;
  int at = 0;

  std::uint32_t id() const {
    return chunk == nullptr ? kEnd : chunk->records[static_cast<std::size_t>(at)].id;
  }
  const TriangleRecord* take() {
    const TriangleRecord* const record = &chunk->records[static_cast<std::size_t>(at)];
    if (++at == chunk->size) *this = {chunk->next};
    return record;
  }
};

SnappedTriangle triangle_at(const CulledTriangles::Snapped& t, std::size_t i) {
  SnappedTriangle out;
  set_up_snapped({t.x[0][i], t.x[1][i], t.x[2][i]}, {t.y[0][i], t.y[1][i], t.y[2][i]},
                 {t.z[0][i], t.z[1][i], t.z[2][i]}, out);
  return out;
}

}  // namespace

std::vector<DrawPhase> phases_of(std::span<const DrawCall> calls) {
  std::vector<DrawPhase> phases;
  bool all_plain = true;
  for (const DrawCall& call : calls) {
    if (call.order == BlendOrder::kByDepth) {
      phases.push_back(DrawPhase::kByDepth);
      continue;
    }
    all_plain = all_plain && call.is_plain();
    phases.push_back(all_plain ? DrawPhase::kVisibility : DrawPhase::kSubmitted);
  }
  return phases;
}

// The sizes' lists, each in the order of submission, are merged.
std::uint64_t bin_in_order(const CulledTriangles& triangles, const DrawCall& call,
                           std::uint32_t first_id, const PixelRect& clip,
                           std::span<const SampleOffset> pattern, const TileGrid& grid,
                           OrderedBins::Tiles& tiles, ChunkPool<RecordChunk>& pool) {
  const CulledTriangles::Snapped& small = triangles.small;
  const CulledTriangles::Snapped& medium = triangles.medium;
  std::size_t s = 0, m = 0, l = 0;
  const auto head = [](const auto& numbers, std::size_t i, int size) {
    return i < static_cast<std::size_t>(size) ? numbers[i] : kEnd;
  };
  std::uint64_t drawn = 0;
  for (;;) {
    const std::uint32_t next_small = head(small.triangle, s, small.size);
    const std::uint32_t next_medium = head(medium.triangle, m, medium.size);
    const std::uint32_t next_large = head(triangles.large_triangle, l, triangles.large_size);
    const std::uint32_t index = std::min({next_small, next_medium, next_large});
    if (index == kEnd) return drawn;
    SnappedTriangle triangle;
    if (index == next_small) {
      triangle = triangle_at(small, s++);
    } else if (index == next_medium) {
      triangle = triangle_at(medium, m++);
    } else {
      ++l;
      if (!set_up_triangle(call, index, triangle)) continue;
    }
    if (bin_triangle(triangle, first_id + index, pattern, clip, grid, tiles, pool)) ++drawn;
  }
}

void merge_in_order(std::span<const ChunkList<RecordChunk>* const> lists,
                    std::vector<const TriangleRecord*>& out) {
  std::vector<Reader> readers;
  for (const auto* list : lists) {
    if (list->first != nullptr) readers.push_back({list->first});
  }
  // Ranges of many consecutive triangles lie in one list: each turn copies one.
  while (!readers.empty()) {
    std::size_t least = 0;
    std::uint32_t second = kEnd;
    for (std::size_t r = 1; r < readers.size(); ++r) {
      const std::uint32_t id = readers[r].id();
      second = std::min(second, std::max(id, readers[least].id()));
      if (id < readers[least].id()) least = r;
    }
    Reader& from = readers[least];
    while (from.id() < second) out.push_back(from.take());
    if (from.chunk == nullptr) readers.erase(readers.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

}  // namespace kinescope
