// Pictures of a feed, read ahead on a thread of their own, so that a window never waits for them.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "demos/picture_feed.h"

namespace kinescope {

class ReadAhead : public PictureFeed {
 public:
  /// @param feed whose workers nobody else uses. @param most pictures that are kept at hand
  ReadAhead(std::unique_ptr<PictureFeed> feed, std::size_t most);
  /// Waits for nothing that has not come yet.
  ~ReadAhead() override;

  /// Waits for the picture if need be. Faults of the feed come in their turn.
  bool next(Image<Srgb8>& picture) override;
  void interrupt() override { feed_->interrupt(); }
  /// Whether next() would be answered that many times without waiting; of more than are ever kept,
  /// as many as are.
  bool at_hand(std::size_t count) const;

 private:
  void read();
  bool read_one(Image<Srgb8>& picture);

  std::unique_ptr<PictureFeed> feed_;
  std::size_t most_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Image<Srgb8>> ahead_;
  std::vector<Image<Srgb8>> spare_;  // memory of pictures that were taken
  bool ended_ = false;
  bool left_ = false;  // nobody wants more
  std::exception_ptr fault_;
  std::thread thread_;
};

}  // namespace kinescope
