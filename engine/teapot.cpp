#include "engine/teapot.h"

#include <algorithm>

#include "engine/bezier_patch.h"
#include "engine/data/teapot_patches.h"

namespace kinescope {
namespace {

/// From Newell's axes, z up, to ours, y up: a turn about x.
glm::dvec3 y_up(glm::dvec3 p) { return {p.x, p.z, -p.y}; }

BezierPatch quarter(const teapot_data::RingPatch& rings) {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    const auto [radius, bulge, height] = rings[row];
    patch.point[row] = {y_up({radius, 0.0, height}), y_up({radius, -bulge, height}),
                        y_up({bulge, -radius, height}), y_up({0.0, -radius, height})};
  }
  return patch;
}

BezierPatch half_tube(const teapot_data::HalfTubePatch& half) {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    std::transform(half[row].begin(), half[row].end(), patch.point[row].begin(), y_up);
  }
  return patch;
}

/// Scales by -1 along axes. An odd number of them turns the patch inside out, so u runs backwards
/// then and the normal still points out.
BezierPatch mirrored(const BezierPatch& patch, glm::dvec3 signs) {
  BezierPatch result = patch;
  for (auto& row : result.point) {
    for (glm::dvec3& p : row) p *= signs;
    if (signs.x * signs.y * signs.z < 0.0) std::reverse(row.begin(), row.end());
  }
  return result;
}

/// Adds a patch's images as columns of one texture, which runs once around to the right and down.
template <std::size_t kParts, std::size_t kImages>
void add_column(const BezierPatch& patch, std::size_t part,
                const std::array<glm::dvec3, kImages>& images, int fineness, Mesh& mesh) {
  for (std::size_t i = 0; i < kImages; ++i) {
    // u of the patch runs to the left as seen from outside.
    const float width = 1.0f / static_cast<float>(kImages);
    const float height = 1.0f / static_cast<float>(kParts);
    const PatchTexcoords texcoords{
        {1.0f - static_cast<float>(i) * width, static_cast<float>(part) * height},
        {-width, height}};
    tessellate_patch(mirrored(patch, images[i]), fineness, texcoords, mesh);
  }
}

template <std::size_t kParts>
void add_revolved(const std::array<teapot_data::RingPatch, kParts>& parts, int fineness,
                  Mesh& mesh) {
  // Quarters in turn from +x over +z, -x and -z back to +x.
  constexpr std::array<glm::dvec3, 4> kImages{
      {{1.0, 1.0, 1.0}, {-1.0, 1.0, 1.0}, {-1.0, 1.0, -1.0}, {1.0, 1.0, -1.0}}};
  for (std::size_t part = 0; part < kParts; ++part) {
    add_column<kParts>(quarter(parts[part]), part, kImages, fineness, mesh);
  }
}

template <std::size_t kParts>
void add_tube(const std::array<teapot_data::HalfTubePatch, kParts>& parts, int fineness,
              Mesh& mesh) {
  constexpr std::array<glm::dvec3, 2> kImages{{{1.0, 1.0, 1.0}, {1.0, 1.0, -1.0}}};
  for (std::size_t part = 0; part < kParts; ++part) {
    add_column<kParts>(half_tube(parts[part]), part, kImages, fineness, mesh);
  }
}

}  // namespace

Mesh teapot_mesh(int fineness) {
  const int n = std::max(1, fineness);
  Mesh mesh;
  mesh.name = "teapot";
  add_revolved(teapot_data::kShell, n, mesh);
  add_revolved(teapot_data::kLid, n, mesh);
  add_tube(teapot_data::kHandle, n, mesh);
  add_tube(teapot_data::kSpout, n, mesh);
  return mesh;
}

}  // namespace kinescope
