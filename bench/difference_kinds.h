// Why a pixel of ours is not the peer's.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/workloads.h"

namespace kinescope::bench {

enum class DifferenceKind {
  kSilhouette,  ///< one shows a triangle where the other shows the background (in a sample)
  kSharedEdge,  ///< another triangle, which in ours does not cover the sample
  kDepthOrder,  ///< another triangle, which in ours lies within kDepthTie of the one that shows
  kOwners,      ///< several samples: the same coverage by other triangles (an edge or a depth)
  kMixedPixel,  ///< several samples, the same triangles, another colour, cut by an edge
  kTexture,     ///< the same triangle, another colour, textured
  kShading,     ///< the same triangle, another colour
};
inline constexpr std::size_t kDifferenceKinds = 7;
const char* name_of(DifferenceKind kind);

struct DifferenceCount {
  std::int64_t pixels = 0;
  std::int64_t seen = 0;  ///< of these, more than 4 codes apart in a channel
};

/// A pixel to look at.
struct DifferingPixel {
  DifferenceKind kind;
  int x, y;
  Linear8 ours, peers;
  Linear8 our_triangle, peer_triangle;  ///< as TriangleColours says
};

struct DifferenceTable {
  std::string workload;
  int samples = 1;
  std::int64_t pixels = 0;  ///< of the picture
  std::array<DifferenceCount, kDifferenceKinds> count{};
  /// At one sample: of the pixels that show another triangle, the most that a centre lies away from
  /// the nearest edge of the two triangles.
  double farthest_256ths = 0;
  std::vector<DifferingPixel> examples;
};

/// Draws one frame of a workload on both sides, with its colours and with its triangles' numbers.
/// @param examples how many pixels of each kind to keep
DifferenceTable compare_with_peer(const Workload& workload, int width, int height, int samples,
                                  int examples);

}  // namespace kinescope::bench
