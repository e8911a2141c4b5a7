#include "engine/wireframe.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <set>

#include "engine/figures/beams.h"
#include "engine/framing.h"
#include "engine/renderer.h"
#include "engine/teapot.h"

namespace kinescope {
namespace {

TEST(ThreeBeams, AreClosedAndFaceOutwards) {
  const Mesh mesh = three_beams();
  ASSERT_EQ(mesh.positions.size(), 24u);
  ASSERT_EQ(mesh.indices.size(), 108u);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  double volume = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    std::array<glm::dvec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.indices[t + k], b = mesh.indices[t + (k + 1) % 3];
      EXPECT_TRUE(edges.insert({a, b}).second) << "an edge is passed once each way";
      p[k] = glm::dvec3(mesh.positions[a]);
    }
    volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6;
  }
  for (const auto& [a, b] : edges) EXPECT_TRUE(edges.count({b, a}));
  EXPECT_NEAR(volume, 3 * 2.2 * 0.44 * 0.44, 1e-5);
}

TEST(MeshEdges, EachEdgeOnce) {
  // A tetrahedron has six edges; its base is given twice, once turned over; one corner repeats.
  const std::vector<std::uint32_t> indices{0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0, 2, 1, 0, 3, 3, 0};
  const std::vector<Edge> want{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  EXPECT_EQ(unique_edges(indices), want);
  EXPECT_TRUE(unique_edges({}).empty());
}

TEST(DepthPull, BringsALineNearerByAFractionOfItsDistance) {
  Camera camera;
  camera.near_plane = 0.5f;
  camera.far_plane = 200.0f;
  const DepthPull pull = depth_pull(camera);
  const glm::mat4 clip = camera.clip_from_view();
  const auto depth = [&](double distance) {
    return (clip[2][2] * -distance + clip[3][2]) / distance;
  };
  for (const double distance : {1.0, 10.0, 150.0}) {
    const double pulled = depth(distance) * pull.gain - pull.offset;
    EXPECT_NEAR(pulled, depth(distance / 1.003), 1e-6);
  }
}

/// A unit square in the plane z = 0, seen from the front by a camera that maps it to pixels
/// (20, 20)-(80, 80) of 100 x 100.
struct Square {
  Scene scene;
  Camera camera;
  Square() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = 0;
    scene.meshes.push_back(mesh);
    scene.nodes.push_back({"", -1, glm::mat4(1.0f), {0}});
    scene.materials.emplace_back().base_colour = {1, 0, 0};
    camera.projection = Projection::kOrthographic;
    camera.eye = {0, 0, 1};
    camera.look_at = {0, 0, 0};
    camera.window_min = glm::vec2(-1.0f / 3);
    camera.window_max = glm::vec2(4.0f / 3);
    camera.far_plane = 10.0f;
  }
};

struct Drawn {
  Image<LinearRgba> pixels;
  RenderStats stats;
  bool lit(int x, int y) const { return pixels.at(x, y).r > 0.5f; }
  int count() const {
    int n = 0;
    for (const LinearRgba& p : pixels.pixels()) n += p.r > 0.5f;
    return n;
  }
};

Drawn draw(const Scene& scene, const Camera& camera, const RenderSettings& settings,
           int width = 100, int height = 100) {
  Workers workers(2);
  Renderer renderer(workers);
  RenderTarget target(width, height, 1, ColourFormat::kLinearFloat);
  const RenderStats stats = renderer.render(scene, camera, settings, target);
  return {std::get<Image<LinearRgba>>(target.colour), stats};
}

RenderSettings wires(float width_px = 1.0f) {
  RenderSettings settings;
  settings.wireframe = true;
  settings.wire_width_px = width_px;
  return settings;
}

TEST(Wireframe, DrawsEdgesOfTheAskedWidth) {
  const Square square;
  const Drawn p = draw(square.scene, square.camera, wires(4.0f));
  EXPECT_EQ(p.stats.raster.triangles, 10u);  // five edges
  // Across the left edge at x = 20, away from the diagonal.
  for (int x = 10; x < 32; ++x) EXPECT_EQ(p.lit(x, 40), x >= 18 && x < 22) << x;
  // Along the diagonal from (20, 80) to (80, 20).
  for (int i = 25; i < 76; ++i) EXPECT_TRUE(p.lit(i, 100 - i) && p.lit(i, 99 - i)) << i;
  EXPECT_FALSE(p.lit(60, 70));
  // Corners close: the square's outermost pixel is drawn.
  EXPECT_TRUE(p.lit(18, 18) && p.lit(81, 81) && !p.lit(17, 18) && !p.lit(82, 81));
}

