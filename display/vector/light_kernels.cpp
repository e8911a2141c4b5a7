#include "display/vector/light_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/vector/light_kernels.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

constexpr hn::CappedTag<float, 16> d;

template <bool kMore>
bool fade(float* sum, float* held, const float* more, float lost, float left, float unseen,
          int floats) {
  const auto lost_share = hn::Set(d, lost), left_share = hn::Set(d, left);
  const auto least = hn::Set(d, unseen);
  auto any = hn::Zero(d);
  for (int i = 0; i < floats; i += static_cast<int>(hn::Lanes(d))) {
    const auto h = hn::LoadU(d, held + i);
    const auto s = hn::MulAdd(h, lost_share, hn::LoadU(d, sum + i));
    auto stays = hn::IfThenElseZero(hn::Gt(h, least), hn::Mul(h, left_share));
    if (kMore) stays = hn::Add(stays, hn::LoadU(d, more + i));
    hn::StoreU(s, d, sum + i);
    hn::StoreU(stays, d, held + i);
    any = hn::Max(any, hn::Max(s, stays));
  }
  return hn::GetLane(hn::MaxOfLanes(d, any)) > 0;
}

bool FadeLight(float* sum, float* held, const float* more, float lost, float left, float unseen,
               int floats) {
  return more != nullptr ? fade<true>(sum, held, more, lost, left, unseen, floats)
                         : fade<false>(sum, held, more, lost, left, unseen, floats);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(FadeLight);

bool fade_light(float* sum, float* held, const float* more, float lost, float left, float unseen,
                int floats) {
  return HWY_DYNAMIC_DISPATCH(FadeLight)(sum, held, more, lost, left, unseen, floats);
}

}  // namespace kinescope
#endif  // HWY_ONCE
