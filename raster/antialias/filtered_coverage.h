// Anti-aliasing by filtering: coverage weighted by a kernel wider than the pixel, before sampling.
// Source: E. A. Feibush, M. Levoy and R. L. Cook, "Synthetic texturing using digital filters",
// 1980.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "raster/fill/scanline_fill.h"

namespace kinescope {

/// Separable kernels about a pixel's centre; each adds up to 1.
enum class CoverageFilter {
  kBox,       ///< one pixel wide: the area
  kTent,      ///< two pixels wide
  kGaussian,  ///< sigma 1/2, cut at 3/2 pixel
};

inline double filter_reach(CoverageFilter filter) {
  return filter == CoverageFilter::kBox ? 0.5 : filter == CoverageFilter::kTent ? 1.0 : 1.5;
}

/// The kernel's share left of t, pixels from the centre.
inline double filter_share(CoverageFilter filter, double t) {
  const double reach = filter_reach(filter);
  t = std::clamp(t, -reach, reach);
  switch (filter) {
    case CoverageFilter::kBox:
      return t + 0.5;
    case CoverageFilter::kTent:
      return t < 0 ? (1 + t) * (1 + t) / 2 : 1 - (1 - t) * (1 - t) / 2;
    case CoverageFilter::kGaussian:
      break;
  }
  const double whole = std::erf(reach * std::sqrt(2.0));
  return (std::erf(t * std::sqrt(2.0)) / whole + 1) / 2;
}

/// Calls sink(x, y, weight) for each pixel of the window that the kernel's reach brings ink to.
/// Along x and y the polygon is sampled `n` times a pixel, 1 to 64 (clamped); the kernel is exact.
template <typename Sink>
void filtered_coverage(const Polygon& polygon, FillRule rule, const PixelRect& window,
                       CoverageFilter filter, int n, Sink&& sink) {
  if (window.empty()) return;
  n = std::clamp(n, 1, 64);
  const double reach = filter_reach(filter);
  const int margin = static_cast<int>(std::ceil(reach));
  Polygon large = polygon;
  for (Contour& contour : large) {
    for (glm::dvec2& corner : contour) corner *= n;
  }
  ScanlineFill fill({(window.x0 - margin) * n, (window.y0 - margin) * n, (window.x1 + margin) * n,
                     (window.y1 + margin) * n},
                    rule);
  fill.add(large);
  const auto width = static_cast<std::size_t>(window.x1 - window.x0);
  std::vector<double> sums(width * static_cast<std::size_t>(window.y1 - window.y0));
  const auto pixels = [&](double begin, double end, int low, int high, auto&& body) {
    const int first = std::max(static_cast<int>(std::floor(begin - 0.5 - reach)), low);
    const int last = std::min(static_cast<int>(std::ceil(end - 0.5 + reach)), high - 1);
    for (int i = first; i <= last; ++i) {
      const double share =
          filter_share(filter, end - i - 0.5) - filter_share(filter, begin - i - 0.5);
      if (share > 0) body(i, share);
    }
  };
  while (fill.next()) {
    const double top = double(fill.y()) / n, bottom = double(fill.y() + 1) / n;
    for (const RowSpan& span : fill.spans()) {
      pixels(top, bottom, window.y0, window.y1, [&](int y, double down) {
        double* row = sums.data() + static_cast<std::size_t>(y - window.y0) * width;
        pixels(double(span.x_begin) / n, double(span.x_end) / n, window.x0, window.x1,
               [&](int x, double along) { row[x - window.x0] += down * along; });
      });
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (sums[i] <= 0) continue;
    sink(window.x0 + static_cast<int>(i % width), window.y0 + static_cast<int>(i / width),
         static_cast<float>(sums[i]));
  }
}

}  // namespace kinescope