TEST(Wireframe, AOnePixelLineHasNoGaps) {
  const Square square;
  const Drawn p = draw(square.scene, square.camera, wires());
  for (int i = 20; i < 80; ++i) {
    EXPECT_TRUE(p.lit(i, 19) || p.lit(i, 20));
    EXPECT_TRUE(p.lit(79, i) || p.lit(80, i));
  }
}

TEST(Wireframe, CutsWhatLeavesTheView) {
  Square square;
  // A million times larger: only the edges through the picture are left.
  square.scene.nodes[0].parent_from_local =
      glm::scale(glm::translate(glm::mat4(1.0f), {0.5f, 0, 0}), glm::vec3(1e6f));
  const Drawn p = draw(square.scene, square.camera, wires(2.0f));
  for (int y = 0; y < 79; ++y) {
    EXPECT_TRUE(p.lit(49, y) && p.lit(50, y)) << y;
    EXPECT_FALSE(p.lit(30, y)) << y;
  }
  for (int x = 51; x < 100; ++x) EXPECT_TRUE(p.lit(x, 79) && p.lit(x, 80)) << x;
}

TEST(Wireframe, EdgesFromBehindTheEyeAreCutAtTheNearPlane) {
  Square square;
  square.scene.meshes[0].positions = {
      {0.1f, -1, 100}, {0.1f, -1, -100}, {0.1f, -1, -100}, {0.1f, -1, 100}};
  square.camera = Camera{};
  square.camera.eye = {0, 0, 0};
  square.camera.look_at = {0, 0, -1};
  const Drawn p = draw(square.scene, square.camera, wires(2.0f));
  // The line runs towards the vanishing point in the middle, from below.
  EXPECT_TRUE(p.lit(54, 99) || p.lit(55, 99));
  EXPECT_GT(p.count(), 60);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 100; ++x) EXPECT_FALSE(p.lit(x, y));
  }
}

TEST(Wireframe, PointsAreSquares) {
  Square square;
  RenderSettings settings;
  settings.points = true;
  settings.point_size_px = 4.0f;
  const Drawn p = draw(square.scene, square.camera, settings);
  EXPECT_EQ(p.count(), 4 * 16);
  for (const int x : {18, 21, 78, 81}) EXPECT_TRUE(p.lit(x, 21) && p.lit(x, 78));
}

TEST(Wireframe, HiddenLinesAreHidden) {
  Square square;
  // Two more squares behind, one covered by the first, one beside it.
  square.scene.meshes.push_back(square.scene.meshes[0]);
  square.scene.nodes.push_back(
      {"",
       -1,
       glm::scale(glm::translate(glm::mat4(1.0f), {0.25f, 0.25f, -2}), glm::vec3(0.5f)),
       {1}});
  const Drawn seen = draw(square.scene, square.camera, wires(2.0f));
  RenderSettings hidden = wires(2.0f);
  hidden.hidden_wire = true;
  const Drawn p = draw(square.scene, square.camera, hidden);
  EXPECT_TRUE(seen.lit(35, 40));
  EXPECT_FALSE(p.lit(35, 40));
  // The nearer square's own lines are whole.
  square.scene.nodes.pop_back();
  EXPECT_EQ(p.count(), draw(square.scene, square.camera, wires(2.0f)).count());
}

TEST(Wireframe, HiddenLinesOfACurvedBodyAreNotEatenByIt) {
  Scene scene;
  scene.meshes.push_back(teapot_mesh(4));
  scene.nodes.push_back({"", -1, glm::mat4(1.0f), {0}});
  scene.materials.emplace_back().base_colour = glm::vec3(1.0f);
  scene.meshes[0].material = 0;
  const Camera camera = frame_scene(scene, 4.0f / 3);
  const Drawn all = draw(scene, camera, wires(), 640, 480);
  RenderSettings settings = wires();
  settings.hidden_wire = true;
  const Drawn front = draw(scene, camera, settings, 640, 480);
  // About half of all edges face the camera.
  EXPECT_GT(front.count(), all.count() * 2 / 5);
  EXPECT_LT(front.count(), all.count() * 4 / 5);
}

TEST(Wireframe, NeverTheColourOfTheGround) {
  Square square;
  square.scene.materials[0].base_colour = glm::vec3(0.0f);
  EXPECT_GT(draw(square.scene, square.camera, wires()).count(), 200);
}

}  // namespace
}  // namespace kinescope
