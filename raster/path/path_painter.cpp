#include "raster/path/path_painter.h"

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

constexpr int kBandRows = 64;
constexpr std::size_t kChunkPaths = 16;

/// The smallest box around finite points.
class Bounds {
 public:
  void add(glm::vec2 p) {
    // A comparison with what is not a number is false, so it is left out.
    if (p.x < low.x) low.x = p.x;
    if (p.x > high.x) high.x = p.x;
    if (p.y < low.y) low.y = p.y;
    if (p.y > high.y) high.y = p.y;
  }
  glm::vec2 low{INFINITY}, high{-INFINITY};
};

int pixel(float x, int size) {
  return static_cast<int>(std::clamp(x, 0.0f, static_cast<float>(size)));
}

}  // namespace

PathPainter::PathPainter(Workers& workers)
    : workers_(workers), areas_(static_cast<std::size_t>(workers.count())) {}

void PathPainter::flatten(std::span<const FilledPath> paths, float tolerance_px, int width,
                          int height) {
  const std::size_t chunks = (paths.size() + kChunkPaths - 1) / kChunkPaths;
  chunks_.resize(chunks);
  outlines_.resize(paths.size());
  workers_.run(static_cast<int>(chunks), [&](int task, int) {
    std::vector<Edge>& edges = chunks_[static_cast<std::size_t>(task)].edges;
    edges.clear();
    const std::size_t begin = static_cast<std::size_t>(task) * kChunkPaths;
    for (std::size_t i = begin; i < std::min(begin + kChunkPaths, paths.size()); ++i) {
      Bounds bounds;
      const std::size_t first = edges.size();
      path_edges(*paths[i].path, paths[i].place, tolerance_px, [&](glm::vec2 a, glm::vec2 b) {
        bounds.add(a);
        bounds.add(b);
        edges.push_back({a, b});
      });
      outlines_[i] = {pixel(std::floor(bounds.low.x), width),
                      pixel(std::floor(bounds.low.y), height),
                      pixel(std::ceil(bounds.high.x), width),
                      pixel(std::ceil(bounds.high.y), height),
                      first,
                      edges.size()};
    }
  });
}

void PathPainter::gather(const Outline& outline, std::span<const Edge> edges, int y_begin,
                         int y_end, ExactArea& area) const {
  area.reset(outline.x_end - outline.x_begin, y_end - y_begin);
  const glm::dvec2 corner(outline.x_begin, y_begin);
  const auto top = static_cast<float>(y_begin), bottom = static_cast<float>(y_end);
  for (const Edge& edge : edges) {
    if (std::max(edge.from.y, edge.to.y) <= top || std::min(edge.from.y, edge.to.y) >= bottom) {
      continue;
    }
    area.add_edge(glm::dvec2(edge.from) - corner, glm::dvec2(edge.to) - corner);
  }
}

template <typename Pixel>
void PathPainter::draw_any(std::span<const FilledPath> paths, float tolerance_px,
                           Image<Pixel>& picture) {
  flatten(paths, tolerance_px, picture.width(), picture.height());
  const int bands = (picture.height() + kBandRows - 1) / kBandRows;
  workers_.run(bands, [&](int band, int worker) {
    ExactArea& area = areas_[static_cast<std::size_t>(worker)];
    const int band_end = std::min((band + 1) * kBandRows, picture.height());
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const Outline& outline = outlines_[i];
      const int y_begin = std::max(outline.y_begin, band * kBandRows);
      const int y_end = std::min(outline.y_end, band_end);
      if (y_begin >= y_end || outline.x_begin >= outline.x_end) continue;
      const std::span<const Edge> edges = chunks_[i / kChunkPaths].edges;
      gather(outline, edges.subspan(outline.first, outline.last - outline.first), y_begin, y_end,
             area);
      fill_area(area, paths[i].rule, paths[i].ink, outline.x_begin, y_begin, picture);
    }
  });
}

void PathPainter::draw(std::span<const FilledPath> paths, float tolerance_px,
                       Image<Linear8>& picture) {
  draw_any(paths, tolerance_px, picture);
}

void PathPainter::draw(std::span<const FilledPath> paths, float tolerance_px,
                       Image<LinearRgba>& picture) {
  draw_any(paths, tolerance_px, picture);
}

}  // namespace kinescope
