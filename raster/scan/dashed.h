// Dashes for any algorithm that yields a line's or curve's pixels in order.
// Source: J. D. Foley et al., "Computer Graphics: Principles and Practice", 1990, line styles.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace kinescope {

/// A pattern of lengths in pixels along the curve, on and off in turn from the first. Lengths that
/// are not positive count as 0; a pattern whose lengths add up to nothing is solid.
class DashPattern {
 public:
  /// @param phase pixels into the pattern at the start; negative ones begin before it
  explicit DashPattern(std::vector<int> lengths, std::int64_t phase = 0)
      : lengths_(std::move(lengths)) {
    for (int& length : lengths_) length = length > 0 ? length : 0;
    if (lengths_.size() % 2) {  // on and off change places with each repeat
      const std::vector<int> again = lengths_;
      lengths_.insert(lengths_.end(), again.begin(), again.end());
    }
    total_ = std::accumulate(lengths_.begin(), lengths_.end(), std::int64_t{0});
    if (total_ == 0) return;
    left_ = -((phase % total_ + total_) % total_);
    place_ = lengths_.size() - 1;
    settle();
  }

  /// Whether the next pixel is on.
  bool next() {
    if (total_ == 0) return true;
    const bool on = place_ % 2 == 0;
    --left_;
    if (left_ == 0) settle();
    return on;
  }
  std::size_t dash() const { return place_; }  ///< which length the next pixel belongs to
  std::int64_t left() const { return left_; }  ///< pixels left of it

 private:
  void settle() {
    while (left_ <= 0) {
      place_ = place_ + 1 < lengths_.size() ? place_ + 1 : 0;
      left_ += lengths_[place_];
    }
  }

  std::vector<int> lengths_;
  std::int64_t total_ = 0, left_ = 0;
  std::size_t place_ = 0;
};

/// Hands on the points that are on.
template <typename Sink>
class DashedSink {
 public:
  DashedSink(DashPattern& pattern, Sink& sink) : pattern_(pattern), sink_(sink) {}
  void operator()(int x, int y) const {
    if (pattern_.next()) sink_(x, y);
  }

 private:
  DashPattern& pattern_;
  Sink& sink_;
};

}  // namespace kinescope
