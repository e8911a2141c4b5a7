#include "raster/scan/midpoint_ellipse.h"

namespace kinescope {

bool MidpointEllipse::next() {
  if (a_ < 0 || b_ < 0) return false;
  if (x_ < 0) {
    x_ = 0;
    return true;
  }
  if (y_ == 0) {  // the tip of a flat ellipse, where no midpoint lies between rows
    ++x_;
    return x_ <= a_;
  }
  const std::int64_t aa = a_ * a_, bb = b_ * b_;
  if (!steep_ && 2 * bb * (x_ + 1) >= aa * (2 * y_ - 1)) {
    steep_ = true;
    decision_ += aa * (3 - 4 * y_) - bb * (4 * x_ + 3);
  }
  const bool inside = decision_ < 0;
  if (!steep_ || inside) ++x_;
  if (steep_ || !inside) --y_;
  if (!steep_) {
    decision_ += 4 * bb * (2 * x_ + 1) - (inside ? 0 : 8 * aa * y_);
  } else {
    decision_ += 4 * aa * (1 - 2 * y_) + (inside ? 8 * bb * x_ : 0);
  }
  return true;
}

}  // namespace kinescope
