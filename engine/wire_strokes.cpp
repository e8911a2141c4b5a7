#include "engine/wire_strokes.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <optional>

#include "engine/clip_line_homogeneous.h"
#include "engine/hidden_lines.h"

namespace kinescope {
namespace {

constexpr std::size_t kTaskEdges = 256;

std::vector<glm::dvec4> clip_points_of(const WireScene& scene, const Camera& camera) {
  const glm::dmat4 clip_from_world =
      glm::dmat4(camera.clip_from_view()) * glm::dmat4(camera.view_from_world());
  std::vector<glm::dvec4> points;
  points.reserve(scene.points.size());
  for (const glm::dvec3& p : scene.points) points.push_back(clip_from_world * glm::dvec4(p, 1));
  return points;
}

glm::dvec3 xyw(const glm::dvec4& p) { return {p.x, p.y, p.w}; }

class Drawer {
 public:
  Drawer(const WireScene& scene, const Camera& camera, const WireStyle& style)
      : scene_(scene), style_(style), points_(clip_points_of(scene, camera)) {
    if (style.hidden_removed) hidden_.emplace(scene, camera, points_);
  }

  void draw(const WireEdge& edge, HiddenLines::Scratch& scratch, std::vector<LinePart>& parts,
            std::vector<WireStroke>& strokes) const {
    if (edge.bend_rad < style_.crease_rad && !is_outline(edge)) return;
    glm::dvec4 from = points_[edge.a], to = points_[edge.b];
    if (!clip_line(planes_, from, to)) return;
    parts.clear();
    if (hidden_) {
      hidden_->visible_parts(edge, from, to, scratch, parts);
    } else {
      parts.push_back({});
    }
    const auto place = [&](double t) {
      const glm::dvec4 p = from + t * (to - from);
      return glm::dvec2(p) / p.w;
    };
    for (const LinePart& part : parts) strokes.push_back({place(part.from), place(part.to)});
  }

 private:
  /// Whether both faces lie on one side of the plane through the eye and the edge.
  bool is_outline(const WireEdge& edge) const {
    const glm::dvec3 plane = glm::cross(xyw(points_[edge.a]), xyw(points_[edge.b]));
    double sides = 1;
    for (const int face : edge.faces) {
      for (const std::uint32_t corner : scene_.faces[static_cast<std::size_t>(face)]) {
        if (corner != edge.a && corner != edge.b) sides *= glm::dot(plane, xyw(points_[corner]));
      }
    }
    return sides >= 0;
  }

  const WireScene& scene_;
  const WireStyle& style_;
  std::vector<glm::dvec4> points_;
  std::array<ClipPlane, 6> planes_ = view_volume_planes();
  std::optional<HiddenLines> hidden_;
};

}  // namespace

std::vector<WireStroke> wire_strokes(const WireScene& scene, const Camera& camera,
                                     const WireStyle& style, Workers& workers) {
  const Drawer drawer(scene, camera, style);
  const std::size_t tasks = (scene.edges.size() + kTaskEdges - 1) / kTaskEdges;
  std::vector<std::vector<WireStroke>> of_task(tasks);
  std::vector<HiddenLines::Scratch> scratches(static_cast<std::size_t>(workers.count()));
  workers.run(static_cast<int>(tasks), [&](int task, int worker) {
    const std::size_t begin = static_cast<std::size_t>(task) * kTaskEdges;
    const std::size_t end = std::min(scene.edges.size(), begin + kTaskEdges);
    std::vector<LinePart> parts;
    for (std::size_t i = begin; i < end; ++i) {
      drawer.draw(scene.edges[i], scratches[static_cast<std::size_t>(worker)], parts,
                  of_task[static_cast<std::size_t>(task)]);
    }
  });
  std::vector<WireStroke> strokes;
  for (const auto& some : of_task) strokes.insert(strokes.end(), some.begin(), some.end());
  return strokes;
}

}  // namespace kinescope
