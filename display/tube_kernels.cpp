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

void ExciteSlowTerm(int n, const SlowTermStep& step, const float* old_dose, float* state,
                    float* light) {
  // By value: what it writes could alias what is captured by reference.
  for_each_vector(n, [=](auto d, int i) {
    const auto old_state = hn::LoadU(d, state + i);
    const auto old_grown = hn::MulAdd(hn::Set(d, step.old_slope), hn::LoadU(d, step.old_grown + i),
                                      hn::Set(d, step.old_constant));
    const auto old_weight =
        hn::Mul(hn::Mul(hn::Set(d, step.old_scale), hn::LoadU(d, step.old_decay + i)), old_grown);
    const auto new_weight = hn::MulAdd(hn::Set(d, step.new_slope), hn::LoadU(d, step.new_grown + i),
                                       hn::Set(d, step.new_constant));
    auto new_state = hn::MulAdd(hn::Set(d, step.gain), hn::LoadU(d, old_dose + i),
                                hn::Mul(hn::Set(d, step.keep), old_state));
    // A dark cell's light would fade into denormal numbers, which are slow.
    new_state = hn::IfThenElseZero(hn::Gt(new_state, hn::Set(d, 1e-25f)), new_state);
    hn::StoreU(new_state, d, state + i);
    const auto sum = hn::MulAdd(old_weight, old_state, hn::LoadU(d, light + i));
    hn::StoreU(hn::MulAdd(new_weight, new_state, sum), d, light + i);
  });
}

void ExciteDose(int n, const float* old_weight, float even, const float* new_weight,
                const float* new_dose, float* dose, float* light) {
  for_each_vector(n, [=](auto d, int i) {
    const auto fresh = hn::LoadU(d, new_dose + i);
    const auto sum =
        hn::MulAdd(hn::LoadU(d, old_weight + i), hn::LoadU(d, dose + i), hn::LoadU(d, light + i));
    const auto weight = hn::Add(hn::LoadU(d, new_weight + i), hn::Set(d, even));
    hn::StoreU(hn::MulAdd(weight, fresh, sum), d, light + i);
    hn::StoreU(fresh, d, dose + i);
  });
}

template <typename D>
HWY_INLINE void StoreDose(D d, const float* table, hn::Vec<hn::RebindToSigned<D>> at,
                          hn::Vec<D> share, float* out) {
  const auto low = hn::GatherIndex(d, table, at);
  const auto high = hn::GatherIndex(d, table + 1, at);
  hn::StoreU(hn::MulAdd(share, hn::Sub(high, low), low), d, out);
}

void Amplify(int n, std::span<const float> response, float scale, const float* voltage,
             const float* narrow_table, const float* wide_table, float* narrow, float* wide) {
  for_each_vector(n, [=](auto d, int i) {
    auto sum = hn::Zero(d);
    for (std::size_t t = 0; t < response.size(); ++t) {
      sum = hn::MulAdd(hn::Set(d, response[t]),
                       hn::LoadU(d, voltage + i + static_cast<std::ptrdiff_t>(t)), sum);
    }
    const auto at = hn::Mul(sum, hn::Set(d, scale));
    const hn::RebindToSigned<decltype(d)> di;
    const auto whole = hn::ConvertTo(di, at);
    const auto share = hn::Sub(at, hn::ConvertTo(d, whole));
    StoreDose(d, narrow_table, whole, share, narrow + i);
    StoreDose(d, wide_table, whole, share, wide + i);
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

void excite_slow_term(int n, const SlowTermStep& step, const float* old_dose, float* state,
                      float* light) {
  HWY_DYNAMIC_DISPATCH(ExciteSlowTerm)(n, step, old_dose, state, light);
}

void excite_dose(int n, const float* old_weight, float even, const float* new_weight,
                 const float* new_dose, float* dose, float* light) {
  HWY_DYNAMIC_DISPATCH(ExciteDose)(n, old_weight, even, new_weight, new_dose, dose, light);
}

void amplify(int n, std::span<const float> response, float scale, const float* voltage,
             const float* narrow_table, const float* wide_table, float* narrow, float* wide) {
  HWY_DYNAMIC_DISPATCH(Amplify)
  (n, response, scale, voltage, narrow_table, wide_table, narrow, wide);
}

void add_rows(int n, const float* a, const float* b, float* sum) {
  HWY_DYNAMIC_DISPATCH(AddRows)(n, a, b, sum);
}

void fill_ramp(int n, float start, float slope, float* out) {
  HWY_DYNAMIC_DISPATCH(FillRamp)(n, start, slope, out);
}

}  // namespace kinescope
#endif  // HWY_ONCE
