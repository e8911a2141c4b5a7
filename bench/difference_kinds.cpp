#include "bench/difference_kinds.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "bench/peer_llvmpipe.h"
#include "bench/triangle_pass.h"
#include "engine/renderer.h"

namespace kinescope::bench {
namespace {

constexpr int kFrame = 10;
constexpr int kTolerance = 4;
/// A depth as far apart as the rounding of one interpolation in 32-bit floats.
constexpr float kDepthTie = 1e-6f;

bool differ(Linear8 a, Linear8 b, int tolerance) {
  return std::abs(a.r - b.r) > tolerance || std::abs(a.g - b.g) > tolerance ||
         std::abs(a.b - b.b) > tolerance;
}

std::uint32_t number_of(Linear8 c) {
  return static_cast<std::uint32_t>(c.r | c.g << 8 | c.b << 16);
}

/// Both sides of one frame.
struct Pictures {
  Image<Linear8> ours, peers;
  Image<Linear8> our_triangles, peer_triangles;
  Image<Linear8> our_numbers, centre_numbers;  ///< ours by number, at all samples and at one
};

Image<Linear8> draw_ours(const Workload& workload, const Camera& camera, int width, int height,
                         int samples) {
  Workers workers(2);
  Renderer renderer(workers);
  RenderTarget target(width, height, samples, ColourFormat::kLinear8);
  RenderSettings settings;
  settings.shading = workload.shading;
  renderer.render(workload.scene, camera, settings, target);
  return std::get<Image<Linear8>>(target.colour);
}

Image<Linear8> draw_peer(const Workload& workload, const Camera& camera, int width, int height,
                         int samples, std::optional<TriangleColours> triangles) {
  LlvmpipePeer peer(workload, width, height, samples, triangles);
  peer.draw(camera);
  return peer.picture();
}

/// Same triangles, other colours.
DifferenceKind shading_kind(const Workload& workload) {
  return workload.scene.materials[0].base_texture >= 0 ? DifferenceKind::kTexture
                                                       : DifferenceKind::kShading;
}

std::optional<DifferenceKind> kind_at_one_sample(const Workload& workload, const TrianglePass& pass,
                                                 const Pictures& p, int x, int y) {
  const std::uint32_t mine = number_of(p.our_triangles.at(x, y));
  const std::uint32_t theirs = number_of(p.peer_triangles.at(x, y));
  if (mine != theirs) {
    if (mine == 0 || theirs == 0) return DifferenceKind::kSilhouette;
    const TrianglePass::Meeting ours = pass.meet(mine - 1, x, y);
    const TrianglePass::Meeting other = pass.meet(theirs - 1, x, y);
    const bool tie = other.covered && std::abs(ours.depth - other.depth) < kDepthTie;
    return tie ? DifferenceKind::kDepthOrder : DifferenceKind::kSharedEdge;
  }
  if (!differ(p.ours.at(x, y), p.peers.at(x, y), kTolerance)) return std::nullopt;
  return shading_kind(workload);
}

/// Where the two sides show other triangles: how far the centre lies from the nearest edge of
/// either.
double edge_256ths(const TrianglePass& pass, const Pictures& p, int samples, int x, int y) {
  if (samples != 1) return 0;
  const std::uint32_t mine = number_of(p.our_triangles.at(x, y));
  const std::uint32_t theirs = number_of(p.peer_triangles.at(x, y));
  if (mine == theirs) return 0;
  double nearest = 1e9;
  for (const std::uint32_t number : {mine, theirs}) {
    if (number != 0) nearest = std::min(nearest, pass.meet(number - 1, x, y).edge_256ths);
  }
  return nearest;
}

std::optional<DifferenceKind> kind_at_many_samples(const Workload& workload, const Pictures& p,
                                                   int x, int y) {
  const Linear8 mine = p.our_triangles.at(x, y), theirs = p.peer_triangles.at(x, y);
  // A sample more or less is 64 codes of red; owners differ by more than the mean's rounding.
  if (std::abs(mine.r - theirs.r) > 2) return DifferenceKind::kSilhouette;
  if (differ(mine, theirs, 1)) return DifferenceKind::kOwners;
  if (!differ(p.ours.at(x, y), p.peers.at(x, y), kTolerance)) return std::nullopt;
  // One triangle at all samples: then it is the one at the centre, too.
  const std::uint32_t centre = number_of(p.centre_numbers.at(x, y));
  const bool whole = centre != 0 && centre == number_of(p.our_numbers.at(x, y)) &&
                     !differ(mine, colour_of_triangle(centre - 1, TriangleColours::kMixed), 1);
  return whole ? shading_kind(workload) : DifferenceKind::kMixedPixel;
}

}  // namespace

const char* name_of(DifferenceKind kind) {
  constexpr const char* kNames[] = {"silhouette",  "shared-edge", "depth-order", "owners",
                                    "mixed-pixel", "texture",     "shading"};
  return kNames[static_cast<std::size_t>(kind)];
}

DifferenceTable compare_with_peer(const Workload& workload, int width, int height, int samples,
                                  int examples) {
  const Camera camera =
      workload.camera(kFrame, static_cast<float>(width) / static_cast<float>(height));
  const TrianglePass pass(workload, camera, width, height);
  const auto colours = samples == 1 ? TriangleColours::kNumber : TriangleColours::kMixed;
  Pictures p{draw_ours(workload, camera, width, height, samples),
             draw_peer(workload, camera, width, height, samples, std::nullopt),
             pass.picture(samples, colours),
             draw_peer(workload, camera, width, height, samples, colours),
             pass.picture(samples, TriangleColours::kNumber),
             pass.picture(1, TriangleColours::kNumber)};
  DifferenceTable table;
  table.workload = workload.name;
  table.samples = samples;
  table.pixels = std::int64_t{width} * height;
  std::array<int, kDifferenceKinds> kept{};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto kind = samples == 1 ? kind_at_one_sample(workload, pass, p, x, y)
                                     : kind_at_many_samples(workload, p, x, y);
      if (!kind) continue;
      const auto at = static_cast<std::size_t>(*kind);
      table.farthest_256ths = std::max(table.farthest_256ths, edge_256ths(pass, p, samples, x, y));
      ++table.count[at].pixels;
      table.count[at].seen += differ(p.ours.at(x, y), p.peers.at(x, y), kTolerance);
      if (kept[at] >= examples) continue;
      ++kept[at];
      table.examples.push_back({*kind, x, y, p.ours.at(x, y), p.peers.at(x, y),
                                p.our_triangles.at(x, y), p.peer_triangles.at(x, y)});
    }
  }
  return table;
}

}  // namespace kinescope::bench
