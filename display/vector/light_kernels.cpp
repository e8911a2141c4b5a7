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

bool FadeLight(float* sum, float* held, float lost, float left, float unseen, int floats) {
  const auto lost_share = hn::Set(d, lost), left_share = hn::Set(d, left);
  const auto least = hn::Set(d, unseen);
  auto any = hn::Zero(d);
  for (int i = 0; i < floats; i += static_cast<int>(hn::Lanes(d))) {
    const auto h = hn::LoadU(d, held + i);
    const auto s = hn::MulAdd(h, lost_share, hn::LoadU(d, sum + i));
    const auto stays = hn::IfThenElseZero(hn::Gt(h, least), hn::Mul(h, left_share));
    hn::StoreU(s, d, sum + i);
    hn::StoreU(stays, d, held + i);
    any = hn::Max(any, hn::Max(s, stays));
  }
  return hn::GetLane(hn::MaxOfLanes(d, any)) > 0;
}

void AddLight(float* light, const float* more, int floats) {
  for (int i = 0; i < floats; i += static_cast<int>(hn::Lanes(d))) {
    hn::StoreU(hn::Add(hn::LoadU(d, light + i), hn::LoadU(d, more + i)), d, light + i);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace kinescope
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(FadeLight);
HWY_EXPORT(AddLight);

bool fade_light(float* sum, float* held, float lost, float left, float unseen, int floats) {
  return HWY_DYNAMIC_DISPATCH(FadeLight)(sum, held, lost, left, unseen, floats);
}

void add_light(float* light, const float* more, int floats) {
  HWY_DYNAMIC_DISPATCH(AddLight)(light, more, floats);
}

}  // namespace kinescope
#endif  // HWY_ONCE
