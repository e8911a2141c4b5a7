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

  /// The same for the first `count` fragments, of one body and highlight. Colours stay as they lie
  /// in memory.
  HWY_INLINE void all(int count, glm::vec3 body, glm::vec3 highlight) const {
    const Floats d;
    const int lanes = static_cast<int>(hn::Lanes(d));
#if HWY_TARGET == HWY_SCALAR  // has no vectors of four
    for (int i = 0; i < count; i += lanes) (*this)(i, splat(body), splat(highlight));
#else
    alignas(16) const float scales[4] = {body.x, body.y, body.z, opacity_};
    alignas(16) const float offsets[4] = {highlight.x, highlight.y, highlight.z, 0.0f};
    const Vec scale = hn::LoadDup128(d, scales), offset = hn::LoadDup128(d, offsets);
    const Vec plain = hn::Add(scale, offset);
    for (int k = 0; k < 4 * count; k += lanes) {
      const Vec colour =
          textured_ ? hn::Add(hn::Mul(scale, hn::Load(d, &texels_.of[0].r + k)), offset) : plain;
      hn::StoreU(colour, d, out_ + k);
    }
#endif
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
