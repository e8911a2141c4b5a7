#include "display/tube_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/tube_kernels.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using Floats = hn::ScalableTag<float>;

/// Runs body(tag, index) over whole vectors, then over the rest one by one.
template <typename Body>
HWY_INLINE void for_each_vector(int n, const Body& body) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= n; i += lanes) body(d, i);
  for (; i < n; ++i) body(hn::CappedTag<float, 1>(), i);
}

void AddScaled(int n, float scale, const float* a, float* out) {
  for_each_vector(n, [=](auto d, int i) {
    hn::StoreU(hn::MulAdd(hn::Set(d, scale), hn::LoadU(d, a + i), hn::LoadU(d, out + i)), d,
               out + i);
  });
}

void AddScaledProduct(int n, float scale, const float* a, float constant, float slope,
                      const float* b, float* out) {
  for_each_vector(n, [=](auto d, int i) {
    const auto grown = hn::MulAdd(hn::Set(d, slope), hn::LoadU(d, b + i), hn::Set(d, constant));
    const auto decay = hn::Mul(hn::Set(d, scale), hn::LoadU(d, a + i));
    hn::StoreU(hn::MulAdd(decay, grown, hn::LoadU(d, out + i)), d, out + i);
  });
}

void AddLight(int n, float scale, const float* table, const float* state, float* light) {
  for_each_vector(n, [=](auto d, int i) {
    const auto weight = hn::Mul(hn::Set(d, scale), hn::LoadU(d, table + i));
    hn::StoreU(hn::MulAdd(weight, hn::LoadU(d, state + i), hn::LoadU(d, light + i)), d, light + i);
  });
}

/// One Gaussian's part: the state moves on, and both give light.
template <typename D>
HWY_INLINE void MoveState(D d, const SlowTermStep& step, hn::Vec<D> old_weight,
                          hn::Vec<D> new_weight, const float* dose, float* state, float* light) {
  const auto old_state = hn::LoadU(d, state);
  auto new_state = hn::MulAdd(hn::Set(d, step.gain), hn::LoadU(d, dose),
                              hn::Mul(hn::Set(d, step.keep), old_state));
  // A dark cell's light would fade into denormal numbers, which are slow.
  new_state = hn::IfThenElseZero(hn::Gt(new_state, hn::Set(d, 1e-25f)), new_state);
  hn::StoreU(new_state, d, state);
  const auto sum = hn::MulAdd(old_weight, old_state, hn::LoadU(d, light));
  hn::StoreU(hn::MulAdd(new_weight, new_state, sum), d, light);
}

void ExciteSlowTerm(int n, const SlowTermStep& step, LightRows old_dose, LightRows state,
                    LightRows light) {
  // By value: what it writes could alias what is captured by reference.
  for_each_vector(n, [=](auto d, int i) {
    const auto old_grown = hn::MulAdd(hn::Set(d, step.old_slope), hn::LoadU(d, step.old_grown + i),
                                      hn::Set(d, step.old_constant));
    const auto old_weight =
        hn::Mul(hn::Mul(hn::Set(d, step.old_scale), hn::LoadU(d, step.old_decay + i)), old_grown);
    const auto new_weight = hn::MulAdd(hn::Set(d, step.new_slope), hn::LoadU(d, step.new_grown + i),
                                       hn::Set(d, step.new_constant));
    for (std::size_t basis = 0; basis < 2; ++basis) {
      MoveState(d, step, old_weight, new_weight, old_dose[basis] + i, state[basis] + i,
                light[basis] + i);
    }
  });
}

void ExciteDose(int n, const float* old_weight, float even, const float* new_weight,
                DoseRows new_dose, LightRows dose, LightRows light) {
  for_each_vector(n, [=](auto d, int i) {
    const auto before = hn::LoadU(d, old_weight + i);
    const auto after = hn::Add(hn::LoadU(d, new_weight + i), hn::Set(d, even));
    for (std::size_t basis = 0; basis < 2; ++basis) {
      const auto fresh = hn::LoadU(d, new_dose[basis] + i);
      const auto sum =
          hn::MulAdd(before, hn::LoadU(d, dose[basis] + i), hn::LoadU(d, light[basis] + i));
      hn::StoreU(hn::MulAdd(after, fresh, sum), d, light[basis] + i);
      hn::StoreU(fresh, d, dose[basis] + i);
    }
  });
}

