// stroke-dasharray. Source: SVG 1.1, 11.4.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "display/vector/input/svg_style.h"

namespace kinescope {

/// Breaks lines by stroke-dasharray.
class SvgDashes {
 public:
  SvgDashes(const SvgStyle& style, float scale)
      : lengths_(style.dashes), offset_(style.dash_offset) {
    float least = HUGE_VALF;
    for (float& length : lengths_) {
      length *= scale;
      total_ += length;
      least = std::min(least, length);
    }
    // Dashes too fine to be seen, or too many for any use.
    if (total_ < 0.1f || !style.has_stroke) lengths_.clear();
    offset_ *= scale;
    restart();
  }
  void restart() {
    if (lengths_.empty()) return;
    float left = std::fmod(offset_, total_);
    if (left < 0) left += total_;
    at_ = 0;
    for (std::size_t i = 0; i < lengths_.size() && left >= lengths_[at_]; ++i) {
      left -= lengths_[at_];
      at_ = (at_ + 1) % lengths_.size();
    }
    left_ = lengths_[at_] - left;
  }
  template <typename Sink>
  void line(glm::vec2 from, glm::vec2 to, Sink&& sink) {
    const float length = glm::length(to - from);
    if (lengths_.empty() || !(length > 0) || length > 1e5f * total_) return sink(from, to);
    for (float done = 0; done < length;) {
      const float next = std::min(length, done + left_);
      const glm::vec2 step = (to - from) / length;
      if (at_ % 2 == 0 && next > done) sink(from + done * step, from + next * step);
      left_ -= next - done;
      done = next;
      if (done >= length) return;
      do {
        at_ = (at_ + 1) % lengths_.size();
        left_ = lengths_[at_];
      } while (left_ == 0);
    }
  }

 private:
  std::vector<float> lengths_;
  float offset_, total_ = 0, left_ = 0;
  std::size_t at_ = 0;
};

}  // namespace kinescope
