// Escape times, several vectors of pixels at once: one alone would wait for its own
// multiplications.
#include <algorithm>
#include <array>

#include "engine/fractals/escape_time.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/fractals/escape_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

/// A vector of points on their way. Times are counted as doubles, which are whole to 2^53.
struct Points {
  V x, y, cx, cy, time;
  hn::Mask<D> alive;
};

HWY_INLINE void iterate(Points& p) {
  const D d;
  const V xx = hn::Mul(p.x, p.x), yy = hn::Mul(p.y, p.y), xy = hn::Mul(p.x, p.y);
  // Once out, out for good: what then overflows is not looked at.
  p.alive = hn::And(p.alive, hn::Le(hn::Add(xx, yy), hn::Set(d, 4.0)));
  p.time = hn::Add(p.time, hn::IfThenElseZero(p.alive, hn::Set(d, 1.0)));
  p.x = hn::Add(hn::Sub(xx, yy), p.cx);
  p.y = hn::Add(hn::Add(xy, xy), p.cy);
}

HWY_INLINE void iterate_all(Points& a, Points& b, Points& c, int most) {
  const D d;
  for (int n = 0; n < most; ++n) {
    iterate(a);
    iterate(b);
    iterate(c);
    if ((n & 3) == 3 && hn::AllFalse(d, hn::Or(hn::Or(a.alive, b.alive), c.alive))) break;
  }
}

HWY_INLINE Points start(const EscapeView& view, V column, double y) {
  const D d;
  const V x = hn::Add(hn::Set(d, view.centre.x), hn::Mul(hn::Set(d, view.step), column));
  Points p{hn::Zero(d), hn::Zero(d), x, hn::Set(d, y), hn::Zero(d), hn::Eq(x, x)};
  if (view.julia) {
    p.x = x;
    p.y = hn::Set(d, y);
    p.cx = hn::Set(d, view.julia->x);
    p.cy = hn::Set(d, view.julia->y);
  }
  return p;
}

void EscapeRow(const EscapeView& view, int j, std::int32_t* times) {
  const D d;
  const auto lanes = static_cast<int>(hn::Lanes(d));
  const double y = view.at(0, j).y;
  HWY_ALIGN std::array<double, 3 * HWY_MAX_BYTES / sizeof(double)> buffer;
  for (int i = 0; i < view.width; i += 3 * lanes) {
    std::array<Points, 3> p;
    for (int k = 0; k < 3; ++k) {
      const V column = hn::Iota(d, static_cast<double>(i + k * lanes - view.width / 2));
      p[static_cast<std::size_t>(k)] = start(view, column, y);
    }
    iterate_all(p[0], p[1], p[2], view.most);
    for (int k = 0; k < 3; ++k) {
      hn::Store(p[static_cast<std::size_t>(k)].time, d, buffer.data() + k * lanes);
    }
    const int count = std::min(3 * lanes, view.width - i);
    for (int k = 0; k < count; ++k) {
      times[i + k] = static_cast<std::int32_t>(buffer[static_cast<std::size_t>(k)]);
    }
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(EscapeRow);

void escape_row(const EscapeView& view, int j, std::int32_t* times) {
  HWY_DYNAMIC_DISPATCH(EscapeRow)(view, j, times);
}

}  // namespace kinescope
#endif
