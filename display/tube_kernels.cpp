#include "display/tube_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/tube_kernels.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

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

template <int kLayers>
void MixLayersOf(int n, const float* const* light, const float (*colour)[3], float* out) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= n; i += lanes) {
    hn::Vec<Floats> sum[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    for (int layer = 0; layer < kLayers; ++layer) {
      const auto l = hn::LoadU(d, light[layer] + i);
      for (int c = 0; c < 3; ++c) {
        sum[c] = hn::MulAdd(hn::Set(d, colour[layer][c]), l, sum[c]);
      }
    }
    hn::StoreInterleaved3(sum[0], sum[1], sum[2], d, out + 3 * i);
  }
  for (; i < n; ++i) {
    for (int c = 0; c < 3; ++c) {
      float sum = 0;
      for (int layer = 0; layer < kLayers; ++layer) sum += colour[layer][c] * light[layer][i];
      out[3 * i + c] = sum;
    }
  }
}

void MixLayers(int n, std::span<const float* const> light, const float (*colour)[3], float* out) {
  if (light.size() == 1) {
    MixLayersOf<1>(n, light.data(), colour, out);
  } else if (light.size() == 2) {
    MixLayersOf<2>(n, light.data(), colour, out);
  } else {
    MixLayersOf<3>(n, light.data(), colour, out);
  }
}

/// With the number of taps known the compiler unrolls; kTaps 0 takes any.
template <int kTaps>
void SpreadAcrossBy(int width, int any_taps, const int* start, const float* weight, const float* in,
                    float* out) {
  const int taps = kTaps > 0 ? kTaps : any_taps;
  // Red, green, blue, and a lane that the next pixel overwrites; one at a time without vectors.
  const hn::CappedTag<float, 4> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int x = 0; x < width; ++x, weight += taps) {
    for (int channel = 0; channel < 3; channel += lanes) {
      const float* from = in + 3 * start[x] + channel;
      auto sum = hn::Mul(hn::Set(d, weight[0]), hn::LoadU(d, from));
#pragma GCC unroll 4
      for (int t = 1; t < taps; ++t) {
        sum = hn::MulAdd(hn::Set(d, weight[t]), hn::LoadU(d, from + 3 * t), sum);
      }
      hn::StoreU(sum, d, out + 3 * x + channel);
    }
  }
}

void SpreadAcross(int width, int taps, const int* start, const float* weight, const float* in,
                  float* out) {
  switch (taps) {
    case 3:
      return SpreadAcrossBy<3>(width, taps, start, weight, in, out);
    case 4:
      return SpreadAcrossBy<4>(width, taps, start, weight, in, out);
    case 5:
      return SpreadAcrossBy<5>(width, taps, start, weight, in, out);
    default:
      return SpreadAcrossBy<0>(width, taps, start, weight, in, out);
  }
}

template <int kRows>
void SpreadDownBy(int n, const float* const* rows, int any_count, const float* weight, float* out) {
  const int count = kRows > 0 ? kRows : any_count;
  for_each_vector(n, [=](auto d, int i) {
    auto sum = hn::Mul(hn::Set(d, weight[0]), hn::LoadU(d, rows[0] + i));
#pragma GCC unroll 4
    for (int r = 1; r < count; ++r) {
      sum = hn::MulAdd(hn::Set(d, weight[r]), hn::LoadU(d, rows[r] + i), sum);
    }
    hn::StoreU(sum, d, out + i);
  });
}

void SpreadDown(int n, std::span<const float* const> rows, const float* weight, float* out) {
  const int count = static_cast<int>(rows.size());
  switch (count) {
    case 3:
      return SpreadDownBy<3>(n, rows.data(), count, weight, out);
    case 4:
      return SpreadDownBy<4>(n, rows.data(), count, weight, out);
    default:
      return SpreadDownBy<0>(n, rows.data(), count, weight, out);
  }
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
HWY_EXPORT(MixLayers);
HWY_EXPORT(SpreadAcross);
HWY_EXPORT(SpreadDown);

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

void mix_layers(int n, std::span<const float* const> light, const float (*colour)[3], float* out) {
  HWY_DYNAMIC_DISPATCH(MixLayers)(n, light, colour, out);
}

void spread_across(int width, int taps, const int* start, const float* weight, const float* in,
                   float* out) {
  HWY_DYNAMIC_DISPATCH(SpreadAcross)(width, taps, start, weight, in, out);
}

void spread_down(int n, std::span<const float* const> rows, const float* weight, float* out) {
  HWY_DYNAMIC_DISPATCH(SpreadDown)(n, rows, weight, out);
}

}  // namespace kinescope
#endif  // HWY_ONCE
