// Whole drawings of filled paths onto a picture, on all workers.
#pragma once

#include <span>
#include <vector>

#include "raster/base/workers.h"
#include "raster/path/fill_kernel.h"
#include "raster/path/path.h"

namespace kinescope {

/// A path, where it lies and what fills it.
struct FilledPath {
  const Path* path = nullptr;
  PixelsFromPath place{1, 0, 0, 1, 0, 0};
  FillRule rule = FillRule::kNonZero;
  Ink ink{};
};

/// Fills paths in the order given, each pixel's share by exact area: the picture is the same for
/// any number of workers and any instruction set. Keeps its memory from call to call.
class PathPainter {
 public:
  explicit PathPainter(Workers& workers);

  /// @param tolerance_px  how far curves may lie from their chords
  void draw(std::span<const FilledPath> paths, float tolerance_px, Image<Linear8>& picture);
  void draw(std::span<const FilledPath> paths, float tolerance_px, Image<LinearRgba>& picture);

 private:
  struct Edge {
    glm::vec2 from, to;
  };
  /// The edges of some paths, one path after another.
  struct Chunk {
    std::vector<Edge> edges;
  };
  /// Pixels that a path may touch, cut to the picture, and its edges.
  struct Outline {
    int x_begin = 0, y_begin = 0, x_end = 0, y_end = 0;
    std::size_t first = 0, last = 0;
  };

  template <typename Pixel>
  void draw_any(std::span<const FilledPath> paths, float tolerance_px, Image<Pixel>& picture);
  void flatten(std::span<const FilledPath> paths, float tolerance_px, int width, int height);
  void gather(const Outline& outline, std::span<const Edge> edges, int y_begin, int y_end,
              ExactArea& area) const;

  Workers& workers_;
  std::vector<Chunk> chunks_;
  std::vector<Outline> outlines_;
  std::vector<ExactArea> areas_;  // a worker each
};

}  // namespace kinescope
