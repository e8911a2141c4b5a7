// Phong's illumination law over vectors of points; the scalar twin is light_point().
#if defined(KINESCOPE_SHADING_KERNELS_ILLUMINATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KINESCOPE_SHADING_KERNELS_ILLUMINATE_INL_H
#undef KINESCOPE_SHADING_KERNELS_ILLUMINATE_INL_H
#else
#define KINESCOPE_SHADING_KERNELS_ILLUMINATE_INL_H
#endif

#include <hwy/highway.h>

#include "shading/kernels/lit_points.h"
#include "shading/kernels/vec3-inl.h"
#include "shading/surface.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {

/// What arrives at the points from `light`: the unit vectors to it, and how much of its colour.
struct Arrival {
  Vec3 to_light;
  Vec strength;
};

HWY_INLINE Arrival arrival(const PreparedLight& light, const Vec3& position) {
  const Floats d;
  Arrival in{splat(-light.direction), hn::Set(d, 1.0f)};
  if (light.kind == LightKind::kDirectional) return in;
  const Vec3 way = sub(splat(light.position), position);
  const Vec squared = dot(way, way);
  const Vec inverse = inverse_length(squared);
  in.to_light = scale(way, inverse);
  if (light.attenuated) {
    const Vec distance = hn::Mul(squared, inverse);
    const glm::vec3& k = light.attenuation;
    const Vec linear = hn::MulAdd(hn::Set(d, k.z), distance, hn::Set(d, k.y));
    const Vec divisor = hn::MulAdd(linear, distance, hn::Set(d, k.x));
    in.strength = hn::Div(in.strength, hn::Max(divisor, hn::Set(d, kLeastAttenuation)));
  }
  if (light.kind == LightKind::kSpot) {
    const Vec cos_off_axis = dot(in.to_light, splat(-light.direction));
    const Vec t =
        hn::Mul(hn::Sub(cos_off_axis, hn::Set(d, light.cos_outer)), hn::Set(d, light.cone_scale));
    const Vec inside = hn::Min(hn::ZeroIfNegative(t), hn::Set(d, 1.0f));
    const Vec smooth =
        hn::Mul(hn::Mul(inside, inside), hn::NegMulAdd(hn::Set(d, 2.0f), inside, hn::Set(d, 3.0f)));
    in.strength = hn::Mul(in.strength, smooth);
  }
  return in;
}

/// The cosine that the highlight's power is taken of.
template <bool kHalfVector>
HWY_INLINE Vec highlight_cosine(const Vec& cos_in, const Vec& cos_eye, const Vec& light_eye) {
  const Floats d;
  const Vec two = hn::Set(d, 2.0f);
  // n.h of the half vector h = (l + v) / |l + v|, where |l + v|^2 = 2 + 2 l.v
  if (kHalfVector) {
    return hn::Mul(hn::Add(cos_in, cos_eye), inverse_length(hn::MulAdd(two, light_eye, two)));
  }
  // r.v of the reflection vector r = 2 (n.l) n - l
  return hn::MulSub(hn::Mul(two, cos_in), cos_eye, light_eye);
}

/// What the points see: unit normals, unit vectors to the eye, and the cosine between them.
struct View {
  Vec3 normal, to_eye;
  Vec cosine;
};

/// Double-sided normals turn with the triangle, where it is known: near an outline the normal that
/// is interpolated may lean away from the eye though its triangle does not.
HWY_INLINE View view_of(const Surface& surface, const PointArrays& points, int i,
                        const Vec3& position) {
  const Floats d;
  View view{unit(load(points.normal, i)), unit(sub(splat(surface.eye), position)), hn::Zero(d)};
  view.cosine = dot(view.normal, view.to_eye);
  if (surface.material.double_sided) {
    const Vec one = hn::Set(d, 1.0f);
    const Vec sign = points.facing == nullptr ? hn::CopySignToAbs(one, view.cosine)
                     : surface.mirrored       ? hn::Neg(hn::Load(d, points.facing + i))
                                              : hn::Load(d, points.facing + i);
    view.normal = scale(view.normal, sign);
    view.cosine = hn::Mul(view.cosine, sign);
  }
  return view;
}

/// Calls emit(i, body, highlight) for each vector of points i, i + 1, ... below `count` (rounded up
/// to whole vectors). `body` still lacks the texture.
template <bool kHalfVector, class Emit>
HWY_INLINE void illuminate(const Surface& surface, const PointArrays& points, int count,
                           const Emit& emit) {
  const Floats d;
  const Material& material = surface.material;
  const HighlightConstants shiny(material);
  ReadyLights lights(surface.lights);
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const Vec3 position = load(points.position, i);
    const View view = view_of(surface, points, i, position);
    Vec3 diffuse = splat(surface.ambient);
    Vec3 highlight = splat(glm::vec3(0.0f));
    for (std::size_t k = 0; k < surface.lights.size(); ++k) {
      const PreparedLight& light = lights.at(k);
      const Arrival in = arrival(light, position);
      const Vec cos_in = dot(view.normal, in.to_light);
      const auto lit = hn::Gt(cos_in, hn::Zero(d));
      if (hn::AllFalse(d, lit)) continue;
      const Vec arriving = hn::IfThenElseZero(lit, hn::Mul(cos_in, in.strength));
      diffuse = mul_add(arriving, splat(light.colour), diffuse);
      if (shiny.none) continue;
      const Vec cosine =
          highlight_cosine<kHalfVector>(cos_in, view.cosine, dot(in.to_light, view.to_eye));
      const auto shines = hn::And(lit, hn::Gt(cosine, hn::Set(d, shiny.least_cosine)));
      if (hn::AllFalse(d, shines)) continue;
      const Vec power = fast_pow(d, hn::Min(cosine, hn::Set(d, 1.0f)), hn::Set(d, shiny.exponent));
      const Vec shine = hn::IfThenElseZero(shines, hn::Mul(power, in.strength));
      highlight = mul_add(shine, splat(light.colour), highlight);
    }
    Vec3 body = mul(diffuse, splat(material.base_colour));
    if (points.colour[0] != nullptr) body = mul(body, load(points.colour, i));
    emit(i, body, mul_add(highlight, splat(material.specular), splat(material.emission)));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#endif
