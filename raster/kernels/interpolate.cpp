#include "raster/kernels/interpolate.h"

#include "raster/base/fixed.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/interpolate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>;
using I = hn::RebindToSigned<F>;
using U16 = hn::Rebind<std::uint16_t, F>;

/// Weights of the second and third vertex as planes on the screen, each times 1/w of its vertex;
/// and the first vertex's, which is 1/w0 less what the others take.
struct WeightPlanes {
  float x_px, y_px;          // anchor: the first vertex
  float w0;                  // 1/w there
  float dx1, dy1, dx2, dy2;  // weights 1 and 2 a pixel
  float dx_sum, dy_sum;      // the sum of all three a pixel
  const float* rows[3];
};

HWY_INLINE WeightPlanes planes_of(const DrawCall& call, std::uint32_t triangle) {
  const std::uint32_t* const v = call.indices.data() + std::size_t{3} * triangle;
  const DeviceVertices& from = call.vertices;
  std::int32_t x[3], y[3];
  WeightPlanes p;
  for (int i = 0; i < 3; ++i) {
    x[i] = Fixed24_8::from_float(from.x_px[v[i]]).raw();
    y[i] = Fixed24_8::from_float(from.y_px[v[i]]).raw();
    p.rows[i] =
        call.attributes.data() + std::size_t{v[i]} * static_cast<unsigned>(call.attribute_stride);
  }
  const std::int64_t x1 = x[1] - x[0], y1 = y[1] - y[0], x2 = x[2] - x[0], y2 = y[2] - y[0];
  const float scale = 256.0f / static_cast<float>(x1 * y2 - x2 * y1);
  const float iw0 = from.inv_w[v[0]], iw1 = from.inv_w[v[1]], iw2 = from.inv_w[v[2]];
  const float b1x = static_cast<float>(y2) * scale, b1y = -static_cast<float>(x2) * scale;
  const float b2x = -static_cast<float>(y1) * scale, b2y = static_cast<float>(x1) * scale;
  p.x_px = Fixed24_8::from_raw(x[0]).to_float();
  p.y_px = Fixed24_8::from_raw(y[0]).to_float();
  p.w0 = iw0;
  p.dx1 = b1x * iw1;
  p.dy1 = b1y * iw1;
  p.dx2 = b2x * iw2;
  p.dy2 = b2y * iw2;
  p.dx_sum = b1x * (iw1 - iw0) + b2x * (iw2 - iw0);
  p.dy_sum = b1y * (iw1 - iw0) + b2y * (iw2 - iw0);
  return p;
}

/// Fragments [first, end) of one triangle, in whole vectors: what is written past the end belongs
/// to the next run, or to the padding.
HWY_INLINE void interpolate_run(const DrawCall& call, const WeightPlanes& p, int first, int end,
                                BatchStorage& batch) {
  const F f;
  const I i;
  const U16 u16;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const auto half = hn::Set(f, 0.5f), zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  const int uv = call.texcoord_attribute;
  for (int k = first; k < end; k += lanes) {
    const auto px = hn::ConvertTo(f, hn::PromoteTo(i, hn::LoadU(u16, batch.x.data() + k)));
    const auto py = hn::ConvertTo(f, hn::PromoteTo(i, hn::LoadU(u16, batch.y.data() + k)));
    const auto dx = hn::Sub(hn::Add(px, half), hn::Set(f, p.x_px));
    const auto dy = hn::Sub(hn::Add(py, half), hn::Set(f, p.y_px));
    const auto sum = hn::MulAdd(dx, hn::Set(f, p.dx_sum),
                                hn::MulAdd(dy, hn::Set(f, p.dy_sum), hn::Set(f, p.w0)));
    const auto inverse = hn::Div(one, sum);
    const auto raw1 = hn::MulAdd(dx, hn::Set(f, p.dx1), hn::Mul(dy, hn::Set(f, p.dy1)));
    const auto raw2 = hn::MulAdd(dx, hn::Set(f, p.dx2), hn::Mul(dy, hn::Set(f, p.dy2)));
    const auto w1 = hn::Min(hn::Max(hn::Mul(raw1, inverse), zero), one);
    const auto w2 = hn::Min(hn::Max(hn::Mul(raw2, inverse), zero), hn::Sub(one, w1));
    for (int a = 0; a < call.attribute_count; ++a) {
      const float a0 = p.rows[0][a];
      const auto d1 = hn::Set(f, p.rows[1][a] - a0), d2 = hn::Set(f, p.rows[2][a] - a0);
      const auto value = hn::MulAdd(w2, d2, hn::MulAdd(w1, d1, hn::Set(f, a0)));
      hn::StoreU(value, f, batch.attribute[static_cast<std::size_t>(a)].data() + k);
    }
    if (uv < 0) continue;
    const auto gradient = [&](float d1, float d2, float dsum, std::size_t u_at, std::size_t v_at) {
      // The derivative of weight / sum.
      const auto g1 = hn::Mul(inverse, hn::NegMulAdd(w1, hn::Set(f, dsum), hn::Set(f, d1)));
      const auto g2 = hn::Mul(inverse, hn::NegMulAdd(w2, hn::Set(f, dsum), hn::Set(f, d2)));
      for (int a = 0; a < 2; ++a) {
        const float a0 = p.rows[0][uv + a];
        const auto value = hn::MulAdd(g2, hn::Set(f, p.rows[2][uv + a] - a0),
                                      hn::Mul(g1, hn::Set(f, p.rows[1][uv + a] - a0)));
        hn::StoreU(value, f, batch.gradient[a == 0 ? u_at : v_at].data() + k);
      }
    };
    gradient(p.dx1, p.dx2, p.dx_sum, 0, 1);
    gradient(p.dy1, p.dy2, p.dy_sum, 2, 3);
  }
}

void Interpolate(const DrawCall& call, int size, BatchStorage& batch) {
  for (int first = 0; first < size;) {
    const std::uint32_t triangle = batch.triangle[static_cast<std::size_t>(first)];
    int end = first + 1;
    while (end < size && batch.triangle[static_cast<std::size_t>(end)] == triangle) ++end;
    interpolate_run(call, planes_of(call, triangle), first, end, batch);
    first = end;
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(Interpolate);

void interpolate(const DrawCall& call, int size, BatchStorage& batch) {
  HWY_DYNAMIC_DISPATCH(Interpolate)(call, size, batch);
}

}  // namespace kinescope
#endif
