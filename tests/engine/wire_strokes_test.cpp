// Edges of a scene as strokes, and what is hidden of them: against rays through every face.
#include "engine/wire_strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "engine/clip_line_homogeneous.h"
#include "engine/framing.h"
#include "engine/hidden_lines.h"
#include "engine/teapot.h"

namespace kinescope {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180;

Scene scene_of_mesh(Mesh mesh) {
  Scene scene;
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back({"", -1, glm::mat4(1.0f), {0}});
  return scene;
}

/// A cube from -1 to 1 whose six sides have corners of their own.
Mesh cube() {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        glm::vec3 p{0};
        p[axis] = side;
        p[(axis + 1) % 3] = static_cast<float>(u);
        p[(axis + 2) % 3] = static_cast<float>(v);
        mesh.positions.push_back(p);
      }
      for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
    }
  }
  return mesh;
}

Mesh random_triangles(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1, 1);
  Mesh mesh;
  for (int i = 0; i < 3 * count; ++i) {
    mesh.positions.emplace_back(place(random), place(random), place(random));
    mesh.indices.push_back(static_cast<std::uint32_t>(i));
  }
  return mesh;
}

TEST(WireScene, CornersAtOnePlaceAreOnePoint) {
  const WireScene wire = wire_scene(scene_of_mesh(cube()));
  EXPECT_EQ(wire.points.size(), 8u);
  EXPECT_EQ(wire.faces.size(), 12u);
  ASSERT_EQ(wire.edges.size(), 18u);  // and a diagonal a side
  int right = 0, flat = 0;
  for (const WireEdge& edge : wire.edges) {
    right += std::abs(edge.bend_rad - std::numbers::pi_v<float> / 2) < 1e-6f;
    flat += edge.bend_rad < 1e-6f;
    EXPECT_NE(edge.faces[1], WireEdge::kNone);
  }
  EXPECT_EQ(right, 12);
  EXPECT_EQ(flat, 6);
}

TEST(WireScene, EveryNodeOfAMeshIsDrawnAtItsPlace) {
  Scene scene = scene_of_mesh(cube());
  scene.nodes.push_back({"", -1, glm::translate(glm::mat4(1.0f), {2, 0, 0}), {0}});
  const WireScene wire = wire_scene(scene);
  EXPECT_EQ(wire.points.size(), 12u);  // one side is common to both
  EXPECT_EQ(wire.faces.size(), 24u);
  // The common side's edges and diagonal have more than two faces: whatever the crease, they are
  // drawn.
  EXPECT_EQ(std::count_if(wire.edges.begin(), wire.edges.end(),
                          [](const WireEdge& e) { return e.bend_rad > 3; }),
            5);
}

TEST(WireScene, BadTrianglesLeaveNoFaces) {
  Mesh mesh;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {nan, 0, 0}, {1e30f, 0, 0}, {-0.0f, 0, 0}};
  mesh.indices = {0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 5, 1, 0, 0, 0};
  const WireScene wire = wire_scene(scene_of_mesh(mesh));
  EXPECT_TRUE(wire.faces.empty());
  EXPECT_EQ(wire.edges.size(), 3u);  // of three corners in a row
  EXPECT_TRUE(wire_scene(Scene{}).edges.empty());
}

int count_strokes(const Scene& scene, const Camera& camera, bool hidden_removed, float crease_deg) {
  Workers workers(2);
  return static_cast<int>(
      wire_strokes(wire_scene(scene), camera, {hidden_removed, crease_deg * kDegree}, workers)
          .size());
}

TEST(WireStrokes, ACubeHasNineEdgesInSight) {
  const Scene scene = scene_of_mesh(cube());
  const Camera camera = frame_scene(scene, 1);
  EXPECT_EQ(count_strokes(scene, camera, false, 0), 18);
  EXPECT_EQ(count_strokes(scene, camera, false, 1), 12);
  EXPECT_EQ(count_strokes(scene, camera, true, 1), 9);
  EXPECT_EQ(count_strokes(scene, camera, true, 0), 12);
  // Edges that bend less than the crease: only the outline is left, hidden or not.
  EXPECT_EQ(count_strokes(scene, camera, false, 100), 6);
  EXPECT_EQ(count_strokes(scene, camera, true, 100), 6);
}

