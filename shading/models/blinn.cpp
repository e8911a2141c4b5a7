// Light at every fragment, its highlight by the half vector (J. F. Blinn, 1977).
#include "shading/models/models.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/models/blinn.cpp"
#include <hwy/foreach_target.h>
// after foreach_target
#include <hwy/highway.h>

#include "shading/kernels/finish-inl.h"
#include "shading/kernels/illuminate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

void shade_blinn(const Batch& batch, LinearRgba* out) {
  const Surface& surface = *static_cast<const Surface*>(batch.constants);
  const Finish finish(batch, surface, vertex_row::kTexcoord, out);
  illuminate</*kHalfVector=*/true>(surface, point_arrays(batch, surface), batch.size, finish);
}

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(shade_blinn);

ShadeFunction blinn_shader() { return &HWY_DYNAMIC_DISPATCH(shade_blinn); }

}  // namespace kinescope
#endif
