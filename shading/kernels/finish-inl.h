// The last step of every model: the texture on the body's light, the highlight on top, and opacity.
#if defined(KINESCOPE_SHADING_KERNELS_FINISH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_SHADING_KERNELS_FINISH_INL_H
#undef KINESCOPE_SHADING_KERNELS_FINISH_INL_H
#else
#define KINESCOPE_SHADING_KERNELS_FINISH_INL_H
#endif

#include <hwy/highway.h>

#include "shading/kernels/vec3-inl.h"
#include "shading/surface.h"
#include "shading/texture_lookup.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

/// Writes a batch's colours, a vector at a time.
class Finish {
 public:
  /// Looks up the texture of the whole batch; (u, v) are attributes `texcoord` and the next.
  HWY_INLINE Finish(const Batch& batch, const Surface& surface, int texcoord, LinearRgba* out)
      : opacity_(surface.material.opacity),
        textured_(surface.texture != nullptr && surface.texture->levels() > 0),
        out_(&out->r) {
    if (textured_) look_up(*surface.texture, batch, texcoord, texels_.of);
  }

  HWY_INLINE void operator()(int i, const Vec3& body, const Vec3& highlight) const {
    const Floats d;
    Vec3 colour = body;
    Vec alpha = hn::Set(d, opacity_);
    if (textured_) {
      Vec3 texel;
      Vec texel_alpha;
      hn::LoadInterleaved4(d, &texels_.of[i].r, texel.x, texel.y, texel.z, texel_alpha);
      colour = mul(body, texel);
      alpha = hn::Mul(alpha, texel_alpha);
    }
    hn::StoreInterleaved4(hn::Add(colour.x, highlight.x), hn::Add(colour.y, highlight.y),
                          hn::Add(colour.z, highlight.z), alpha, d, out_ + 4 * i);
  }

 private:
  float opacity_;
  bool textured_;
  float* out_;
  /// Of a texture only: not worth clearing for each batch.
  union Texels {
    Texels() {}
    HWY_ALIGN LinearRgba of[Batch::kMaxSize];
  } texels_;
};

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#endif
