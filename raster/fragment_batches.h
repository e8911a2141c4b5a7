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

/// Fragments to be shaded: triangle, and pixel in the target (x in the low half, y in the high).
/// Readable 16 entries beyond the last.
struct FragmentView {
  const std::uint32_t* id;
  const std::uint32_t* xy;
  int size;
};

/// One worker's storage for batches.
class FragmentShader {
 public:
  /// Colours of the fragments, in their order; `clear` for calls without a shader. Valid until the
  /// next call.
  std::span<const LinearRgba> shade(const FrameCalls& frame, const FragmentView& fragments,
                                    const LinearRgba& clear);
  std::span<const LinearRgba> shade(const FrameCalls& frame, const VisibleFragments& fragments,
                                    const LinearRgba& clear) {
    return shade(frame, FragmentView{fragments.id.data(), fragments.xy.data(), fragments.size},
                 clear);
  }
  /// The same for fragments of one call, to `out`, which has room for Batch::kMaxSize more.
  void shade_call(const FrameCalls& frame, int call, const FragmentView& fragments,
                  const LinearRgba& clear, LinearRgba* out);

 private:
  void group_by_call(const FrameCalls& frame, const FragmentView& fragments);
  /// Fragments of one call: [first, end) of order_, filled up to `next` while they are sorted.
  struct Group {
    int call;
    int first, end, next;
  };
  void shade_group(const FrameCalls& frame, const FragmentView& fragments, const Group& group,
                   const LinearRgba& clear, LinearRgba* colours);
  void load(const FrameCalls& frame, const FragmentView& fragments, int call, int first, int count);

  std::vector<Group> groups_;
  std::vector<std::uint32_t> group_of_call_;  ///< index + 1 into groups_, 0: none yet
  std::vector<std::uint32_t> group_of_fragment_;
  std::vector<int> order_;  ///< fragments, grouped by call; empty: as they are
  AlignedVector<LinearRgba> colours_;
  BatchStorage storage_;
  alignas(64) std::array<LinearRgba, Batch::kMaxSize> shaded_{};
};

}  // namespace kinescope
