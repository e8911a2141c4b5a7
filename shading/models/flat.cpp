// One light for a whole triangle (W. J. Bouknight, "A procedure for generation of three-dimensional
// half-toned computer graphics presentations", CACM 13(9), 1970).
#include "shading/models/models.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/models/flat.cpp"
#include <hwy/foreach_target.h>
// after foreach_target
#include <hwy/highway.h>

#include <cassert>

#include "shading/kernels/finish-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

void shade_flat(const Batch& batch, LinearRgba* out) {
  const Surface& surface = *static_cast<const Surface*>(batch.constants);
  const Finish finish(batch, surface, vertex_row::kTexcoord, out);
  constexpr int kStep = static_cast<int>(hn::MaxLanes(Floats()));
  alignas(64) float light[6][kStep];
  for (int i = 0; i < batch.size; i += kStep) {
    for (int k = 0; k < kStep; ++k) {
      const std::uint32_t triangle = batch.primitive[std::min(i + k, batch.size - 1)];
      assert(triangle < surface.triangle_light.size());
      const LitColour& lit = surface.triangle_light[triangle];
      for (int c = 0; c < 3; ++c) {
        light[c][k] = lit.body[c];
        light[3 + c][k] = lit.highlight[c];
      }
    }
    finish(i, load({light[0], light[1], light[2]}, 0), load({light[3], light[4], light[5]}, 0));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(shade_flat);

ShadeFunction flat_shader() { return &HWY_DYNAMIC_DISPATCH(shade_flat); }

}  // namespace kinescope
#endif
