// A conic followed from pixel to pixel by the side on which midpoints lie, octant by octant.
// Source: M. L. V. Pitteway, "Algorithm for drawing ellipses or hyperbolae with a digital plotter",
// 1967; the octant is taken from the gradient ahead of each pixel.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "raster/pixel_rect.h"
#include "raster/scan/conic.h"

namespace kinescope {

/// Walks along one branch, the side where the conic is negative on its left hand (x to the right, y
/// upwards), until it leaves the window or comes back to its start. As in every algorithm of this
/// kind the curve must not turn by more than an octant within a pixel.
class ConicTracer {
 public:
  /// @param start a pixel on the curve, such as ConicScan gives
  /// @param backwards walks the other way
  ConicTracer(const Conic& conic, const PixelRect& window, glm::ivec2 start, bool backwards = false)
      : conic_(conic), window_(window), start_(start), at_(start), backwards_(backwards) {}

  bool next();
  glm::ivec2 at() const { return at_; }
  glm::ivec2 axial() const { return axial_; }    ///< the step along the octant's axis just chosen
  glm::ivec2 aside() const { return aside_; }    ///< and the one across it
  double decision() const { return decision_; }  ///< the conic at the last midpoint
  bool closed() const { return closed_; }        ///< it came back

 private:
  glm::dvec2 tangent(glm::dvec2 p) const;
  bool inside() const {
    return at_.x >= window_.x0 && at_.x < window_.x1 && at_.y >= window_.y0 && at_.y < window_.y1;
  }

  Conic conic_;
  PixelRect window_;
  glm::ivec2 start_, second_{0}, at_, axial_{0}, aside_{0};
  bool backwards_, closed_ = false;
  std::int64_t steps_ = -1;
  double decision_ = 0;
};

template <typename Sink>
void trace_conic(const Conic& conic, const PixelRect& window, glm::ivec2 start, Sink&& sink) {
  for (ConicTracer tracer(conic, window, start); tracer.next();) {
    sink(tracer.at().x, tracer.at().y);
  }
}

}  // namespace kinescope
