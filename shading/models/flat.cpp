// One light for a whole triangle (W. J. Bouknight, "A procedure for generation of three-dimensional
// half-toned computer graphics presentations", CACM 13(9), 1970).
#include "shading/models/models.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/models/flat.cpp"
#include <hwy/foreach_target.h>
// after foreach_target
#include <hwy/highway.h>

#include <algorithm>
#include <cassert>
#include <span>

#include "shading/kernels/finish-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

/// The light of `lanes` fragments' triangles.
struct LitVectors {
  Vec3 body, highlight;
};

LitVectors gather(std::span<const LitColour> light, const std::uint32_t* triangle, int lanes) {
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(Floats()));
  alignas(64) float parts[6][kLanes];
  for (int k = 0; k < kLanes; ++k) {
    assert(triangle[std::min(k, lanes - 1)] < light.size());
    const LitColour& lit = light[triangle[std::min(k, lanes - 1)]];
    for (int c = 0; c < 3; ++c) {
      parts[c][k] = lit.body[c];
      parts[3 + c][k] = lit.highlight[c];
    }
  }
  return {load({parts[0], parts[1], parts[2]}, 0), load({parts[3], parts[4], parts[5]}, 0)};
}

void shade_flat(const Batch& batch, LinearRgba* out) {
  const Surface& surface = *static_cast<const Surface*>(batch.constants);
  const Finish finish(batch, surface, vertex_row::kTexcoord, out);
  const hn::RebindToUnsigned<Floats> du;
  const int step = static_cast<int>(hn::Lanes(du));
  for (int i = 0; i < batch.size; i += step) {
    const std::uint32_t* triangle = batch.primitive + i;
    if (hn::AllTrue(du, hn::Eq(hn::Load(du, triangle), hn::Set(du, *triangle)))) {
      assert(*triangle < surface.triangle_light.size());
      const LitColour& lit = surface.triangle_light[*triangle];
      finish(i, splat(lit.body), splat(lit.highlight));
    } else {
      const LitVectors lit =
          gather(surface.triangle_light, triangle, std::min(step, batch.size - i));
      finish(i, lit.body, lit.highlight);
    }
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
