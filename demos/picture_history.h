// The last pictures that were shown, so that a user can step back to them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>

#include "raster/base/units.h"
#include "raster/image/image.h"

namespace kinescope {

class PictureHistory {
 public:
  /// @param bytes that the pictures may take; two are kept even if they are larger
  explicit PictureHistory(std::size_t bytes) : bytes_(bytes) {}

  /// Shows a new picture, after all others.
  void add(const Image<Srgb8>& picture, Seconds time) {
    const std::size_t one = picture.pixels().size() * sizeof(Srgb8);
    const std::size_t most = std::max<std::size_t>(2, bytes_ / std::max<std::size_t>(1, one));
    Shown next;
    if (shown_.size() >= most) {  // its memory is used again
      next = std::move(shown_.front());
      shown_.pop_front();
    }
    next.picture = picture;
    next.time = time;
    shown_.push_back(std::move(next));
    at_ = shown_.size() - 1;
  }
  /// @return false if no older, or newer, picture is kept
  bool back() { return at_ > 0 && (--at_, true); }
  bool forward() { return at_ + 1 < shown_.size() && (++at_, true); }
  void clear() { shown_.clear(), at_ = 0; }

  bool at_end() const { return at_ + 1 >= shown_.size(); }
  bool empty() const { return shown_.empty(); }
  std::size_t size() const { return shown_.size(); }
  const Image<Srgb8>& picture() const { return shown_[at_].picture; }
  Seconds time() const { return shown_[at_].time; }

 private:
  struct Shown {
    Image<Srgb8> picture;
    Seconds time{0};
  };
  std::size_t bytes_;
  std::deque<Shown> shown_;
  std::size_t at_ = 0;
};

}  // namespace kinescope
