// Visible fragments, grouped into batches of one draw call, go through its shader.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/aligned_vector.h"
#include "raster/batch.h"
#include "raster/draw_call.h"
#include "raster/kernels/interpolate.h"
#include "raster/visible_fragments.h"

namespace kinescope {

/// The draw calls of a frame, and the id of each one's first triangle (one more entry at the end).
struct FrameCalls {
  std::span<const DrawCall> calls;
  std::vector<std::uint32_t> first_id;

  /// The call that a triangle belongs to.
  int call_of(std::uint32_t id) const;
};

/// One worker's storage for batches.
class FragmentShader {
 public:
  /// Colours of the fragments, in their order; `clear` for calls without a shader. Valid until the
  /// next call.
  std::span<const LinearRgba> shade(const FrameCalls& frame, const VisibleFragments& fragments,
                                    const LinearRgba& clear);

 private:
  void group_by_call(const FrameCalls& frame, const VisibleFragments& fragments);
  /// Fragments of one call: [first, end) of order_, filled up to `next` while they are sorted.
  struct Group {
    int call;
    int first, end, next;
  };
  void shade_group(const FrameCalls& frame, const VisibleFragments& fragments, const Group& group,
                   const LinearRgba& clear);
  void load(const FrameCalls& frame, const VisibleFragments& fragments, int call, int first,
            int count);

  std::vector<Group> groups_;
  std::vector<std::uint32_t> group_of_call_;  ///< index + 1 into groups_, 0: none yet
  std::vector<std::uint32_t> group_of_fragment_;
  std::vector<int> order_;  ///< fragments, grouped by call; empty: as they are
  AlignedVector<LinearRgba> colours_;
  BatchStorage storage_;
  alignas(64) std::array<LinearRgba, Batch::kMaxSize> shaded_{};
};

}  // namespace kinescope