/// x^power for x > 0, to 2e-5: the logarithm to base 2 by a series in (m - 1) / (m + 1), and back.
template <typename D>
HWY_INLINE hn::Vec<D> power_of(D d, hn::Vec<D> x, float power) {
  const hn::RebindToSigned<D> di;
  const auto set = [d](float v) { return hn::Set(d, v); };
  // The mantissa m from sqrt(1/2) to sqrt(2).
  const auto bits = hn::Sub(hn::BitCast(di, x), hn::Set(di, 0x3f3504f3));
  const auto exponent = hn::ConvertTo(d, hn::ShiftRight<23>(bits));
  const auto m =
      hn::BitCast(d, hn::Add(hn::And(bits, hn::Set(di, 0x007fffff)), hn::Set(di, 0x3f3504f3)));
  const auto s = hn::Div(hn::Sub(m, set(1)), hn::Add(m, set(1)));
  const auto q = hn::Mul(s, s);
  auto series = hn::MulAdd(set(0.57707802f), q, set(0.96179669f));
  series = hn::MulAdd(series, q, set(2.88539008f));
  const auto y = hn::Mul(hn::MulAdd(series, s, exponent), set(power));
  const auto shifted = hn::Add(hn::Max(y, set(-126)), set(12582912.0f));
  const auto f = hn::Sub(hn::Max(y, set(-126)), hn::Sub(shifted, set(12582912.0f)));
  auto p = hn::MulAdd(set(0.0013266979f), f, set(0.0096754694f));
  p = hn::MulAdd(p, f, set(0.055507427f));
  p = hn::MulAdd(p, f, set(0.24022122f));
  p = hn::MulAdd(p, f, set(0.69314695f));
  p = hn::MulAdd(p, f, set(1.0f));
  return hn::BitCast(d, hn::Add(hn::BitCast(di, p), hn::ShiftLeft<23>(hn::BitCast(di, shifted))));
}

void Amplify(int n, std::span<const float> response, const GunLaw& law, const float* voltage,
             float* narrow, float* wide) {
  for_each_vector(n, [=](auto d, int i) {
    const auto set = [d](float v) { return hn::Set(d, v); };
    auto sum = hn::Zero(d);
    for (std::size_t t = 0; t < response.size(); ++t) {
      sum = hn::MulAdd(set(response[t]), hn::LoadU(d, voltage + i + static_cast<std::ptrdiff_t>(t)),
                       sum);
    }
    const auto grid = hn::MulAdd(sum, set(law.contrast), set(law.brightness));
    const auto root = hn::IfThenElseZero(
        hn::Gt(grid, set(1e-6f)), power_of(d, hn::Max(grid, set(1e-6f)), law.third_of_gamma));
    const auto current = hn::Mul(root, hn::Mul(root, root));
    const auto free_sigma = hn::MulAdd(root, set(law.growth), set(law.least));
    const auto sigma = hn::Min(hn::Max(free_sigma, set(law.narrow)), set(law.wide));
    const auto share =
        hn::Sub(set(law.at_wide), hn::Div(set(law.by_square), hn::Mul(sigma, sigma)));
    const auto in_wide = hn::Mul(current, share);
    hn::StoreU(in_wide, d, wide + i);
    hn::StoreU(hn::Sub(current, in_wide), d, narrow + i);
  });
}

void AddRows(int n, const float* a, const float* b, float* sum) {
  for_each_vector(n, [=](auto d, int i) {
    const auto both = hn::Add(hn::LoadU(d, a + i), hn::LoadU(d, b + i));
    hn::StoreU(hn::Add(hn::LoadU(d, sum + i), both), d, sum + i);
  });
}

void FillRamp(int n, float start, float slope, float* out) {
  for_each_vector(n, [=](auto d, int i) {
    const auto at = lanes_from(d, static_cast<float>(i) + 0.5f);
    hn::StoreU(hn::MulAdd(hn::Set(d, slope), at, hn::Set(d, start)), d, out + i);
  });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(AddScaled);
HWY_EXPORT(AddScaledProduct);
HWY_EXPORT(AddLight);
HWY_EXPORT(ExciteSlowTerm);
HWY_EXPORT(ExciteDose);
HWY_EXPORT(Amplify);
HWY_EXPORT(AddRows);
HWY_EXPORT(FillRamp);

void add_scaled(int n, float scale, const float* a, float* out) {
  HWY_DYNAMIC_DISPATCH(AddScaled)(n, scale, a, out);
}

void add_scaled_product(int n, float scale, const float* a, float constant, float slope,
                        const float* b, float* out) {
  HWY_DYNAMIC_DISPATCH(AddScaledProduct)(n, scale, a, constant, slope, b, out);
}

void add_light(int n, float scale, const float* table, const float* state, float* light) {
  HWY_DYNAMIC_DISPATCH(AddLight)(n, scale, table, state, light);
}

void excite_slow_term(int n, const SlowTermStep& step, LightRows old_dose, LightRows state,
                      LightRows light) {
  HWY_DYNAMIC_DISPATCH(ExciteSlowTerm)(n, step, old_dose, state, light);
}

void excite_dose(int n, const float* old_weight, float even, const float* new_weight,
                 DoseRows new_dose, LightRows dose, LightRows light) {
  HWY_DYNAMIC_DISPATCH(ExciteDose)(n, old_weight, even, new_weight, new_dose, dose, light);
}

void amplify(int n, std::span<const float> response, const GunLaw& law, const float* voltage,
             float* narrow, float* wide) {
  HWY_DYNAMIC_DISPATCH(Amplify)(n, response, law, voltage, narrow, wide);
}

void add_rows(int n, const float* a, const float* b, float* sum) {
  HWY_DYNAMIC_DISPATCH(AddRows)(n, a, b, sum);
}

void fill_ramp(int n, float start, float slope, float* out) {
  HWY_DYNAMIC_DISPATCH(FillRamp)(n, start, slope, out);
}

}  // namespace kinescope
#endif  // HWY_ONCE
