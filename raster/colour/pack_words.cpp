#include "raster/colour/pack_words.h"

#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/colour/pack_words.cpp"
#include <hwy/foreach_target.h>  // compiles this file once a target
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

/// The pixels of whole vectors alone. @return how many
std::size_t pack_vectors(const Srgb8* in, std::size_t count, WordLayout layout,
                         std::uint32_t* out) {
  const hn::ScalableTag<std::uint32_t> d;
  const auto byte = hn::Set(d, 255u);
  const std::size_t step = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + step <= count; i += step) {
    const auto word = hn::LoadU(d, reinterpret_cast<const std::uint32_t*>(in + i));
    const auto r = hn::ShiftLeftSame(hn::And(word, byte), layout.r_shift);
    const auto g = hn::ShiftLeftSame(hn::And(hn::ShiftRight<8>(word), byte), layout.g_shift);
    const auto b = hn::ShiftLeftSame(hn::And(hn::ShiftRight<16>(word), byte), layout.b_shift);
    hn::StoreU(hn::Or(hn::Or(r, g), b), d, out + i);
  }
  return i;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(pack_vectors);

void pack_words(std::span<const Srgb8> in, WordLayout layout, std::span<std::uint32_t> out) {
  assert(out.size() >= in.size());
  std::size_t i = HWY_DYNAMIC_DISPATCH(pack_vectors)(in.data(), in.size(), layout, out.data());
  for (; i < in.size(); ++i) {
    out[i] = static_cast<std::uint32_t>(in[i].r) << layout.r_shift |
             static_cast<std::uint32_t>(in[i].g) << layout.g_shift |
             static_cast<std::uint32_t>(in[i].b) << layout.b_shift;
  }
}

}  // namespace kinescope
#endif
