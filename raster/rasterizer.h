// The tile-parallel rasterizer: triangles to visible fragments to colour.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "raster/base/workers.h"
#include "raster/draw_call.h"
#include "raster/render_target.h"

namespace kinescope {

struct RasterizerOptions {
  int tile_width = 0;   ///< pixels, a multiple of 8 up to 64; 0 chooses by the sample count
  int tile_height = 0;  ///< pixels, a multiple of 8 up to 64; 0 chooses by the sample count
};

/// Figures of one frame. The hash is the same for any thread count, tile size and instruction set.
struct RasterStats {
  std::uint64_t triangles = 0;        ///< submitted
  std::uint64_t drawn = 0;            ///< left after culling
  std::uint64_t fragments = 0;        ///< shaded
  std::uint64_t visibility_hash = 0;  ///< of (depth, who wrote it) a sample; 0 unless asked for
};

/// Triangles into a target. Keeps its buffers between frames; use one from one thread.
class Rasterizer {
 public:
  explicit Rasterizer(Workers& workers, RasterizerOptions options = {});
  ~Rasterizer();
  Rasterizer(const Rasterizer&) = delete;
  Rasterizer& operator=(const Rasterizer&) = delete;

  /// Clears the target and draws all calls, as if one triangle after another (DrawCall says how
  /// each meets what is there). Of plain fragments at one depth the one submitted first wins.
  /// @throws Error if memory for the frame cannot be had, or (usage) for a tile's size out of range
  RasterStats draw(RenderTarget& target, std::span<const DrawCall> calls,
                   bool want_visibility_hash = false);

 private:
  struct Frame;
  std::unique_ptr<Frame> frame_;
};

}  // namespace kinescope
