#include "display/tube/finish_kernels.h"

#include <hwy/cache_control.h>

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/tube/finish_kernels.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "display/eight_floats-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// A row with its constants spread over vectors.
template <int kLayers, bool kMask, bool kGlow>
class Finisher {
 public:
  explicit Finisher(const FinishRow& row) : glow_share_(set(row.glow_share)) {
    for (int c = 0; c < 3; ++c) ambient_[c] = set(row.ambient[c]);
    for (int layer = 0; layer < kLayers; ++layer) {
      light_[layer] = row.light[layer];
      mask_[layer] = row.mask[layer];
      above_[layer] = row.glow_above[layer];
      below_[layer] = row.glow_below[layer];
      for (int c = 0; c < 3; ++c) colour_[layer][c] = set(row.colour[layer][c]);
    }
  }

  /// From pixel x on. By reference: g++ 12 copies a struct of vectors through memory, by halves,
  /// and then waits for both to be written.
  HWY_INLINE void operator()(int x, Floats& red, Floats& green, Floats& blue) const {
    red = ambient_[0];
    green = ambient_[1];
    blue = ambient_[2];
#pragma GCC unroll 3
    for (int layer = 0; layer < kLayers; ++layer) {
      const Floats light = past_glass(layer, x);
      red = hn::MulAdd(light, colour_[layer][0], red);
      green = hn::MulAdd(light, colour_[layer][1], green);
      blue = hn::MulAdd(light, colour_[layer][2], blue);
    }
  }

 private:
  HWY_INLINE Floats past_glass(int layer, int x) const {
    const Floats light = hn::LoadU(d, light_[layer] + x);
    Floats glow = hn::Zero(d);
    if (kGlow) {
      const Floats above = hn::LoadU(d, above_[layer] + x);
      const Floats below = hn::LoadU(d, below_[layer] + x);
      glow = hn::MulAdd(hn::Sub(below, above), glow_share_, above);
    }
    if (!kMask) return kGlow ? hn::Add(light, glow) : light;
    const hn::Rebind<std::uint8_t, F> d8;
    const Floats open = hn::ConvertTo(d, hn::PromoteTo(di, hn::LoadU(d8, mask_[layer] + x)));
    return kGlow ? hn::MulAdd(light, open, glow) : hn::Mul(light, open);
  }

  const float *light_[kLayers], *above_[kLayers], *below_[kLayers];
  const std::uint8_t* mask_[kLayers];
  Floats glow_share_, ambient_[3], colour_[kLayers][3];
};

/// Tiles are narrow: too little of each row for the processor to see that they go on below.
HWY_INLINE void prefetch_row_below(const FinishRow& row, int n) {
  constexpr int kLine = 64;
  for (int x = 0; x < n; x += kLine / 4) __builtin_prefetch(row.out_below + x, 1);
  for (int layer = 0; layer < row.layers; ++layer) {
    if (row.mask_below[layer] == nullptr) continue;
    for (int x = 0; x < n + kLine; x += kLine) hwy::Prefetch(row.mask_below[layer] + x);
  }
}

template <typename Finish>
HWY_INLINE void StoreLight(const Finish& finish, int n, LinearRgb* out) {
  float* to = &out->r;
  HWY_ALIGN float tail[3 * kMostLanes];
  for (int x = 0; x < n; x += lanes()) {
    Floats red, green, blue;
    finish(x, red, green, blue);
    const int count = 3 * std::min(lanes(), n - x);
    if (count == 3 * lanes()) {
      hn::StoreInterleaved3(red, green, blue, d, to + 3 * x);
    } else {
      hn::StoreInterleaved3(red, green, blue, d, tail);
      std::copy_n(tail, count, to + 3 * x);
    }
  }
}

/// sRGB codes by a polynomial of degree 4 in the square root, within 0.2 codes, and the straight
/// line below; as integers in the lowest bits, which adding 2^23 makes of a float. Even powers need
/// not wait for the root.
HWY_INLINE Ints code_of(Floats x) {
  x = hn::Min(hn::Max(x, hn::Zero(d)), set(1.0f));
  const Floats even =
      hn::MulAdd(hn::MulAdd(set(-78.9393376f), x, set(-240.938121f)), x, set(-9.4361935f));
  const Floats odd = hn::MulAdd(set(214.909066f), x, set(369.214136f));
  const Floats curve = hn::MulAdd(odd, hn::Sqrt(x), even);
  const Floats straight = hn::Mul(x, set(12.92f * 255));
  const Floats code = hn::IfThenElse(hn::Lt(x, set(0.0031308f)), straight, curve);
  return hn::BitCast(di, hn::Add(code, set(8388608.0f)));
}
constexpr std::uint32_t kFloatBits = 0x4b000000u;  // of 2^23

template <typename Finish>
HWY_INLINE void StoreEncoded(const Finish& finish, int n, Srgb8* out) {
  std::int32_t* to = reinterpret_cast<std::int32_t*>(out);
  HWY_ALIGN std::int32_t tail[kMostLanes];
  // The red's float bits become the opaque alpha; green's and blue's are shifted out.
  const Ints opaque = hn::Set(di, static_cast<std::int32_t>(0xff000000u - kFloatBits));
  for (int x = 0; x < n; x += lanes()) {
    Floats red, green, blue;
    finish(x, red, green, blue);
    const Ints high = hn::Or(hn::ShiftLeft<8>(code_of(green)), hn::ShiftLeft<16>(code_of(blue)));
    const Ints packed = hn::Add(hn::Add(code_of(red), opaque), high);
    if (x + lanes() <= n) {
      hn::StoreU(packed, di, to + x);
    } else {
      hn::StoreU(packed, di, tail);
      std::copy_n(tail, n - x, to + x);
    }
  }
}

template <int kLayers, typename Body>
HWY_INLINE void with_finisher_of(const FinishRow& row, const Body& body) {
  const bool mask = row.mask[0] != nullptr, glow = row.glow_above[0] != nullptr;
  if (mask && glow) return body(Finisher<kLayers, true, true>(row));
  if (mask) return body(Finisher<kLayers, true, false>(row));
  if (glow) return body(Finisher<kLayers, false, true>(row));
  body(Finisher<kLayers, false, false>(row));
}

template <typename Body>
HWY_INLINE void with_finisher(const FinishRow& row, const Body& body) {
  switch (row.layers) {
    case 1:
      return with_finisher_of<1>(row, body);
    case 2:
      return with_finisher_of<2>(row, body);
    default:
      return with_finisher_of<3>(row, body);
  }
}

void FinishLight(const FinishRow& row, int n, LinearRgb* out) {
  with_finisher(row, [=](const auto& finish) { StoreLight(finish, n, out); });
}

void FinishEncoded(const FinishRow& row, int n, Srgb8* out) {
  prefetch_row_below(row, n);
  with_finisher(row, [=](const auto& finish) { StoreEncoded(finish, n, out); });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(FinishLight);
HWY_EXPORT(FinishEncoded);

void finish_light(const FinishRow& row, int n, LinearRgb* out) {
  HWY_DYNAMIC_DISPATCH(FinishLight)(row, n, out);
}

void finish_encoded(const FinishRow& row, int n, Srgb8* out) {
  HWY_DYNAMIC_DISPATCH(FinishEncoded)(row, n, out);
}

}  // namespace kinescope
#endif  // HWY_ONCE
