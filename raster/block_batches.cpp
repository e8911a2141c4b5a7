#include "raster/block_batches.h"

#include <algorithm>

#include "raster/resolve.h"

namespace kinescope {

std::uint64_t BlockShader::shade(const FrameCalls& frame, const TileBuffer& tile,
                                 RenderTarget& target) {
  std::uint64_t left = 0;
  blocks_.triangles = blocks_.ready = 0;  // of another frame, perhaps
  for (int block = 0; block < tile.block_columns * tile.block_rows; ++block) {
    const PixelRect rect = tile.block_rect(block);
    const bool within =
        rect.x1 - rect.x0 == TileBuffer::kBlock && rect.y1 - rect.y0 == TileBuffer::kBlock;
    if (!within || !find_owners(tile, block, owners_)) {
      left |= std::uint64_t{1} << block;
      continue;
    }
    if (!is_of_call(frame, owners_)) {
      shade_batch(frame, target);
      call_ = frame.call_of(owners_.id[0]);
      blocks_.triangles = blocks_.ready = 0;
    }
    if (!is_of_call(frame, owners_) ||
        frame.calls[static_cast<std::size_t>(call_)].shade == nullptr) {
      left |= std::uint64_t{1} << block;
      continue;
    }
    add(frame, rect, owners_);
    if (blocks_.size == BlockBatch::kMaxBlocks) shade_batch(frame, target);
  }
  shade_batch(frame, target);
  return left;
}

bool BlockShader::is_of_call(const FrameCalls& frame, const BlockOwners& owners) const {
  const auto call = static_cast<std::size_t>(call_);
  if (call >= frame.calls.size()) return false;  // of an earlier frame
  const std::uint32_t first = frame.first_id[call], end = frame.first_id[call + 1];
  return std::all_of(owners.id.begin(), owners.id.begin() + owners.size,
                     [&](std::uint32_t id) { return id >= first && id < end; });
}

/// Neighbouring blocks show the same triangles: each is set up once.
std::size_t BlockShader::place_of(std::uint32_t triangle) {
  auto& triangles = storage_.planes.triangle;
  std::uint16_t& place = place_[triangle % place_.size()];
  if (place < blocks_.triangles && triangles[place] == triangle) return place;
  place = static_cast<std::uint16_t>(blocks_.triangles++);
  triangles[place] = triangle;
  return place;
}

void BlockShader::add(const FrameCalls& frame, const PixelRect& rect, const BlockOwners& owners) {
  const std::uint32_t first_id = frame.first_id[static_cast<std::size_t>(call_)];
  BlockBatch::Block& block = blocks_.block[blocks_.size];
  block = {rect.x0, rect.y0, blocks_.size == 0 ? 0 : blocks_.block[blocks_.size - 1].end};
  ++blocks_.size;
  for (std::size_t i = 0; i < owners.size; ++i) {
    blocks_.share[block.end++] = {owners.pixels[i], place_of(owners.id[i] - first_id)};
  }
}

void BlockShader::shade_batch(const FrameCalls& frame, RenderTarget& target) {
  if (blocks_.size == 0) return;
  const DrawCall& draw = frame.calls[static_cast<std::size_t>(call_)];
  interpolate_blocks(draw, blocks_, storage_);
  const auto size = blocks_.size * TileBuffer::kBlockPixels;
  draw.shade(batch_of(draw, storage_, static_cast<int>(size)), colours_.data());
  for (std::size_t b = 0; b < blocks_.size; ++b) {
    write_whole_block(std::span<const LinearRgba, TileBuffer::kBlockPixels>(
                          colours_.data() + b * TileBuffer::kBlockPixels, TileBuffer::kBlockPixels),
                      blocks_.block[b].x0, blocks_.block[b].y0, target);
  }
  blocks_.size = 0;
  blocks_.ready = blocks_.triangles;
  if (blocks_.triangles + blocks_.share.size() > Batch::kMaxSize) {
    blocks_.triangles = blocks_.ready = 0;
  }
}

}  // namespace kinescope