TEST(WireStrokes, AreWhereTheCameraSeesThem) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.indices = {0, 1, 2};
  Camera camera;  // at z = 5, a window of 2 x 2 at a distance of 1
  Workers workers(1);
  const auto strokes = wire_strokes(wire_scene(scene_of_mesh(mesh)), camera, {}, workers);
  ASSERT_EQ(strokes.size(), 3u);
  EXPECT_NEAR(glm::distance(strokes[0].from, {0, 0}), 0, 1e-12);
  EXPECT_NEAR(glm::distance(strokes[0].to, {0.2, 0}), 0, 1e-12);
  EXPECT_NEAR(glm::distance(strokes[1].to, {0, 0.2}), 0, 1e-12);
  // What leaves the view ends at its border; what lies behind the eye is not seen.
  camera.eye = {0, 0, 0.4f};
  const auto cut = wire_strokes(wire_scene(scene_of_mesh(mesh)), camera, {}, workers);
  ASSERT_EQ(cut.size(), 2u);
  EXPECT_NEAR(cut[0].to.x, 1, 1e-12);
  camera.eye = {0, 0, -0.5f};
  camera.look_at = {0, 0, -5};
  EXPECT_TRUE(wire_strokes(wire_scene(scene_of_mesh(mesh)), camera, {}, workers).empty());
}

/// A line from (-2, 0, 0) to (2, 0, 0) behind a square from -1 to 1 that stands at z = 1.
TEST(HiddenLines, PartsEndWhereTheFaceEnds) {
  Mesh mesh;
  mesh.positions = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, {-2, 0, 0}, {2, 0, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 3, 4, 5, 5};
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    Camera camera;
    camera.projection = projection;
    camera.window_min *= 3.0f, camera.window_max *= 3.0f;
    Workers workers(1);
    std::vector<WireStroke> strokes =
        wire_strokes(wire_scene(scene_of_mesh(mesh)), camera, {true, 0}, workers);
    std::erase_if(strokes, [](const WireStroke& s) { return s.from.y != 0 || s.to.y != 0; });
    ASSERT_EQ(strokes.size(), 2u);
    // The square is 4 away from the eye, the line 5.
    const bool parallel = projection == Projection::kOrthographic;
    EXPECT_NEAR(strokes[0].to.x, parallel ? -1.0 / 3 : -0.25 / 3, 1e-7);
    EXPECT_NEAR(strokes[1].from.x, parallel ? 1.0 / 3 : 0.25 / 3, 1e-7);
  }
}

/// Whether a point of the world is hidden, by a ray from the eye through all faces; unclear where
/// the ray passes an edge, or a face about as near as it counts.
enum class Seen { kSeen, kHidden, kUnclear };
Seen look(const WireScene& wire, const Camera& camera, const glm::dvec3& point,
          std::span<const int> own) {
  const bool parallel = camera.projection == Projection::kOrthographic;
  const glm::dvec3 sight = glm::dvec3(camera.look_at) - glm::dvec3(camera.eye);
  const double range = double{camera.far_plane} - double{camera.near_plane};
  const glm::dvec3 eye = parallel ? point - glm::normalize(sight) * range : glm::dvec3(camera.eye);
  Seen seen = Seen::kSeen;
  for (std::size_t f = 0; f < wire.faces.size(); ++f) {
    if (std::find(own.begin(), own.end(), static_cast<int>(f)) != own.end()) continue;
    const auto& t = wire.faces[f];
    const glm::dvec3 a = wire.points[t[0]];
    // eye + s (point - eye) = a + u (b - a) + v (c - a)
    const glm::dmat3 m(point - eye, a - wire.points[t[1]], a - wire.points[t[2]]);
    const glm::dvec3 suv = glm::inverse(m) * (a - eye);
    const double least = std::min({suv.y, suv.z, 1 - suv.y - suv.z});
    const double before = parallel ? 1 - suv.x : 1 / suv.x - 1;
    if (suv.x <= 0 || least < -1e-7 || before < 0) continue;
    if (least < 1e-7 || before < 1.1 * HiddenLines::kLeastBefore) {
      seen = Seen::kUnclear;
    } else {
      return Seen::kHidden;
    }
  }
  return seen;
}

