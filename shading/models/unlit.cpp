// The surface's own colour, without any light.
#include "shading/models/models.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/models/unlit.cpp"
#include <hwy/foreach_target.h>
// after foreach_target
#include <hwy/highway.h>

#include "shading/kernels/finish-inl.h"
#include "shading/kernels/lit_points.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

void shade_unlit(const Batch& batch, LinearRgba* out) {
  const Surface& surface = *static_cast<const Surface*>(batch.constants);
  const Finish finish(batch, surface, vertex_row::kTexcoord, out);
  const Material& material = surface.material;
  if (!surface.vertex_colours)
    return finish.all(batch.size, material.base_colour, material.emission);
  const PointArrays points = point_arrays(batch, surface);
  const Vec3 base = splat(material.base_colour), emission = splat(material.emission);
  const int step = static_cast<int>(hn::Lanes(Floats()));
  for (int i = 0; i < batch.size; i += step) {
    finish(i, mul(base, load(points.colour, i)), emission);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(shade_unlit);

ShadeFunction unlit_shader() { return &HWY_DYNAMIC_DISPATCH(shade_unlit); }

}  // namespace kinescope
#endif
