// The boundary fill of textbooks, a pixel a call, to show why it is not used: its depth grows with
// the region's area, and pixels that already have the new colour stop it. Its calls are kept on a
// stack that can be seen, and that is as deep as is allowed.
// Source: D. Hearn and M. P. Baker, "Computer Graphics", 1986.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "raster/fill/span_fill.h"
#include "raster/image/image.h"

namespace kinescope {

/// fill(x, y): if the pixel is neither boundary nor painted, paint it and fill its neighbours.
template <typename Value>
class RecursiveFill {
 public:
  /// One call that has not returned.
  struct Call {
    glm::ivec2 at;
    int neighbour = 0;  ///< the next to be called for
  };

  /// @param most_calls  what the stack holds; beyond it the fill ends with overflowed()
  RecursiveFill(Image<Value>& image, int x, int y, const Value& boundary, const Value& colour,
                Connectivity connectivity, std::size_t most_calls)
      : image_(image),
        boundary_(boundary),
        colour_(colour),
        neighbours_(connectivity == Connectivity::kFour ? 4 : 8),
        most_calls_(most_calls),
        seed_(x, y) {}

  /// Runs until one more pixel is painted; false at the end, or when the stack is full.
  bool next() {
    if (!begun_) {
      begun_ = true;
      if (call(seed_)) return true;
    }
    while (!overflowed_ && !calls_.empty()) {
      Call& top = calls_.back();
      if (top.neighbour == neighbours_) {
        calls_.pop_back();
        continue;
      }
      const glm::ivec2 to = top.at + kAround[static_cast<std::size_t>(top.neighbour++)];
      if (call(to)) return true;
    }
    return false;
  }
  glm::ivec2 at() const { return at_; }  ///< the pixel painted last
  std::span<const Call> calls() const { return calls_; }
  std::size_t deepest() const { return deepest_; }
  bool overflowed() const { return overflowed_; }

 private:
  static constexpr std::array<glm::ivec2, 8> kAround{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};

  bool call(glm::ivec2 p) {
    if (!image_.contains(p.x, p.y)) return false;
    Value& pixel = image_.at(p.x, p.y);
    if (pixel == boundary_ || pixel == colour_) return false;
    if (calls_.size() == most_calls_) {
      overflowed_ = true;
      return false;
    }
    pixel = colour_;
    at_ = p;
    calls_.push_back({p});
    deepest_ = std::max(deepest_, calls_.size());
    return true;
  }

  Image<Value>& image_;
  Value boundary_, colour_;
  int neighbours_;
  std::size_t most_calls_, deepest_ = 0;
  glm::ivec2 seed_, at_{0};
  std::vector<Call> calls_;
  bool begun_ = false, overflowed_ = false;
};

}  // namespace kinescope