struct Tally {
  int seen = 0, hidden = 0, wrong = 0;
};

/// Compares places along every edge.
Tally compare_with_rays(const Scene& scene, const Camera& camera) {
  const WireScene wire = wire_scene(scene);
  const glm::dmat4 clip =
      glm::dmat4(camera.clip_from_view()) * glm::dmat4(camera.view_from_world());
  const glm::dmat4 back = glm::inverse(clip);
  std::vector<glm::dvec4> points;
  for (const glm::dvec3& p : wire.points) points.push_back(clip * glm::dvec4(p, 1));
  const HiddenLines hidden(wire, camera, points);
  HiddenLines::Scratch scratch;
  Tally tally;
  for (const WireEdge& edge : wire.edges) {
    glm::dvec4 from = points[edge.a], to = points[edge.b];
    if (!clip_line(view_volume_planes(), from, to)) continue;
    std::vector<LinePart> visible;
    hidden.visible_parts(edge, from, to, scratch, visible);
    for (int i = 1; i < 16; ++i) {
      const double t = i / 16.0 + 0.001 * i;
      const glm::dvec4 world = back * (from + t * (to - from));
      const Seen want = look(wire, camera, glm::dvec3(world) / world.w, edge.faces);
      if (want == Seen::kUnclear) continue;
      const bool is_seen = std::any_of(visible.begin(), visible.end(), [&](const LinePart& part) {
        return part.from <= t && t <= part.to;
      });
      ++(want == Seen::kSeen ? tally.seen : tally.hidden);
      tally.wrong += is_seen != (want == Seen::kSeen);
    }
  }
  return tally;
}

TEST(HiddenLines, AgreeWithRaysOnFacesThatCrossEachOther) {
  const Scene scene = scene_of_mesh(random_triangles(120, 1));
  Camera camera = frame_scene(scene, 1);
  Tally tally = compare_with_rays(scene, camera);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(tally.seen, 500);
  EXPECT_GT(tally.hidden, 2000);
  camera.projection = Projection::kOrthographic;
  camera.window_min = {-1.5f, -1.5f}, camera.window_max = {1.5f, 1.5f};
  tally = compare_with_rays(scene, camera);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(std::min(tally.seen, tally.hidden), 500);
}

TEST(HiddenLines, AgreeWithRaysAmongFacesThatPassTheEye) {
  Camera camera;
  camera.eye = {0.1f, 0.2f, 0.1f};
  camera.look_at = {-1, 0, 0.3f};
  camera.near_plane = 1e-3f;
  camera.far_plane = 10;
  Tally all;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Tally tally = compare_with_rays(scene_of_mesh(random_triangles(12, seed)), camera);
    all.seen += tally.seen, all.hidden += tally.hidden, all.wrong += tally.wrong;
  }
  EXPECT_EQ(all.wrong, 0);
  EXPECT_GT(all.seen, 500);
  EXPECT_GT(all.hidden, 500);
}

TEST(HiddenLines, AgreeWithRaysOnASurface) {
  const Scene scene = scene_of_mesh(teapot_mesh(2));
  const Tally tally = compare_with_rays(scene, frame_scene(scene, 1));
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(std::min(tally.seen, tally.hidden), 1000);
}

TEST(WireStrokes, DoNotDependOnTheNumberOfWorkers) {
  const Scene scene = scene_of_mesh(teapot_mesh(4));
  const WireScene wire = wire_scene(scene);
  const Camera camera = frame_scene(scene, 1);
  Workers one(1), three(3);
  const auto a = wire_strokes(wire, camera, {true, 0}, one);
  const auto b = wire_strokes(wire, camera, {true, 0}, three);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].from, b[i].from);
    EXPECT_EQ(a[i].to, b[i].to);
  }
}

}  // namespace
}  // namespace kinescope
