#include "demos/read_ahead.h"

#include <algorithm>
#include <utility>

namespace kinescope {

ReadAhead::ReadAhead(std::unique_ptr<PictureFeed> feed, std::size_t most)
    : feed_(std::move(feed)), most_(most) {
  facts_ = feed_->facts();
  thread_ = std::thread([this] { read(); });
}

ReadAhead::~ReadAhead() {
  {
    const std::lock_guard lock(mutex_);
    left_ = true;
  }
  changed_.notify_all();
  feed_->interrupt();
  thread_.join();
}

/// @return false at the end, in whichever way the feed came to it
bool ReadAhead::read_one(Image<Srgb8>& picture) {
  try {
    return feed_->next(picture);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    fault_ = std::current_exception();
    return false;
  }
}

void ReadAhead::read() {
  for (;;) {
    Image<Srgb8> picture;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return left_ || ahead_.size() < most_; });
      if (left_) return;
      if (!spare_.empty()) {
        picture = std::move(spare_.back());
        spare_.pop_back();
      }
    }
    const bool came = read_one(picture);
    {
      const std::lock_guard lock(mutex_);
      if (came) ahead_.push_back(std::move(picture));
      if (!came) ended_ = true;
    }
    changed_.notify_all();
    if (!came) return;
  }
}

bool ReadAhead::next(Image<Srgb8>& picture) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return ended_ || !ahead_.empty(); });
  if (ahead_.empty()) {
    if (fault_) std::rethrow_exception(std::exchange(fault_, nullptr));
    return false;
  }
  std::swap(picture, ahead_.front());
  if (spare_.size() < most_) spare_.push_back(std::move(ahead_.front()));
  ahead_.pop_front();
  lock.unlock();
  changed_.notify_all();
  return true;
}

bool ReadAhead::at_hand(std::size_t count) const {
  const std::lock_guard lock(mutex_);
  return ended_ || ahead_.size() >= std::min(count, most_);
}

}  // namespace kinescope
