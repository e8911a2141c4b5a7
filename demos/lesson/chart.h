// Figures drawn as curves in a lesson's pane: axes, and lines of points.
#pragma once

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"

namespace kinescope {

/// Where numbers lie in a pane: the rectangle low to high fills most of it, y upwards.
class Chart {
 public:
  Chart(const World& world, const glm::dvec2& low, const glm::dvec2& high)
      : size_(world.columns(), world.rows()), low_(low), extent_(high - low) {
    if (!(extent_.x > 0)) extent_.x = 1;
    if (!(extent_.y > 0)) extent_.y = 1;
  }
  glm::dvec2 place(const glm::dvec2& p) const {
    const glm::dvec2 share = kMargin + (1 - 2 * kMargin) * (p - low_) / extent_;
    return size_ * glm::dvec2(share.x, 1 - share.y);
  }
  /// The lines x = `at`.x and y = `at`.y.
  void axes(Course& course, int pane, const glm::dvec2& at = glm::dvec2(0)) const {
    const glm::dvec2 high = low_ + extent_;
    course.guides.push_back(
        {place({low_.x, at.y}), place({high.x, at.y}), theme::with_alpha(theme::kDim, 110), pane});
    course.guides.push_back(
        {place({at.x, low_.y}), place({at.x, high.y}), theme::with_alpha(theme::kDim, 110), pane});
  }

 private:
  static constexpr double kMargin = 0.1;
  glm::dvec2 size_, low_, extent_;
};

/// A line drawn point by point.
class InkPen {
 public:
  explicit InkPen(Srgb8 colour) : colour_(colour) {}
  void to(Track& track, const World& world, const glm::dvec2& p) {
    ink_line(track, world, down_ ? last_ : p, p, colour_);
    last_ = p;
    down_ = true;
  }
  void lift() { down_ = false; }

 private:
  Srgb8 colour_;
  glm::dvec2 last_{0};
  bool down_ = false;
};

/// Guides from point to point.
inline void guide_chain(Course& course, std::span<const glm::dvec2> points, Srgb8 colour,
                        int pane = -1) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    course.guides.push_back({points[i], points[i + 1], colour, pane});
  }
}

/// The outline of a rectangle by two opposite corners.
inline void guide_rectangle(Course& course, const glm::dvec2& low, const glm::dvec2& high,
                            Srgb8 colour, int pane = -1) {
  const std::array<glm::dvec2, 5> corners = {{low, {high.x, low.y}, high, {low.x, high.y}, low}};
  guide_chain(course, corners, colour, pane);
}

inline constexpr std::array kChartInks = {theme::kText,  theme::kAccent, theme::kCool,
                                          theme::kGreen, theme::kRed,    theme::kBlue};

/// A pen for each of so many curves, the inks over again.
inline std::vector<InkPen> chart_pens(std::size_t count) {
  std::vector<InkPen> pens;
  for (std::size_t i = 0; i < count; ++i) pens.emplace_back(kChartInks[i % kChartInks.size()]);
  return pens;
}

}  // namespace kinescope
