// A feed whose pictures tell their number.
#pragma once

#include "demos/picture_feed.h"

namespace kinescope {

/// Pictures whose grey is their number, times a step, from a first one on.
class CountingFeed : public PictureFeed {
 public:
  CountingFeed(int count, Size size, bool still = false, int step = 1, int first = 0)
      : count_(count), step_(step), first_(first) {
    facts_.size = size;
    facts_.still = still;
  }
  bool next(Image<Srgb8>& picture) override {
    if (shown_ == count_) return false;
    const auto grey = static_cast<std::uint8_t>(first_ + step_ * shown_++);
    picture = Image<Srgb8>(facts_.size.width, facts_.size.height, {grey, grey, grey, 255});
    return true;
  }

 private:
  int count_, step_, first_, shown_ = 0;
};

}  // namespace kinescope
